#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace nearwall {

/// Limits the threads that nearwall uses while it lives.
class ThreadLimit {
 public:
  /// \param n_threads  at least 1; 0: as many as the machine has
  explicit ThreadLimit(int n_threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  struct Control;
  std::unique_ptr<Control> control_;
};

/// Calls `body(begin, end)` for consecutive blocks of [0, n), on several threads. Blocks are cut at multiples of
/// `block` whatever the number of threads, so per-block results (sums, first failures) can be combined in block order
/// to the same bits at any number of threads. An exception thrown by `body` reaches the caller.
void parallel_blocks(std::size_t n, std::size_t block, const std::function<void(std::size_t, std::size_t)>& body);

/// Calls `body(i)` for each i in [0, n), on several threads. `body` writes only what belongs to i.
template <class Body>
void parallel_for(std::size_t n, Body&& body) {
  constexpr std::size_t kBlock = 1024;
  parallel_blocks(n, kBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) body(i);
  });
}

}  // namespace nearwall
