#include "nearwall/core/parallel.h"

#include <algorithm>
#include <optional>

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>

namespace nearwall {

struct ThreadLimit::Control {
  std::optional<oneapi::tbb::global_control> limit;
};

ThreadLimit::ThreadLimit(int n_threads) : control_(std::make_unique<Control>()) {
  if (n_threads > 0) {
    control_->limit.emplace(oneapi::tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(n_threads));
  }
}

ThreadLimit::~ThreadLimit() = default;

void parallel_blocks(std::size_t n, std::size_t block, const std::function<void(std::size_t, std::size_t)>& body) {
  if (n == 0) return;
  const std::size_t n_blocks = (n + block - 1) / block;
  oneapi::tbb::parallel_for(std::size_t{0}, n_blocks,
                            [&](std::size_t i) { body(i * block, std::min(n, (i + 1) * block)); });
}

}  // namespace nearwall
