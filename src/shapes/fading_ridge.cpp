#include <cmath>

#include "nearwall/geometry/angles.h"
#include "shapes/definition.h"
#include "shapes/revolution.h"
#include "shapes/sampling.h"

namespace nearwall::shapes {
namespace {

using geometry::kPi;

/// Default edge length, over the radius.
constexpr double kDefaultSize = 0.12;
/// Length of the nose, over the radius.
constexpr double kNose = 1.5;
/// How much lower the ridge of the convex body ends than it begins, over the radius.
constexpr double kFall = 0.15;

/// A section of the body: the hull of a circle and of a point above it, the ridge.
struct Drop {
  double x;
  double radius;  ///< of the circle
  double half;    ///< half the turn of the ridge; the hull leaves the circle at this angle from the top [rad]

  double straight() const { return radius * std::tan(half); }
  double outline() const { return 2 * (straight() + radius * (kPi - half)); }
  /// The point `length` along the outline from the ridge, first towards +y.
  Vec3 at(double length) const {
    const double side = 2 * length <= outline() ? 1 : -1;
    const double way = side > 0 ? length : outline() - length;
    if (way >= straight()) {
      const double angle = half + (way - straight()) / radius;
      return {x, side * radius * std::sin(angle), radius * std::cos(angle)};
    }
    return {x, side * way * std::cos(half), radius / std::cos(half) - way * std::sin(half)};
  }
};

Row add_section(SurfaceBuilder& b, const Drop& drop, double h) {
  if (drop.radius == 0) return {b.add_point({drop.x, 0, 0})};
  // Even, so that there is a point at the bottom as there is one at the ridge.
  const int n = 2 * n_segments(drop.outline() / 2, h, kMinCircle / 2);
  Row row;
  for (int i = 0; i < n; ++i) row.push_back(b.add_point(drop.at(drop.outline() * i / n)));
  return row;
}

mesh::SurfaceMesh make_fading_ridge(const Values& v, double size) {
  const double r = v["radius"], end = v["length"], half = geometry::to_radians(v["turn"]) / 2;
  const double h = std::min(size == 0 ? kDefaultSize * r : size, 2 * kPi * r / kMinRound);
  const auto drop_at = [&](double t) {
    const double angle = half * t;
    // Above a circle of constant radius the ridge rises ever faster: saddle ground. Or the ridge falls, and the circle
    // shrinks below it.
    const double radius = v.is_on("saddle") ? r : r * (1 - kFall * t * t) * std::cos(angle);
    return Drop{end * t, radius, angle};
  };
  SurfaceBuilder b;
  const PatchId body = b.patch("body");
  Row previous;
  const auto add = [&](const Drop& drop) {
    const Row next = add_section(b, drop, h);
    if (!previous.empty()) b.stitch_rings(body, next, previous);
    previous = next;
  };
  for (const ProfilePoint& p : elliptic_piece("", 0, kNose * r, r, kPi, kPi / 2, h).points) add({p.x, p.r, 0});
  const int n = n_segments(end, row_distance(h), 3);
  for (int i = 1; i <= n; ++i) add(drop_at(static_cast<double>(i) / n));
  b.fill(b.patch("base"), {reversed(previous)}, plane_chart({end, 0, 0}, {1, 0, 0}), h);
  return b.finish();
}

}  // namespace

std::vector<Definition> fading_shapes() {
  return {{{"fading-ridge",
            "smooth body from which a ridge rises little by little towards its flat base; patches body, base",
            {length("radius", 0.5, "radius where the ridge begins"), length("length", 2, "length of the ridge"),
             angle("turn", 120, 1, 160, "turn of the ridge at the base"),
             option("saddle", false, "1: the ridge ends on saddle ground; 0: on convex ground")}},
           make_fading_ridge}};
}

}  // namespace nearwall::shapes
