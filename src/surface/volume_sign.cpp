#include <cmath>
#include <limits>

#include "nearwall/geometry/measures.h"
#include "surface/nesting.h"

namespace nearwall::surface {
namespace {

Vec3 absolute(const Vec3& a) { return {std::abs(a.x()), std::abs(a.y()), std::abs(a.z())}; }

/// The cross product with every term positive: a bound for its rounding.
Vec3 cross_of_sizes(const Vec3& a, const Vec3& b) {
  const Vec3 p = absolute(a), q = absolute(b);
  return {p.y() * q.z() + p.z() * q.y(), p.z() * q.x() + p.x() * q.z(), p.x() * q.y() + p.y() * q.x()};
}

}  // namespace

predicates::Sign volume_sign(const mesh::SurfaceMesh& surface, std::span<const FaceId> faces, double& volume) {
  // Each term suffers fewer than ten roundings, the compensated sum two more; the bound itself is rounded, too.
  constexpr double kRelativeError = 32 * std::numeric_limits<double>::epsilon();
  volume = 0;
  if (faces.empty()) return predicates::Sign::Zero;
  const Vec3 origin = surface.triangle(faces.front())[0];
  geometry::CompensatedSum six_volumes;
  double sizes = 0;
  for (const FaceId f : faces) {
    const auto corners = surface.triangle(f);
    const Vec3 a = corners[0] - origin, b = corners[1] - origin, c = corners[2] - origin;
    six_volumes.add(dot(a, cross(b, c)));
    sizes += dot(absolute(a), cross_of_sizes(b, c));
  }
  volume = six_volumes.value() / 6;
  if (std::abs(six_volumes.value()) > kRelativeError * sizes && std::isfinite(sizes)) {
    return volume > 0 ? predicates::Sign::Positive : predicates::Sign::Negative;
  }
  return exact_volume_sign(surface, faces);
}

}  // namespace nearwall::surface
