#include <algorithm>
#include <array>

#include "nearwall/predicates/cells.h"
#include "predicates/wedge_filter.h"

namespace nearwall::predicates {

namespace {

/// Levels looked at together: their flags stay in the innermost cache.
constexpr int kBlock = 256;

Vec3 point(const WedgeColumn& c, int line, int level) { return {c.x[line][level], c.y[line][level], c.z[line][level]}; }

/// Writes 1 for each wedge in [first, first + n) that plain doubles do not prove positive. A loop without branches over
/// separate arrays of coordinates.
void flag_unproven(const WedgeColumn& column, int first, int n, unsigned char* unproven) {
  const double *x0 = column.x[0] + first, *x1 = column.x[1] + first, *x2 = column.x[2] + first;
  const double *y0 = column.y[0] + first, *y1 = column.y[1] + first, *y2 = column.y[2] + first;
  const double *z0 = column.z[0] + first, *z1 = column.z[1] + first, *z2 = column.z[2] + first;
  for (int j = 0; j < n; ++j) {
    const WedgeEdges<double> e{{x1[j] - x0[j], y1[j] - y0[j], z1[j] - z0[j]},
                               {x2[j] - x0[j], y2[j] - y0[j], z2[j] - z0[j]},
                               {x1[j + 1] - x0[j + 1], y1[j + 1] - y0[j + 1], z1[j + 1] - z0[j + 1]},
                               {x2[j + 1] - x0[j + 1], y2[j + 1] - y0[j + 1], z2[j + 1] - z0[j + 1]},
                               {{{x0[j + 1] - x0[j], y0[j + 1] - y0[j], z0[j + 1] - z0[j]},
                                 {x1[j + 1] - x1[j], y1[j + 1] - y1[j], z1[j + 1] - z1[j]},
                                 {x2[j + 1] - x2[j], y2[j + 1] - y2[j], z2[j + 1] - z2[j]}}}};
    unproven[j] = is_surely_positive(e) ? 0 : 1;
  }
}

}  // namespace

int first_bad_wedge(const WedgeColumn& column, int n_levels) {
  std::array<unsigned char, kBlock> unproven;
  for (int first = 0; first < n_levels; first += kBlock) {
    const int n = std::min(kBlock, n_levels - first);
    flag_unproven(column, first, n, unproven.data());
    for (int j = 0; j < n; ++j) {
      if (unproven[j] == 0) continue;
      const int level = first + j;
      const std::array<Vec3, 6> p{point(column, 0, level),     point(column, 1, level),
                                  point(column, 2, level),     point(column, 0, level + 1),
                                  point(column, 1, level + 1), point(column, 2, level + 1)};
      if (wedge(p) != Positivity::Positive) return level;
    }
  }
  return n_levels;
}

}  // namespace nearwall::predicates
