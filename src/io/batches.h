#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "nearwall/core/parallel.h"

namespace nearwall::io {

/// Batches that are made at once before they are used.
inline constexpr std::size_t kBatchesAtOnce = 16;

/// Makes one thing of each batch, some at once, and uses them in their order: make(batch) → T runs on several threads,
/// then use(batch, T&) on one, batch after batch. Memory: kBatchesAtOnce things.
template <class Make, class Use>
void in_batches(std::size_t n_batches, const Make& make, const Use& use) {
  using Thing = decltype(make(std::size_t{0}));
  for (std::size_t first = 0; first < n_batches; first += kBatchesAtOnce) {
    const std::size_t n = std::min(kBatchesAtOnce, n_batches - first);
    std::vector<Thing> things(n);
    parallel_blocks(n, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) things[i] = make(first + i);
    });
    for (std::size_t i = 0; i < n; ++i) use(first + i, things[i]);
  }
}

}  // namespace nearwall::io
