#include <algorithm>
#include <cmath>

#include "nearwall/geometry/angles.h"
#include "shapes/definition.h"
#include "shapes/prism.h"
#include "shapes/sampling.h"

namespace nearwall::shapes {
namespace {

/// Default edge length of blocks, over their shortest edge that is not thin on purpose.
constexpr double kDefaultSize = 0.1;
/// The same for thin plates, at least.
constexpr double kThinnestSize = 0.02;

double block_size(double size, double shortest) { return size == 0 ? kDefaultSize * shortest : size; }

mesh::SurfaceMesh make_box(double x, double y, double z, double size) {
  SurfaceBuilder builder;
  add_box(builder, {-x / 2, -y / 2, -z / 2}, {x / 2, y / 2, z / 2}, "", block_size(size, std::min({x, y, z})));
  return builder.finish();
}

mesh::SurfaceMesh make_cube(const Values& v, double size) { return make_box(v["edge"], v["edge"], v["edge"], size); }

mesh::SurfaceMesh make_box(const Values& v, double size) {
  return make_box(v["length"], v["width"], v["height"], size);
}

/// Prism between the sides y = ±width / 2.
mesh::SurfaceMesh make_prism(const std::vector<PrismCorner>& polygon, double width, double size) {
  SurfaceBuilder builder;
  add_prism(builder, polygon, -width / 2, width / 2, "side-left", "side-right", size);
  return builder.finish();
}

mesh::SurfaceMesh make_plate(const Values& v, double size) {
  const double x = v["length"], y = v["width"], z = v["thickness"] / 2;
  // Two triangles across the rim are as wide as they are high, unless there would be too many of them.
  const double shortest = std::min(x, y);
  const double h = size == 0 ? shortest * std::clamp(2 * z / shortest, kThinnestSize, kDefaultSize) : size;
  return make_prism({{0, -z, "lower"}, {x, -z, "trailing-edge"}, {x, z, "upper"}, {0, z, "leading-edge"}}, y, h);
}

mesh::SurfaceMesh make_wedge(const Values& v, double size) {
  const double x = v["length"], z = x * std::tan(geometry::to_radians(v["angle"]) / 2);
  return make_prism({{0, -z, "lower"}, {x, 0, "upper"}, {0, z, "front"}}, v["width"],
                    block_size(size, std::min(x, v["width"])));
}

mesh::SurfaceMesh make_step(const Values& v, double size) {
  const double x = v["length"], z = v["height"], s = v["step-height"], at = v["step-position"];
  require(s < z, "step-height must be smaller than the height of the block");
  require(at < x, "step-position must be smaller than the length of the block");
  return make_prism(
      {{0, 0, "bottom"}, {x, 0, "back"}, {x, z - s, "lower"}, {at, z - s, "step"}, {at, z, "upper"}, {0, z, "front"}},
      v["width"], block_size(size, std::min({x, z, v["width"]})));
}

mesh::SurfaceMesh make_notch(const Values& v, double size) {
  const double x = v["length"] / 2, z = v["height"], d = v["depth"];
  const double half = d * std::tan(geometry::to_radians(v["angle"]) / 2);
  require(d < z, "depth of the notch must be smaller than the height of the block");
  require(half < x, "the notch is wider than the block: give a smaller angle or depth, or a larger length");
  return make_prism({{-x, 0, "bottom"},
                     {x, 0, "back"},
                     {x, z, "top"},
                     {half, z, "notch"},
                     {0, z - d, "notch"},
                     {-half, z, "top"},
                     {-x, z, "front"}},
                    v["width"], block_size(size, std::min({2 * x, z, v["width"]})));
}

mesh::SurfaceMesh make_groove(const Values& v, double size) {
  const double x = v["length"] / 2, z = v["height"], d = v["depth"], half = v["groove-width"] / 2;
  require(d < z, "depth of the groove must be smaller than the height of the block");
  require(half < x, "groove-width must be smaller than the length of the block");
  return make_prism({{-x, 0, "bottom"},
                     {x, 0, "back"},
                     {x, z, "top"},
                     {half, z, "groove"},
                     {half, z - d, "groove"},
                     {-half, z - d, "groove"},
                     {-half, z, "top"},
                     {-x, z, "front"}},
                    v["width"], block_size(size, std::min({2 * x, z, v["width"]})));
}

mesh::SurfaceMesh make_block_on_floor(const Values& v, double size) {
  const double block = v["edge"] / 2, floor = v["floor-length"] / 2, thickness = v["floor-thickness"];
  require(block < floor, "edge of the block must be smaller than floor-length");
  const double h = block_size(size, 2 * block);
  SurfaceBuilder b;
  const auto square = [&](double half, double z) {
    return std::vector{b.add_point({-half, -half, z}), b.add_point({half, -half, z}), b.add_point({half, half, z}),
                       b.add_point({-half, half, z})};
  };
  const auto bottom = square(floor, -thickness), rim = square(floor, 0), foot = square(block, 0),
             top = square(block, 2 * block);
  const auto loop = [&](const std::vector<VertexId>& c) {
    return loop_of({b.edge(c[0], c[1], h), b.edge(c[1], c[2], h), b.edge(c[2], c[3], h), b.edge(c[3], c[0], h)});
  };
  b.fill(b.patch("floor"), {loop(rim), loop(foot)}, plane_chart({0, 0, 0}, {0, 0, 1}), h);
  const auto walls = [&](const char* patch, const std::vector<VertexId>& low, const std::vector<VertexId>& high) {
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t j = (i + 1) % 4;
      add_flat_face(b, patch, {low[i], low[j], high[j], high[i]}, h);
    }
  };
  walls("block", foot, top);
  add_flat_face(b, "block", top, h);
  walls("floor-side", bottom, rim);
  add_flat_face(b, "floor-bottom", reversed(bottom), h);
  return b.finish();
}

mesh::SurfaceMesh make_pit(const Values& v, double size) {
  const double pit = v["edge"] / 2, block = v["block-length"] / 2, z = v["block-height"], floor = z - v["depth"];
  require(pit < block, "edge of the pit must be smaller than block-length");
  require(floor > 0, "depth of the pit must be smaller than block-height");
  const double h = block_size(size, std::min(2 * pit, v["depth"]));
  SurfaceBuilder b;
  const auto square = [&](double half, double at_z) {
    return std::vector{b.add_point({-half, -half, at_z}), b.add_point({half, -half, at_z}),
                       b.add_point({half, half, at_z}), b.add_point({-half, half, at_z})};
  };
  const auto bottom = square(block, 0), rim = square(block, z), mouth = square(pit, z), ground = square(pit, floor);
  const auto loop = [&](const std::vector<VertexId>& c) {
    return loop_of({b.edge(c[0], c[1], h), b.edge(c[1], c[2], h), b.edge(c[2], c[3], h), b.edge(c[3], c[0], h)});
  };
  b.fill(b.patch("top"), {loop(rim), loop(mouth)}, plane_chart({0, 0, z}, {0, 0, 1}), h);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t j = (i + 1) % 4;
    add_flat_face(b, "pit", {mouth[i], mouth[j], ground[j], ground[i]}, h);
    add_flat_face(b, "side", {bottom[i], bottom[j], rim[j], rim[i]}, h);
  }
  add_flat_face(b, "pit", ground, h);
  add_flat_face(b, "bottom", reversed(bottom), h);
  return b.finish();
}

/// A flat wall that ends in a lip, bent up as a kink or along an arc.
mesh::SurfaceMesh make_ski_jump(const Values& v, double size) {
  /// Largest turn from one piece of the arc to the next [rad].
  constexpr double kArcTurn = geometry::kPi / 18;
  const double x = v["length"], z = v["height"], lip = v["lip-length"], rise = geometry::to_radians(v["lip-angle"]);
  const double radius = v["lip-radius"] * lip, kink = x - lip * std::cos(rise);
  // From the kink the arc reaches as far along the wall as along the lip.
  const double reach = radius * std::tan(rise / 2);
  require(reach < lip, "lip-radius is too large: the lip must end in a straight piece");
  require(reach < kink, "the lip must be shorter than the block is long");
  const double h = block_size(size, std::min({x, z, v["width"]}));
  std::vector<PrismCorner> polygon{{0, 0, "bottom"}, {x, 0, "back"}, {x, z + lip * std::sin(rise), "lip"}};
  const int n = radius == 0 ? 0 : std::max(n_segments(radius * rise, h), static_cast<int>(std::ceil(rise / kArcTurn)));
  for (int i = n; i > 0; --i) {
    const double angle = rise * i / n;
    polygon.push_back({kink - reach + radius * std::sin(angle), z + radius * (1 - std::cos(angle)), "lip"});
  }
  polygon.push_back({kink - reach, z, "top"});
  polygon.push_back({0, z, "front"});
  return make_prism(polygon, v["width"], h);
}

mesh::SurfaceMesh make_saddle_block(const Values& v, double size) {
  const double a = v["edge"] / 2, z0 = v["height"], rise = v["rise"];
  require(rise < z0, "rise of the saddle must be smaller than the height of the block");
  const double h = block_size(size, std::min(2 * a, z0));
  const auto height = [=](double x, double y) { return z0 + rise * ((x / a) * (x / a) - (y / a) * (y / a)); };
  SurfaceBuilder b;
  const std::array<std::array<double, 2>, 4> corners = {{{-a, -a}, {a, -a}, {a, a}, {-a, a}}};
  std::vector<VertexId> low, high;
  for (const auto& [x, y] : corners) {
    low.push_back(b.add_point({x, y, 0}));
    high.push_back(b.add_point({x, y, height(x, y)}));
  }
  // The upper rim: four parabolas, each shared by a side and the saddle.
  std::vector<Row> rim;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t j = (i + 1) % 4;
    const auto [x0, y0] = corners[i];
    const auto [x1, y1] = corners[j];
    const auto at = [&, x0 = x0, y0 = y0, x1 = x1, y1 = y1](double t) {
      const double x = x0 + (x1 - x0) * t, y = y0 + (y1 - y0) * t;
      return Vec3(x, y, height(x, y));
    };
    const auto t = graded_parameters(at, {.size = h});
    Row row{high[i]};
    for (std::size_t k = 1; k + 1 < t.size(); ++k) row.push_back(b.add_point(at(t[k])));
    row.push_back(high[j]);
    const Vec3 outward(y1 - y0, x0 - x1, 0);
    b.fill(
        b.patch("side"),
        {loop_of({b.edge(low[i], low[j], h), b.edge(low[j], high[j], h), reversed(row), b.edge(high[i], low[i], h)})},
        plane_chart(b.point(low[i]), outward), h);
    rim.push_back(row);
  }
  const Chart saddle{[](const Vec3& p) {
                       return Point2{p.x(), p.y()};
                     },
                     [=](const Point2& q) { return Vec3(q.u, q.v, height(q.u, q.v)); }};
  b.fill(b.patch("saddle"), {loop_of(rim)}, saddle, h);
  add_flat_face(b, "bottom", reversed(low), h);
  return b.finish();
}

mesh::SurfaceMesh make_star(const Values& v, double size) {
  const int n = v.integer("points");
  const double r = v["radius"], h = block_size(size, r);
  SurfaceBuilder b;
  const VertexId apex = b.add_point({0, 0, v["height"]});
  std::vector<VertexId> rim;
  for (int i = 0; i < 2 * n; ++i) {
    const double angle = geometry::kPi * i / n, ri = i % 2 == 0 ? r : r * v["inner-radius"];
    rim.push_back(b.add_point({ri * std::cos(angle), ri * std::sin(angle), 0}));
  }
  for (std::size_t i = 0; i < rim.size(); ++i) add_flat_face(b, "star", {rim[i], rim[(i + 1) % rim.size()], apex}, h);
  add_flat_face(b, "base", reversed(rim), h);
  return b.finish();
}

ShapeParameter width(double value) { return length("width", value, "extent along y"); }

}  // namespace

std::vector<Definition> block_shapes() {
  return {
      {{"cube", "cube round the origin; patches x-min, x-max, y-min, y-max, z-min, z-max", {length("edge", 1, "edge")}},
       make_cube},
      {{"box",
        "box round the origin; patches x-min, x-max, y-min, y-max, z-min, z-max",
        {length("length", 2, "extent along x"), width(1), length("height", 0.5, "extent along z")}},
       make_box},
      {{"plate",
        "thin flat box; patches leading-edge, trailing-edge, upper, lower, side-left, side-right",
        {length("length", 1, "chord, along x"), width(1), length("thickness", 0.02, "extent along z")}},
       make_plate},
      {{"wedge",
        "wedge with a sharp trailing edge; patches front, upper, lower, side-left, side-right",
        {length("length", 1, "distance of the front face from the edge"), width(1),
         angle("angle", 20, 0.5, 150, "interior angle at the trailing edge")}},
       make_wedge},
      {{"step",
        "block with a backward-facing step; patches bottom, front, back, upper, step, lower, side-left, side-right",
        {length("length", 2, "extent along x"), width(1), length("height", 1, "height before the step"),
         length("step-height", 0.5, "height of the step"),
         length("step-position", 1, "distance of the step from the front")}},
       make_step},
      {{"notch",
        "block with a V notch across its top; patches bottom, front, back, top, notch, side-left, side-right",
        {length("length", 2, "extent along x"), width(1), length("height", 1, "extent along z"),
         length("depth", 0.5, "depth of the notch"), angle("angle", 60, 1, 170, "opening of the notch")}},
       make_notch},
      {{"groove",
        "block with a rectangular groove across its top; patches bottom, front, back, top, groove, side-left, "
        "side-right",
        {length("length", 2, "extent along x"), width(1), length("height", 1, "extent along z"),
         length("depth", 0.4, "depth of the groove"), length("groove-width", 0.2, "width of the groove, along x")}},
       make_groove},
      {{"block-on-floor",
        "cube standing on a plate, one body; patches block, floor, floor-side, floor-bottom",
        {length("edge", 1, "edge of the cube"), length("floor-length", 3, "edge of the square plate"),
         length("floor-thickness", 0.2, "thickness of the plate")}},
       make_block_on_floor},
      {{"pit",
        "block with a box-shaped pit in its top; patches pit, top, side, bottom",
        {length("edge", 1, "edge of the square pit"), length("depth", 1, "depth of the pit"),
         length("block-length", 3, "edge of the square block"), length("block-height", 1.4, "height of the block")}},
       make_pit},
      {{"ski-jump",
        "block whose top bends up to a lip before its back edge; patches bottom, back, lip, top, front, side-left, "
        "side-right",
        {length("length", 2, "extent along x"), width(1), length("height", 0.5, "height without the lip"),
         length("lip-length", 0.4, "length of the lip"), angle("lip-angle", 50, 5, 85, "rise of the lip at its end"),
         number("lip-radius", 1, 0, 20, "radius of the bend, over the length of the lip; 0: a kink")}},
       make_ski_jump},
      {{"saddle-block",
        "block whose top is a saddle; patches saddle, side, bottom",
        {length("edge", 1, "extent along x and y"), length("height", 0.7, "height at the middle of the saddle"),
         length("rise", 0.2, "rise of the saddle along x, and its fall along y")}},
       make_saddle_block},
      {{"star",
        "pyramid over a star: ridges and valleys meet at its apex; patches star, base",
        {integer("points", 5, 3, 50, "points of the star"), length("radius", 1, "radius of the points"),
         number("inner-radius", 0.5, 0.1, 0.95, "radius of the valleys, over that of the points"),
         length("height", 0.5, "height of the apex")}},
       make_star},
  };
}

}  // namespace nearwall::shapes
