#include "nearwall/core/parallel.h"

#include <atomic>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace nearwall {
namespace {

TEST(ParallelFor, VisitsEveryIndexOnce) {
  std::vector<std::atomic<int>> visits(100001);
  parallel_for(visits.size(), [&](std::size_t i) { ++visits[i]; });
  for (const auto& n : visits) ASSERT_EQ(n, 1);
}

TEST(ParallelBlocks, CutsAtTheSamePlacesWhateverTheNumberOfThreads) {
  for (const int n_threads : {1, 2, 4}) {
    const ThreadLimit limit(n_threads);
    std::vector<int> begins(11, 0);
    parallel_blocks(1050, 100, [&](std::size_t begin, std::size_t end) {
      EXPECT_EQ(begin % 100, 0u);
      EXPECT_EQ(end, std::min<std::size_t>(begin + 100, 1050));
      begins[begin / 100] = 1;
    });
    EXPECT_EQ(begins, std::vector<int>(11, 1));
  }
}

TEST(ParallelFor, HandsExceptionsToTheCaller) {
  EXPECT_THROW(parallel_for(5000,
                            [](std::size_t i) {
                              if (i == 4321) throw std::runtime_error("here");
                            }),
               std::runtime_error);
}

TEST(ParallelFor, DoesNothingForNothing) {
  parallel_for(0, [](std::size_t) { FAIL(); });
}

}  // namespace
}  // namespace nearwall
