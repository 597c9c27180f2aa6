#include <algorithm>

#include "nearwall/geometry/angles.h"
#include "shapes/definition.h"
#include "shapes/heading.h"
#include "shapes/revolution.h"
#include "shapes/sampling.h"

namespace nearwall::shapes {
namespace {

using geometry::kPi;

/// Default edge length of a duct, over its radius.
constexpr double kDefaultSize = 0.15;

/// A cross-section of a bent pipe: its centre and the direction of the pipe there. The pipe lies in the (x, z) plane.
struct Station {
  Vec3 centre;
  Vec3 along{1, 0, 0};

  /// Unit vector across the pipe, towards the centre of the bend.
  Vec3 inward() const { return across(along); }
};

/// Stations of a straight inlet, a bend towards +z, and a straight outlet, at most `step` apart at the outer side.
std::vector<Station> bend_stations(const Values& v, double step) {
  const double inlet = v["inlet-length"], outlet = v["outlet-length"], bend_radius = v["bend-radius"];
  const double turn = geometry::to_radians(v["angle"]);
  std::vector<Station> stations;
  for (const double x : uniform(-inlet, 0, n_segments(inlet, step))) stations.push_back({{x, 0, 0}, {1, 0, 0}});
  const int n = n_segments(turn * bend_radius, step, 3);
  for (int i = 1; i <= n; ++i) {
    const Vec3 along = heading_vector(turn * i / n);
    stations.push_back({{bend_radius * along.z(), 0, bend_radius * (1 - along.x())}, along});
  }
  const Station end = stations.back();
  const std::vector<double> way = uniform(0, outlet, n_segments(outlet, step));
  for (std::size_t i = 1; i < way.size(); ++i) stations.push_back({end.centre + end.along * way[i], end.along});
  return stations;
}

mesh::SurfaceMesh make_bend(const Values& v, double size) {
  const double r = v["radius"];
  require(r < v["bend-radius"], "radius of the pipe must be smaller than bend-radius");
  const double h = size == 0 ? kDefaultSize * r : std::min(size, 2 * kPi * r / kMinRound);
  const std::vector<Station> stations = bend_stations(v, row_distance(h));

  SurfaceBuilder builder;
  const int n = n_on_circle(r, h);
  int k = 0;
  const auto circle = [&](const Station& s, double radius) {
    if (radius == 0) return Row{builder.add_point(s.centre)};
    const double phase = k++ % 2 == 0 ? 0 : 0.5;
    const int count = radius == r ? n : n_on_circle(radius, h);
    return add_circle(builder, s.centre, Vec3(0, radius, 0), s.inward() * radius, count, phase);
  };
  // The inlet's disc from its middle out, the wall downstream, the outlet's disc back to its middle.
  const std::vector<double> radii = uniform(0, r, n_segments(r, row_distance(h)));
  Row previous = circle(stations.front(), 0);
  const auto continue_to = [&](const char* patch, const Station& s, double radius) {
    const Row next = circle(s, radius);
    builder.stitch_rings(builder.patch(patch), previous, next);
    previous = next;
  };
  for (std::size_t i = 1; i < radii.size(); ++i) continue_to("inlet", stations.front(), radii[i]);
  for (std::size_t i = 1; i < stations.size(); ++i) continue_to("wall", stations[i], r);
  for (std::size_t i = radii.size() - 1; i-- > 0;) continue_to("outlet", stations.back(), radii[i]);
  return builder.finish();
}

}  // namespace

std::vector<Definition> duct_shapes() {
  return {
      {{"bend",
        "lumen of a bent pipe with straight inlet and outlet; patches inlet, wall, outlet",
        {length("radius", 0.5, "radius of the pipe"), length("bend-radius", 1.5, "radius of the bend's centre line"),
         angle("angle", 90, 5, 180, "turn of the bend"), length("inlet-length", 1, "straight length before the bend"),
         length("outlet-length", 2, "straight length after the bend")}},
       make_bend},
      vessel()};
}

}  // namespace nearwall::shapes
