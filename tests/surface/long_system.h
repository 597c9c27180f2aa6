#pragma once

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace nearwall {

/// Linear system in long double: rows of coefficients with the right-hand side as their last entry.
using LongSystem = std::vector<std::vector<long double>>;

/// Solution by Gaussian elimination with row pivoting.
inline std::vector<long double> solved(LongSystem rows) {
  const std::size_t n = rows.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k; i < n; ++i) {
      if (std::abs(rows[i][k]) > std::abs(rows[pivot][k])) pivot = i;
    }
    std::swap(rows[k], rows[pivot]);
    for (std::size_t i = k + 1; i < n; ++i) {
      const long double factor = rows[i][k] / rows[k][k];
      for (std::size_t j = k; j <= n; ++j) rows[i][j] -= factor * rows[k][j];
    }
  }
  std::vector<long double> x(n);
  for (std::size_t k = n; k-- > 0;) {
    x[k] = rows[k][n];
    for (std::size_t j = k + 1; j < n; ++j) x[k] -= rows[k][j] * x[j];
    x[k] /= rows[k][k];
  }
  return x;
}

}  // namespace nearwall
