#include "merit.h"

#include <algorithm>

#include "swept_limit.h"

namespace nearwall::layers {

namespace {

/// The first step of a line that starts late, in first heights: the first two of the default growth. Of a size is
/// enough to choose by.
constexpr double kLateStep = 2.2;

}  // namespace

std::array<Vec3, 3> tops_of(const LinePlan& plan, const VertexField& field, const Wall& wall, FaceId f, double height) {
  std::array<Vec3, 3> tops;
  for (std::size_t k = 0; k < 3; ++k) {
    const LineId line = plan.front.faces[FrontFaceId(f.index())].lines[k];
    tops[k] = plan.offset(line, height * field.thickness[wall.surface.faces[f][k]]);
  }
  return tops;
}

double merit(const Wall& wall, const LinePlan& plan, const VertexField& field, const IdVector<VertexId, double>& asked,
             FaceId f, double height) {
  const Vec3& normal = wall.features.face_normal[f];
  const std::array<Vec3, 3> x = wall.surface.triangle(f), tops = tops_of(plan, field, wall, f, height);
  const double limit = swept_limit(x, tops);
  if (!(limit > 0)) return 0;
  const std::array<double, 3> shares = shares_kept(x, tops, limit);
  std::array<double, 3> wanted{}, kept{}, first{};
  for (std::size_t k = 0; k < 3; ++k) {
    const VertexId v = wall.surface.faces[f][k];
    const LineId line = plan.front.faces[FrontFaceId(f.index())].lines[k];
    wanted[k] = height * asked[v];
    kept[k] = shares[k] * dot(tops[k], normal);
    first[k] = dot(plan.foot(line), normal) * (plan.start[v] > 0 ? kLateStep : 1.0);
  }
  const auto sum = [](const std::array<double, 3>& a) { return sum3(a[0], a[1], a[2]); };
  const double first_height = sum(first) / 3;
  if (!(sum(wanted) > 0) || !(first_height > 0)) return 0;
  return std::clamp(sum(kept) / sum(wanted), 0.0, 1.0) * std::min(first_height, 1 / first_height);
}

}  // namespace nearwall::layers
