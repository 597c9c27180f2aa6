#include <algorithm>
#include <array>
#include <cstring>

#include "nearwall/predicates/cells.h"
#include "predicates/cell_filters.h"

namespace nearwall::predicates {

namespace {

/// Neighbouring levels, tested at once.
constexpr int kLanes = 2;
using Pack [[gnu::vector_size(kLanes * sizeof(double))]] = double;

Vector<Pack> load(const WedgeColumn& c, int line, int level) {
  Vector<Pack> p;
  std::memcpy(&p.x, c.x[line] + level, sizeof(Pack));
  std::memcpy(&p.y, c.y[line] + level, sizeof(Pack));
  std::memcpy(&p.z, c.z[line] + level, sizeof(Pack));
  return p;
}

Vector<Pack> operator-(const Vector<Pack>& a, const Vector<Pack>& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

/// Whether doubles prove the wedges at the levels first, first + 1, ... of one pack positive.
bool are_surely_positive(const WedgeColumn& c, int first) {
  const Vector<Pack> a0 = load(c, 0, first), a1 = load(c, 1, first), a2 = load(c, 2, first);
  const Vector<Pack> b0 = load(c, 0, first + 1), b1 = load(c, 1, first + 1), b2 = load(c, 2, first + 1);
  const auto mask = is_surely_positive<Pack>({a1 - a0, a2 - a0, b1 - b0, b2 - b0, {b0 - a0, b1 - a1, b2 - a2}});
  bool all = true;
  for (int lane = 0; lane < kLanes; ++lane) all &= mask[lane] != 0;
  return all;
}

bool is_positive_at(const WedgeColumn& c, int level) {
  std::array<Vec3, 6> p;
  for (int i = 0; i < 6; ++i) {
    const int line = i % 3, at = level + i / 3;
    p[i] = {c.x[line][at], c.y[line][at], c.z[line][at]};
  }
  return wedge(p) == Positivity::Positive;
}

}  // namespace

int first_bad_wedge(const WedgeColumn& column, int n_levels) {
  for (int first = 0; first < n_levels; first += kLanes) {
    const int end = std::min(first + kLanes, n_levels);
    if (end - first == kLanes && are_surely_positive(column, first)) continue;
    for (int level = first; level < end; ++level) {
      if (!is_positive_at(column, level)) return level;
    }
  }
  return n_levels;
}

}  // namespace nearwall::predicates
