#include "nearwall/volume/far_field.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "nearwall/core/errors.h"
#include "nearwall/geometry/angles.h"

namespace nearwall::volume {
namespace {

constexpr std::array<char, 3> kAxisNames = {'x', 'y', 'z'};

/// Pieces of an octahedron's edge: four edges make a great circle, which keeps 12 edges at least.
constexpr int kMinFrequency = 3;
/// Fewest pieces of the shortest edge of a box.
constexpr int kMinBoxPieces = 2;
/// More pieces than this along one edge would make surfaces that no 32-bit id can number.
constexpr double kMaxPieces = 10000;
/// A length that is a whole number of sizes up to rounding is cut into that number.
constexpr double kRoundingSlack = 1e-9;

void require(bool holds, std::string_view what) {
  if (!holds) throw InputError(fmt::format("far field: {}", what));
}

int n_pieces(double length, double size, int minimum) {
  const double n = std::ceil(length / size * (1 - kRoundingSlack));
  if (!(n <= kMaxPieces)) {
    throw InputError(
        fmt::format("far field: size {:g} cuts a length of {:g} into more than {:g} pieces; give a larger "
                    "size",
                    size, length, kMaxPieces));
  }
  return std::max(minimum, static_cast<int>(n));
}

void check_planes(const FarField& far_field) {
  std::array<std::array<bool, 2>, 3> seen{};
  for (const SymmetryPlane& plane : far_field.planes) {
    require(plane.axis >= 0 && plane.axis < 3, fmt::format("axis {} of a symmetry plane is not 0, 1 or 2", plane.axis));
    require(plane.side != 0, "the side of a symmetry plane is 0; positive and negative numbers name its sides");
    require(std::isfinite(plane.position), "the position of a symmetry plane is not finite");
    bool& is_taken = seen[static_cast<std::size_t>(plane.axis)][plane.side > 0 ? 1 : 0];
    require(!is_taken, fmt::format("two symmetry planes normal to {} have the domain on the same side",
                                   kAxisNames[static_cast<std::size_t>(plane.axis)]));
    is_taken = true;
  }
}

/// Points of a lattice on the far field, each made once; triangles of its patches.
class LatticeSurface {
 public:
  using Node = std::array<int, 3>;

  template <class Place>
  VertexId vertex(const Node& node, const Place& place) {
    const auto [at, is_new] = vertices_.try_emplace(node);
    if (is_new) at->second = mesh_.points.push_back(place(node));
    return at->second;
  }
  PatchId add_patch(std::string name) { return mesh_.patch_names.push_back(std::move(name)); }
  void add_triangle(PatchId patch, const std::array<VertexId, 3>& corners) {
    mesh_.faces.push_back(corners);
    mesh_.face_patch.push_back(patch);
  }
  mesh::SurfaceMesh finish() { return std::move(mesh_); }

 private:
  mesh::SurfaceMesh mesh_;
  std::map<Node, VertexId> vertices_;
};

/// The sphere's points are those of the lattice with |i| + |j| + |k| = f, in the direction (sin(iθ), sin(jθ), sin(kθ)),
/// θ a quarter turn over f: along the edges of the octants they divide the arcs evenly, and a zero stays one.
class Octants {
 public:
  explicit Octants(const FarField& far_field) : centre_(far_field.centre), radius_(far_field.radius) {
    // Equilateral triangles of this edge have the area of the 8 f² ones on the unit sphere, times f.
    const double mean_edge = std::sqrt(geometry::kPi / 2 * 4 / std::numbers::sqrt3);
    frequency_ = n_pieces(radius_ * mean_edge, far_field.size, kMinFrequency);
  }

  void add(LatticeSurface& surface, PatchId patch, const std::array<int, 3>& signs) const {
    const bool is_mirrored = signs[0] * signs[1] * signs[2] < 0;
    const auto corner = [&](int i, int j) {
      const LatticeSurface::Node node = {signs[0] * i, signs[1] * j, signs[2] * (frequency_ - i - j)};
      return surface.vertex(node, [this](const LatticeSurface::Node& n) { return place(n); });
    };
    const auto add_triangle = [&](VertexId a, VertexId b, VertexId c) {
      // Counterclockwise seen from the centre; the octant of positive coordinates has its corners the other way round.
      surface.add_triangle(patch, is_mirrored ? std::array{a, b, c} : std::array{a, c, b});
    };
    for (int i = 0; i < frequency_; ++i) {
      for (int j = 0; i + j < frequency_; ++j) {
        add_triangle(corner(i + 1, j), corner(i, j + 1), corner(i, j));
        if (i + j + 1 < frequency_) add_triangle(corner(i, j + 1), corner(i + 1, j), corner(i + 1, j + 1));
      }
    }
  }

 private:
  Vec3 place(const LatticeSurface::Node& n) const {
    const double step = 0.5 * geometry::kPi / frequency_;
    const Vec3 direction = normalized({std::sin(step * n[0]), std::sin(step * n[1]), std::sin(step * n[2])});
    return centre_ + direction * radius_;
  }

  Vec3 centre_;
  double radius_ = 0;
  int frequency_ = 0;
};

mesh::SurfaceMesh sphere_surface(const FarField& far_field) {
  require(far_field.radius > 0 && std::isfinite(far_field.radius),
          fmt::format("the radius must be a positive length, not {:g}", far_field.radius));
  require(is_finite(far_field.centre), "the centre is not finite");
  std::array<int, 3> kept{};  // 0: both sides
  for (const SymmetryPlane& plane : far_field.planes) {
    const auto axis = static_cast<std::size_t>(plane.axis);
    require(kept[axis] == 0,
            fmt::format("a sphere has no room between two symmetry planes normal to {}; take a box", kAxisNames[axis]));
    require(far_field.centre[plane.axis] == plane.position,
            fmt::format("the centre of the sphere must lie on the symmetry plane {} = {:.17g}, but has {} = {:.17g}",
                        kAxisNames[axis], plane.position, kAxisNames[axis], far_field.centre[plane.axis]));
    kept[axis] = plane.side > 0 ? 1 : -1;
  }
  const Octants octants(far_field);
  LatticeSurface surface;
  const PatchId patch = surface.add_patch("farfield");
  for (const int x : {1, -1}) {
    for (const int y : {1, -1}) {
      for (const int z : {1, -1}) {
        if (x * kept[0] >= 0 && y * kept[1] >= 0 && z * kept[2] >= 0) octants.add(surface, patch, {x, y, z});
      }
    }
  }
  return surface.finish();
}

/// Coordinates of the rows across one axis; both ends exactly.
std::vector<double> box_rows(double low, double high, double size, int least) {
  const int n = n_pieces(high - low, size, least);
  std::vector<double> rows;
  for (int i = 0; i < n; ++i) rows.push_back(low + (high - low) * (static_cast<double>(i) / n));
  rows.push_back(high);
  return rows;
}

/// The box with what the planes leave of it, and which of its sides are planes.
struct CutBox {
  geometry::Box box;
  std::array<std::array<bool, 2>, 3> is_cut{};  ///< by axis, low and high side
};

CutBox cut_box(const FarField& far_field) {
  CutBox result{far_field.box, {}};
  const geometry::Box& box = far_field.box;
  for (int axis = 0; axis < 3; ++axis) {
    require(std::isfinite(box.low[axis]) && std::isfinite(box.high[axis]) && box.low[axis] < box.high[axis],
            fmt::format("the box must have its low corner below its high one, but along {} it goes from {:g} to {:g}",
                        kAxisNames[static_cast<std::size_t>(axis)], box.low[axis], box.high[axis]));
  }
  for (const SymmetryPlane& plane : far_field.planes) {
    const double low = box.low[plane.axis], high = box.high[plane.axis];
    const bool keeps_high = plane.side > 0;
    require(
        keeps_high ? low <= plane.position && plane.position < high : low < plane.position && plane.position <= high,
        fmt::format("the symmetry plane {} = {:g} does not cut the box, which goes from {:g} to {:g} there",
                    kAxisNames[static_cast<std::size_t>(plane.axis)], plane.position, low, high));
    (keeps_high ? result.box.low : result.box.high)[plane.axis] = plane.position;
    result.is_cut[static_cast<std::size_t>(plane.axis)][keeps_high ? 0 : 1] = true;
  }
  return result;
}

/// Rows of the box across each axis.
using BoxRows = std::array<std::vector<double>, 3>;

void add_box_side(LatticeSurface& surface, const BoxRows& rows, std::size_t axis, bool is_high) {
  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  const auto last = [&rows](std::size_t a) { return static_cast<int>(rows[a].size()) - 1; };
  const PatchId patch = surface.add_patch(fmt::format("farfield-{}-{}", kAxisNames[axis], is_high ? "max" : "min"));
  const auto place = [&rows](const LatticeSurface::Node& n) {
    const auto at = [&](std::size_t a) { return rows[a][static_cast<std::size_t>(n[a])]; };
    return Vec3(at(0), at(1), at(2));
  };
  const auto corner = [&](int i, int j) {
    LatticeSurface::Node node{};
    node[axis] = is_high ? last(axis) : 0, node[u] = i, node[v] = j;
    return surface.vertex(node, place);
  };
  const auto add_triangle = [&](VertexId a, VertexId b, VertexId c) {
    surface.add_triangle(patch, is_high ? std::array{a, c, b} : std::array{a, b, c});
  };
  for (int i = 0; i < last(u); ++i) {
    for (int j = 0; j < last(v); ++j) {
      const VertexId a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1), d = corner(i, j + 1);
      // Diagonals alternate, so that no direction is preferred.
      if ((i + j) % 2 == 0) {
        add_triangle(a, b, c), add_triangle(a, c, d);
      } else {
        add_triangle(a, b, d), add_triangle(b, c, d);
      }
    }
  }
}

mesh::SurfaceMesh box_surface(const FarField& far_field) {
  const CutBox cut = cut_box(far_field);
  const Vec3 extent = cut.box.high - cut.box.low;
  // Between two planes there may be a single row.
  std::array<int, 3> least{};
  double size = far_field.size;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    least[a] = cut.is_cut[a][0] && cut.is_cut[a][1] ? 1 : kMinBoxPieces;
    // A size that halves the shortest edge keeps cells of a thin box from being long and thin.
    size = std::min(size, extent[axis] / least[a]);
  }
  BoxRows rows;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    rows[a] = box_rows(cut.box.low[axis], cut.box.high[axis], size, least[a]);
  }
  LatticeSurface surface;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const bool is_high : {false, true}) {
      if (!cut.is_cut[axis][is_high ? 1 : 0]) add_box_side(surface, rows, axis, is_high);
    }
  }
  return surface.finish();
}

}  // namespace

mesh::SurfaceMesh far_field_surface(const FarField& far_field) {
  require(far_field.size > 0 && std::isfinite(far_field.size),
          fmt::format("the size must be a positive length, not {:g}", far_field.size));
  check_planes(far_field);
  return far_field.shape == FarFieldShape::Sphere ? sphere_surface(far_field) : box_surface(far_field);
}

}  // namespace nearwall::volume
