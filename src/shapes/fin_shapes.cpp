#include <algorithm>
#include <array>
#include <cmath>

#include "nearwall/geometry/angles.h"
#include "shapes/definition.h"
#include "shapes/prism.h"
#include "shapes/revolution.h"
#include "shapes/sampling.h"

namespace nearwall::shapes {
namespace {

using geometry::kPi;
using geometry::to_radians;

/// Default edge length, over the chord.
constexpr double kDefaultSize = 0.1;

/// The four corners of a fin's section, sharp at both ends of the chord, from the leading edge on.
std::array<Vec3, 4> section(double chord, double angle) {
  const double x = chord / 2, y = x * std::tan(angle / 2);
  return {Vec3(-x, 0, 0), Vec3(0, -y, 0), Vec3(x, 0, 0), Vec3(0, y, 0)};
}

mesh::SurfaceMesh make_fin_on_plate(const Values& v, double size) {
  const double chord = v["chord"], z = v["height"], floor = v["plate-length"] / 2, thickness = v["plate-thickness"];
  require(chord < 2 * floor, "chord of the fin must be smaller than plate-length");
  const double h = size == 0 ? kDefaultSize * chord : size;
  SurfaceBuilder b;
  std::vector<VertexId> foot, top;
  for (const Vec3& p : section(chord, to_radians(v["angle"]))) {
    foot.push_back(b.add_point(p));
    top.push_back(b.add_point(p + Vec3(z * std::tan(to_radians(v["sweep"])), 0, z)));
  }
  const auto square = [&](double at_z) {
    return std::vector{b.add_point({-floor, -floor, at_z}), b.add_point({floor, -floor, at_z}),
                       b.add_point({floor, floor, at_z}), b.add_point({-floor, floor, at_z})};
  };
  const std::vector<VertexId> rim = square(0), bottom = square(-thickness);
  const auto loop = [&](const std::vector<VertexId>& c) {
    return loop_of({b.edge(c[0], c[1], h), b.edge(c[1], c[2], h), b.edge(c[2], c[3], h), b.edge(c[3], c[0], h)});
  };
  b.fill(b.patch("plate"), {loop(rim), loop(foot)}, plane_chart({0, 0, 0}, {0, 0, 1}), h);
  const auto walls = [&](const char* patch, const std::vector<VertexId>& low, const std::vector<VertexId>& high) {
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t j = (i + 1) % 4;
      add_flat_face(b, patch, {low[i], low[j], high[j], high[i]}, h);
    }
  };
  walls("fin", foot, top);
  add_flat_face(b, "fin-tip", top, h);
  walls("plate-side", bottom, rim);
  add_flat_face(b, "plate-bottom", reversed(bottom), h);
  return b.finish();
}

/// Flattens the sphere round its pole at +z: distances from there are kept.
Chart polar_chart(double r) {
  return {[r](const Vec3& p) {
            const double from_axis = std::hypot(p.x(), p.y());
            if (from_axis == 0) return Point2{0, 0};
            const double distance = r * std::atan2(from_axis, p.z());
            return Point2{distance * (p.x() / from_axis), distance * (p.y() / from_axis)};
          },
          [r](const Point2& q) {
            const double distance = std::hypot(q.u, q.v);
            if (distance == 0) return Vec3(0, 0, r);
            const double from_axis = r * std::sin(distance / r);
            return Vec3(from_axis * (q.u / distance), from_axis * (q.v / distance), r * std::cos(distance / r));
          }};
}

mesh::SurfaceMesh make_fin_on_sphere(const Values& v, double size) {
  /// Angle from the pole up to which the sphere is flattened, and the longest chord that leaves room round the fin.
  constexpr double kCap = kPi / 3, kLongestChord = 1.2;
  const double r = v["radius"], chord = v["chord"], z = r + v["height"];
  require(chord <= kLongestChord * r, "chord of the fin must be at most 1.2 times the radius");
  const double h = std::min(size == 0 ? kDefaultSize * chord : size, 2 * kPi * r / kMinRound);
  SurfaceBuilder b;
  const auto on_sphere = [r](const Vec3& p) {
    return Vec3(p.x(), p.y(), std::sqrt(r * r - p.x() * p.x() - p.y() * p.y()));
  };
  const auto corners = section(chord, to_radians(v["angle"]));
  std::vector<VertexId> foot, top;
  for (const Vec3& p : corners) {
    foot.push_back(b.add_point(on_sphere(p)));
    top.push_back(b.add_point({p.x(), p.y(), z}));
  }
  std::vector<Row> joint;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t j = (i + 1) % 4;
    const auto at = [&](double t) { return on_sphere(corners[i] + (corners[j] - corners[i]) * t); };
    const auto t = graded_parameters(at, {.size = h});
    Row row{foot[i]};
    for (std::size_t k = 1; k + 1 < t.size(); ++k) row.push_back(b.add_point(at(t[k])));
    row.push_back(foot[j]);
    const Vec3 along = corners[j] - corners[i];
    b.fill(b.patch("fin"),
           {loop_of({row, b.edge(foot[j], top[j], h), b.edge(top[j], top[i], h), b.edge(top[i], foot[i], h)})},
           plane_chart(corners[i], {along.y(), -along.x(), 0}), h);
    joint.push_back(row);
  }
  add_flat_face(b, "fin-tip", top, h);

  const auto ring = [&](double angle, double phase) {
    const double radius = r * std::sin(angle);
    return add_circle(b, {0, 0, r * std::cos(angle)}, {radius, 0, 0}, {0, radius, 0}, n_on_circle(radius, h), phase);
  };
  const PatchId sphere = b.patch("sphere");
  Row upper = ring(kCap, 0);
  b.fill(sphere, {upper, loop_of(joint)}, polar_chart(r), h);
  const int n = n_segments(r * (kPi - kCap), row_distance(h), 3);
  for (int i = 1; i <= n; ++i) {
    const Row lower = i == n ? Row{b.add_point({0, 0, -r})} : ring(kCap + (kPi - kCap) * i / n, i % 2 == 0 ? 0 : 0.5);
    b.stitch_rings(sphere, lower, upper);
    upper = lower;
  }
  return b.finish();
}

}  // namespace

std::vector<Definition> fin_shapes() {
  return {
      {{"fin-on-plate",
        "fin with sharp leading and trailing edges standing on a plate, one body; patches fin, fin-tip, plate, "
        "plate-side, plate-bottom",
        {length("chord", 1, "chord of the fin, along x"), length("height", 0.6, "height of the fin"),
         angle("angle", 10, 0.5, 120, "interior angle at both edges of the fin"),
         angle("sweep", 30, -70, 70, "lean of the fin downstream"),
         length("plate-length", 3, "edge of the square plate"),
         length("plate-thickness", 0.2, "thickness of the plate")}},
       make_fin_on_plate},
      {{"fin-on-sphere",
        "fin with sharp leading and trailing edges standing on a sphere, one body; patches fin, fin-tip, sphere",
        {length("radius", 1, "radius of the sphere"), length("chord", 0.8, "chord of the fin, along x"),
         length("height", 0.4, "height of the fin over the top of the sphere"),
         angle("angle", 10, 0.5, 90, "interior angle at both edges of the fin")}},
       make_fin_on_sphere},
  };
}

}  // namespace nearwall::shapes
