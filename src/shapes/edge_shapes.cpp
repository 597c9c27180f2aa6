#include <algorithm>
#include <array>
#include <cmath>

#include "nearwall/geometry/angles.h"
#include "shapes/definition.h"
#include "shapes/prism.h"
#include "shapes/sampling.h"

namespace nearwall::shapes {
namespace {

using geometry::to_radians;

/// Default edge length, over the shortest edge that is not thin on purpose.
constexpr double kDefaultSize = 0.1;

double edge_size(double size, double shortest) { return size == 0 ? kDefaultSize * shortest : size; }

/// Adds a flat face and its mirror image below z = 0.
void add_twin_faces(SurfaceBuilder& b, const std::vector<VertexId>& upper, const std::vector<VertexId>& lower,
                    double h) {
  add_flat_face(b, "upper", upper, h);
  add_flat_face(b, "lower", reversed(lower), h);
}

mesh::SurfaceMesh make_knife_plate(const Values& v, double size) {
  const double x = v["length"] / 2, y = v["width"] / 2;
  require(y <= x, "width of the plate must not be larger than its length");
  const double h = edge_size(size, 2 * y), z = y * std::tan(to_radians(v["angle"]) / 2);
  SurfaceBuilder b;
  const std::array<VertexId, 4> rim = {b.add_point({-x, -y, 0}), b.add_point({x, -y, 0}), b.add_point({x, y, 0}),
                                       b.add_point({-x, y, 0})};
  // On each side a roof, hipped at all four edges; a square plate's has no crest but a peak.
  const auto crest = [&](double height) {
    const VertexId back = b.add_point({x - y, 0, height});
    return std::array{x == y ? back : b.add_point({y - x, 0, height}), back};
  };
  const auto high = crest(z), low = crest(-z);
  const auto along = [&](std::size_t i, const std::array<VertexId, 2>& c, bool is_front) {
    std::vector<VertexId> face{rim[i], rim[(i + 1) % 4], c[is_front ? 1 : 0]};
    if (c[0] != c[1]) face.push_back(c[is_front ? 0 : 1]);
    return face;
  };
  add_twin_faces(b, along(0, high, true), along(0, low, true), h);
  add_twin_faces(b, {rim[1], rim[2], high[1]}, {rim[1], rim[2], low[1]}, h);
  add_twin_faces(b, along(2, high, false), along(2, low, false), h);
  add_twin_faces(b, {rim[3], rim[0], high[0]}, {rim[3], rim[0], low[0]}, h);
  return b.finish();
}

mesh::SurfaceMesh make_delta_wing(const Values& v, double size) {
  const double x = v["length"], y = x * std::tan(to_radians(v["apex-angle"]) / 2);
  // Equal slopes from all edges meet above the centre of the inscribed circle.
  const double inscribed = x * y / (y + std::sqrt(x * x + y * y)), z = inscribed * std::tan(to_radians(v["angle"]) / 2);
  const double h = edge_size(size, std::min(x, 2 * y));
  SurfaceBuilder b;
  const std::array<VertexId, 3> rim = {b.add_point({0, 0, 0}), b.add_point({x, -y, 0}), b.add_point({x, y, 0})};
  const VertexId high = b.add_point({x - inscribed, 0, z}), low = b.add_point({x - inscribed, 0, -z});
  for (std::size_t i = 0; i < 3; ++i) {
    const VertexId from = rim[i], to = rim[(i + 1) % 3];
    add_twin_faces(b, {from, to, high}, {from, to, low}, h);
  }
  return b.finish();
}

mesh::SurfaceMesh make_kinked_wing(const Values& v, double size) {
  constexpr int kPanels = 3;
  const double chord = v["chord"], span = v["span"], panel = span / kPanels;
  const double z = chord * std::tan(to_radians(v["angle"]) / 2), sweep = panel * std::tan(to_radians(v["kink"]));
  const double h = edge_size(size, std::min(chord, panel));
  SurfaceBuilder b;
  std::vector<VertexId> high, low, trailing;
  for (int i = 0; i <= kPanels; ++i) {
    const double y = panel * i - span / 2;
    high.push_back(b.add_point({0, y, z}));
    low.push_back(b.add_point({0, y, -z}));
    trailing.push_back(b.add_point({chord + (i % 2 == 0 ? 0 : sweep), y, 0}));
  }
  for (std::size_t i = 0; i + 1 < high.size(); ++i) {
    const Vec3 a = b.point(trailing[i]), c = b.point(trailing[i + 1]);
    // Straight from the front edge to the trailing edge in each section.
    const auto panel_chart = [&](double rise) {
      return Chart{[](const Vec3& p) {
                     return Point2{p.x(), p.y()};
                   },
                   [=](const Point2& q) {
                     const double end = a.x() + (c.x() - a.x()) * ((q.v - a.y()) / (c.y() - a.y()));
                     return Vec3(q.u, q.v, rise * (1 - q.u / end));
                   }};
    };
    const auto loop = [&](const std::vector<VertexId>& front) {
      return loop_of({b.edge(front[i], trailing[i], h), b.edge(trailing[i], trailing[i + 1], h),
                      b.edge(trailing[i + 1], front[i + 1], h), b.edge(front[i + 1], front[i], h)});
    };
    b.fill(b.patch("upper"), {loop(high)}, panel_chart(z), h);
    b.fill(b.patch("lower"), {reversed(loop(low))}, panel_chart(-z), h);
  }
  std::vector<VertexId> front = high;
  front.insert(front.end(), low.rbegin(), low.rend());
  add_flat_face(b, "front", front, h);
  add_flat_face(b, "side-left", {low.front(), trailing.front(), high.front()}, h);
  add_flat_face(b, "side-right", {low.back(), high.back(), trailing.back()}, h);
  return b.finish();
}

/// A block whose top falls to both sides of its middle line at one end and rises at the other.
struct TwistedRoof {
  double x, y, z;  ///< half length, half width, height of the middle line
  double slope;    ///< of the roof at its ends [rad]

  double height(double at_x, double at_y) const { return z + std::abs(at_y) * std::tan(slope * (at_x / x)); }
};

/// Adds the sides below the rims from the front to the back, and the bottom.
void add_block_below(SurfaceBuilder& b, const Row& right, const Row& middle, const Row& left, const TwistedRoof& roof,
                     double h) {
  const auto foot = [&](double at_x, double at_y) { return b.add_point({at_x, at_y, 0}); };
  const VertexId front_right = foot(-roof.x, -roof.y), back_right = foot(roof.x, -roof.y);
  const VertexId back_left = foot(roof.x, roof.y), front_left = foot(-roof.x, roof.y);
  const auto side = [&](VertexId from, VertexId to, const Row& rim, const Vec3& outward) {
    b.fill(b.patch("side"),
           {loop_of({b.edge(from, to, h), b.edge(to, rim.back(), h), reversed(rim), b.edge(rim.front(), from, h)})},
           plane_chart(b.point(from), outward), h);
  };
  side(front_right, back_right, right, {0, -1, 0});
  side(back_left, front_left, reversed(left), {0, 1, 0});
  add_flat_face(b, "end", {back_right, back_left, left.back(), middle.back(), right.back()}, h);
  add_flat_face(b, "end", {front_left, front_right, right.front(), middle.front(), left.front()}, h);
  add_flat_face(b, "bottom", {front_right, front_left, back_left, back_right}, h);
}

mesh::SurfaceMesh make_twisted_roof(const Values& v, double size) {
  const TwistedRoof roof{v["length"] / 2, v["width"] / 2, v["height"], to_radians(v["turn"]) / 2};
  require(roof.height(-roof.x, roof.y) > 0, "height must be larger: the roof falls below the bottom");
  const double h = edge_size(size, std::min({2 * roof.x, 2 * roof.y, roof.z}));
  SurfaceBuilder b;
  const auto rim = [&](double at_y) {
    const auto at = [&](double t) {
      const double at_x = t == 1 ? roof.x : roof.x * (2 * t - 1);
      return Vec3(at_x, at_y, roof.height(at_x, at_y));
    };
    Row row;
    for (const double t : graded_parameters(at, {.size = h, .minimum = 2})) row.push_back(b.add_point(at(t)));
    return row;
  };
  const Row right = rim(-roof.y), left = rim(roof.y);
  const VertexId front = b.add_point({-roof.x, 0, roof.z}), back = b.add_point({roof.x, 0, roof.z});
  const Row middle = b.edge(front, back, h);
  const Chart from_above{[](const Vec3& p) {
                           return Point2{p.x(), p.y()};
                         },
                         [=](const Point2& q) { return Vec3(q.u, q.v, roof.height(q.u, q.v)); }};
  b.fill(b.patch("roof"),
         {loop_of({right, b.edge(right.back(), back, h), reversed(middle), b.edge(front, right.front(), h)})},
         from_above, h);
  b.fill(b.patch("roof"),
         {loop_of({middle, b.edge(back, left.back(), h), reversed(left), b.edge(left.front(), front, h)})}, from_above,
         h);
  add_block_below(b, right, middle, left, roof, h);
  return b.finish();
}

mesh::SurfaceMesh make_kinked_roof(const Values& v, double size) {
  const TwistedRoof roof{v["length"] / 2, v["width"] / 2, v["height"], to_radians(v["turn"]) / 2};
  require(roof.y < roof.x, "width of the roof must be smaller than its length");
  require(roof.height(-roof.x, roof.y) > 0, "height must be larger: the roof falls below the bottom");
  const double h = edge_size(size, std::min(2 * roof.y, roof.z));
  SurfaceBuilder b;
  const double low = roof.height(-roof.x, roof.y), high = roof.height(roof.x, roof.y);
  // Between the two halves one triangle on each side, from the middle to a steep piece of the rim.
  const auto rim = [&](double at_y) {
    return std::array{b.add_point({-roof.x, at_y, low}), b.add_point({-roof.y, at_y, low}),
                      b.add_point({roof.y, at_y, high}), b.add_point({roof.x, at_y, high})};
  };
  const auto right = rim(-roof.y), left = rim(roof.y);
  const VertexId front = b.add_point({-roof.x, 0, roof.z}), centre = b.add_point({0, 0, roof.z}),
                 back = b.add_point({roof.x, 0, roof.z});
  const auto add_half = [&](const std::array<VertexId, 4>& r, bool is_left) {
    const auto face = [&](std::vector<VertexId> corners) {
      add_flat_face(b, "roof", is_left ? reversed(std::move(corners)) : corners, h);
    };
    face({r[0], r[1], centre, front});
    face({r[1], r[2], centre});
    face({r[2], r[3], back, centre});
  };
  add_half(right, false);
  add_half(left, true);
  const auto row = [&](const std::array<VertexId, 4>& r) {
    return joined({b.edge(r[0], r[1], h), b.edge(r[1], r[2], h), b.edge(r[2], r[3], h)});
  };
  add_block_below(b, row(right), {front, back}, row(left), roof, h);
  return b.finish();
}

std::vector<ShapeParameter> roof_parameters(double turn, double largest_turn) {
  return {
      length("length", 2, "extent along x"), length("width", 1, "extent along y"),
      length("height", 1.2, "height of the ridge"),
      angle("turn", turn, 1, largest_turn, "turn of the ridge at both ends, convex at one and concave at the other")};
}

}  // namespace

std::vector<Definition> edge_shapes() {
  return {
      {{"knife-plate",
        "thin plate, thickest in the middle, with knife edges all round; patches upper, lower",
        {length("length", 1, "extent along x"), length("width", 1, "extent along y"),
         angle("angle", 10, 0.5, 120, "interior angle at the edges")}},
       make_knife_plate},
      {{"delta-wing",
        "triangle with knife edges all round, its apex at the origin; patches upper, lower",
        {length("length", 1, "extent along x"), angle("apex-angle", 35, 2, 120, "angle between the edges at the apex"),
         angle("angle", 10, 0.5, 120, "interior angle at the edges")}},
       make_delta_wing},
      {{"kinked-wing",
        "wedge whose sharp trailing edge bends in the plane, out and in; patches upper, lower, front, side-left, "
        "side-right",
        {length("chord", 1, "shortest chord"), length("span", 2, "extent along y"),
         angle("angle", 10, 0.5, 90, "interior angle at the trailing edge where the chord is shortest"),
         angle("kink", 30, 0, 75, "sweep of each third of the trailing edge, to and fro")}},
       make_kinked_wing},
      {{"twisted-roof",
        "block with a ridge that turns from convex to concave along its way; patches roof, side, end, bottom",
        roof_parameters(120, 160)},
       make_twisted_roof},
      {{"kinked-roof",
        "block with a ridge that is convex up to its middle and concave from there; patches roof, side, end, bottom",
        roof_parameters(56, 120)},
       make_kinked_roof},
  };
}

}  // namespace nearwall::shapes
