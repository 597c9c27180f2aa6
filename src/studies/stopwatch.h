#pragma once

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <vector>

namespace nearwall::studies {

/// Processor time that `work` takes on one thread [s]: what else runs on the machine does not count.
template <class Work>
double seconds_of(Work&& work) {
  const std::clock_t begin = std::clock();
  work();
  return static_cast<double>(std::clock() - begin) / static_cast<double>(CLOCKS_PER_SEC);
}

/// \param values  at least one
inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace nearwall::studies
