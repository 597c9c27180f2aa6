#include <array>
#include <cmath>
#include <map>

#include "nearwall/geometry/angles.h"
#include "shapes/definition.h"
#include "shapes/prism.h"

namespace nearwall::shapes {
namespace {

using geometry::kPi;
using geometry::to_radians;

/// Default edge length, over the shortest edge that is not thin on purpose.
constexpr double kDefaultSize = 0.1;

double corner_size(double size, double shortest) { return size == 0 ? kDefaultSize * shortest : size; }

/// Unit vector in the plane z = 0.
Vec3 heading(double angle) { return {std::cos(angle), std::sin(angle), 0}; }

/// The octants filled, one bit each: x > 0 counts 1, y > 0 counts 2, z > 0 counts 4 in the number of an octant.
using Octants = unsigned;
constexpr Octants kAllOctants = 255;

bool is_filled(Octants octants, unsigned octant) { return (octants >> octant & 1u) != 0; }

/// Whether each octant of the set can be reached from any other across faces.
bool is_connected(Octants octants) {
  Octants reached = octants & (~octants + 1);
  for (Octants before = 0; before != reached;) {
    before = reached;
    for (unsigned octant = 0; octant < 8; ++octant) {
      if (!is_filled(before, octant)) continue;
      for (const unsigned axis : {1u, 2u, 4u}) reached |= 1u << (octant ^ axis) & octants;
    }
  }
  return reached == octants;
}

mesh::SurfaceMesh make_octants(const Values& v, double size) {
  const auto filled = static_cast<Octants>(v.integer("pattern"));
  // Otherwise two parts of the body, or of the fluid, would meet in an edge or in the centre only.
  require(is_connected(filled) && is_connected(kAllOctants & ~filled),
          "pattern: the octants filled, and those left empty, must hang together by faces");
  const double edge = v["edge"], h = corner_size(size, edge);
  SurfaceBuilder b;
  std::map<std::array<int, 3>, VertexId> corners;
  const auto corner = [&](const std::array<int, 3>& at) {
    const auto [entry, is_new] = corners.try_emplace(at);
    if (is_new) entry->second = b.add_point(Vec3(at[0], at[1], at[2]) * edge);
    return entry->second;
  };
  for (unsigned octant = 0; octant < 8; ++octant) {
    if (!is_filled(filled, octant)) continue;
    for (unsigned axis = 0; axis < 3; ++axis) {
      const unsigned u = (axis + 1) % 3, w = (axis + 2) % 3;
      const bool is_high = (octant >> axis & 1u) != 0;
      // The face through the centre, if the octant beyond is empty, and the one opposite to it.
      for (const bool is_inner : {true, false}) {
        if (is_inner && is_filled(filled, octant ^ 1u << axis)) continue;
        std::array<int, 3> low{};
        for (unsigned k = 0; k < 3; ++k) low[k] = (octant >> k & 1u) != 0 ? 0 : -1;
        low[axis] = is_inner ? 0 : is_high ? 1 : -1;
        std::array<std::array<int, 3>, 4> quad{low, low, low, low};
        ++quad[1][u], ++quad[2][u], ++quad[2][w], ++quad[3][w];
        const bool looks_up = is_high != is_inner;
        if (!looks_up) std::swap(quad[1], quad[3]);
        add_flat_face(b, is_inner ? "corner" : "outside",
                      {corner(quad[0]), corner(quad[1]), corner(quad[2]), corner(quad[3])}, h);
      }
    }
  }
  return b.finish();
}

mesh::SurfaceMesh make_crown(const Values& v, double size) {
  const double r = v["radius"], z = v["height"], ridge = v["ridge-slope"], valley = v["valley-slope"];
  require(ridge + valley > 0, "ridge-slope must be above the valleys: larger than minus valley-slope");
  const double high = z + r * std::tan(to_radians(ridge)), low = z - r * std::tan(to_radians(valley));
  require(high > 0 && low > 0, "height is too small: the rim of the crown lies below its base");
  const double h = corner_size(size, r);
  SurfaceBuilder b;
  const VertexId apex = b.add_point({0, 0, z});
  std::vector<VertexId> rim, base;
  const int n = 2 * v.integer("points");
  for (int i = 0; i < n; ++i) {
    const Vec3 at = heading(2 * kPi * i / n) * r;
    rim.push_back(b.add_point(at + Vec3(0, 0, i % 2 == 0 ? high : low)));
    base.push_back(b.add_point(at));
  }
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const std::size_t j = (i + 1) % rim.size();
    add_flat_face(b, "crown", {apex, rim[i], rim[j]}, h);
    add_flat_face(b, "side", {base[i], base[j], rim[j], rim[i]}, h);
  }
  add_flat_face(b, "base", reversed(base), h);
  return b.finish();
}

mesh::SurfaceMesh make_pyramid(const Values& v, double size) {
  const int n = v.integer("sides");
  const double x = v["length"], r = x * std::tan(to_radians(v["half-angle"]));
  const double h = corner_size(size, std::min(x, 2 * r * std::sin(kPi / n)));
  SurfaceBuilder b;
  const VertexId apex = b.add_point({0, 0, 0});
  std::vector<VertexId> base;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * kPi * i / n;
    base.push_back(b.add_point({x, r * std::cos(angle), r * std::sin(angle)}));
  }
  for (std::size_t i = 0; i < base.size(); ++i) {
    add_flat_face(b, "pyramid", {apex, base[(i + 1) % base.size()], base[i]}, h);
  }
  add_flat_face(b, "base", base, h);
  return b.finish();
}

/// Flat arms that leave the origin upwards, bend down and curl in below, each to a sharp tip: whichever way one looks
/// from, a side of some arm is turned away.
mesh::SurfaceMesh make_omni_saddle(const Values& v, double size) {
  const int n = v.integer("arms");
  const double r = v["radius"], half = v["arm-width"] * r / 2, tip = v["tip-distance"] * r;
  require(half < r * std::tan(kPi / n), "arm-width is too large: neighbouring arms meet");
  const double h = corner_size(size, r);
  SurfaceBuilder b;
  const VertexId centre = b.add_point({0, 0, 0});
  std::vector<VertexId> top, link;
  for (int k = 0; k < n; ++k) {
    const Vec3 out = heading(2 * kPi * k / n) * r, across = heading(2 * kPi * k / n + kPi / 2) * half, up(0, 0, r);
    const VertexId upper_right = b.add_point(out - across + up), upper_left = b.add_point(out + across + up);
    const VertexId lower_right = b.add_point(out - across - up), lower_left = b.add_point(out + across - up);
    const VertexId end = b.add_point(out * (tip / r) - up);
    add_flat_face(b, "side", {lower_right, lower_left, upper_left, upper_right}, h);
    add_flat_face(b, "bottom", {lower_right, end, lower_left}, h);
    top.insert(top.end(), {upper_right, upper_left});
    link.insert(link.end(), {upper_right, lower_right, end, lower_left, upper_left});
    if (n > 2) {
      // Where two arms part.
      const Vec3 between = heading(2 * kPi * (k + 0.5) / n) * (half / std::sin(kPi / n));
      top.push_back(b.add_point(between + up));
      link.push_back(top.back());
    }
  }
  add_flat_face(b, "top", top, h);
  for (std::size_t i = 0; i < link.size(); ++i) {
    add_flat_face(b, "saddle", {centre, link[(i + 1) % link.size()], link[i]}, h);
  }
  return b.finish();
}

mesh::SurfaceMesh make_ski_jump_corner(const Values& v, double size) {
  const double x = v["length"], y = v["width"] / 2, z = v["height"], lip = v["lip-length"];
  const double back = lip * std::cos(to_radians(v["lip-angle"])), up = lip * std::sin(to_radians(v["lip-angle"]));
  require(back < x, "lip-length must be smaller than the length of the block");
  const double h = corner_size(size, std::min({x, y, z}));
  SurfaceBuilder b;
  const std::array<VertexId, 4> foot = {b.add_point({0, -y, 0}), b.add_point({x, -y, 0}), b.add_point({x, y, 0}),
                                        b.add_point({0, y, 0})};
  const VertexId front_left = b.add_point({0, -y, z}), end_left = b.add_point({x, -y, z});
  const VertexId corner = b.add_point({x, 0, z}), lip_end = b.add_point({x, y, z + up});
  const VertexId lip_foot = b.add_point({x - back, y, z}), front_right = b.add_point({0, y, z});
  add_flat_face(b, "bottom", {foot[0], foot[3], foot[2], foot[1]}, h);
  add_flat_face(b, "front", {foot[0], front_left, front_right, foot[3]}, h);
  add_flat_face(b, "side-left", {foot[0], foot[1], end_left, front_left}, h);
  add_flat_face(b, "back", {foot[1], foot[2], lip_end, corner, end_left}, h);
  add_flat_face(b, "side-right", {foot[2], foot[3], front_right, lip_foot, lip_end}, h);
  add_flat_face(b, "top", {front_left, end_left, corner, lip_foot, front_right}, h);
  add_flat_face(b, "lip", {corner, lip_end, lip_foot}, h);
  return b.finish();
}

}  // namespace

std::vector<Definition> corner_shapes() {
  return {
      {{"octants",
        "some of the eight cubes round a point, one body; patches corner, outside",
        {length("edge", 1, "edge of each cube"),
         integer("pattern", 7, 1, 254,
                 "cubes filled, a bit each: 2^(i + 2 j + 4 k) for the one beyond x, y, z = 0 if i, j, k = 1")}},
       make_octants},
      {{"crown",
        "drum with a zigzag rim: rising ridges and falling valleys meet at its apex; patches crown, side, base",
        {integer("points", 3, 2, 24, "ridges, and valleys"), length("radius", 1, "radius"),
         length("height", 2, "height of the apex"), angle("ridge-slope", 35, -80, 80, "rise of the ridges outward"),
         angle("valley-slope", 35, -80, 80, "fall of the valleys outward")}},
       make_crown},
      {{"pyramid",
        "needle along x, its apex at the origin; patches pyramid, base",
        {integer("sides", 4, 3, 50, "sides"), length("length", 1, "distance of the apex from the base"),
         angle("half-angle", 20, 0.5, 80, "angle between axis and edges")}},
       make_pyramid},
      {{"omni-saddle",
        "curled arms with sharp tips, from whose centre no direction sees all faces; patches saddle, top, side, bottom",
        {integer("arms", 2, 2, 6, "arms"), length("radius", 1, "distance of top, side and bottom from the centre"),
         number("arm-width", 0.4, 0.02, 1.9, "width of the arms, over the radius"),
         number("tip-distance", 0.5, 0.02, 0.98, "distance of the tips from the axis, over the radius")}},
       make_omni_saddle},
      {{"ski-jump-corner",
        "block whose back edge bends up where a lip begins; patches top, lip, back, bottom, front, side-left, "
        "side-right",
        {length("length", 2, "extent along x"), length("width", 1, "extent along y"),
         length("height", 0.5, "height without the lip"), length("lip-length", 0.4, "length of the lip at the side"),
         angle("lip-angle", 50, 5, 85, "rise of the lip at the side")}},
       make_ski_jump_corner},
  };
}

}  // namespace nearwall::shapes
