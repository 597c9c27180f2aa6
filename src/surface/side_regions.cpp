#include "nearwall/surface/side_regions.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "nearwall/geometry/angles.h"
#include "nearwall/geometry/box.h"
#include "nearwall/geometry/measures.h"

namespace nearwall::surface {

namespace {

/// Angle between the normals of two neighbours up to which both belong to one region [rad]: about a degree.
constexpr double kBend = 0.02;

/// Angle between two flat parts from which they are two sides of a domain, not pieces of a curved one [rad].
constexpr double kSidesBend = geometry::to_radians(30);

/// Share of the outline from which a part that goes on over little bends is a piece of a curved patch.
constexpr double kMostOfOutline = 0.5;

/// Distance from the plane over the extent of the region up to which it is flat.
constexpr double kFlatness = 1e-5;

/// … or over the largest coordinate: four roundings to single precision.
constexpr double kFloatRounding = 0x1p-22;

/// Distance from the origin over the extent below which a plane goes through it.
constexpr double kRounding = 0x1p-40;

/// Distance from a plane over the coordinates that is rounding.
constexpr double kDoubleRounding = 0x1p-49;

/// Sine of the angle between two planes below which a vertex on both is left on the first.
constexpr double kLeastSlope = 0.02;

struct SideEdge {
  std::uint32_t low, high;
  FaceId face;
  friend auto operator<=>(const SideEdge&, const SideEdge&) = default;
};

class Grouping {
 public:
  Grouping(const mesh::SurfaceMesh& surface, const IdVector<PatchId, SideRole>& role) : surface_(surface), role_(role) {
    parent_.resize(surface.faces.size());
    std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
    noise_ = kFloatRounding * max_norm_of(surface);
    const std::vector<SideEdge> edges = shared_edges();
    std::vector<char> is_joined(parent_.size(), 0);
    for (std::size_t i = 1; i < edges.size(); ++i) {
      const SideEdge &a = edges[i - 1], &b = edges[i];
      if (a.low != b.low || a.high != b.high) continue;
      // That a needle agrees with a neighbour is no accident.
      if (bend_by(a.face, b.face) > kBend) continue;
      join(a.face, b.face);
      is_joined[a.face.index()] = is_joined[b.face.index()] = 1;
    }
    place_needles(edges, std::move(is_joined));
  }

  /// Roots of parts of which most of the outline goes on, in the same role, over edges that bend by less than sides of
  /// a domain do: pieces of curved patches.
  std::set<std::uint32_t> curved() {
    struct Outline {
      double whole = 0, little = 0;
    };
    std::map<std::uint32_t, Outline> outlines;
    const std::vector<SideEdge> edges = shared_edges();
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const SideEdge& a = edges[i];
      const bool is_last = i + 1 == edges.size() || edges[i + 1].low != a.low || edges[i + 1].high != a.high;
      const double length = distance(surface_.points[VertexId(a.low)], surface_.points[VertexId(a.high)]);
      if (is_last) {
        outlines[root(a.face.index())].whole += length;
        continue;
      }
      const SideEdge& b = edges[++i];
      if (root(a.face.index()) == root(b.face.index())) continue;
      const bool bends_little = role_of(a.face) == role_of(b.face) && !is_needle(a.face) && !is_needle(b.face) &&
                                bend_by(a.face, b.face) < kSidesBend;
      for (const FaceId f : {a.face, b.face}) {
        Outline& outline = outlines[root(f.index())];
        outline.whole += length;
        if (bends_little) outline.little += length;
      }
    }
    std::set<std::uint32_t> roots;
    for (const auto& [name, outline] : outlines) {
      if (outline.little > kMostOfOutline * outline.whole) roots.insert(name);
    }
    return roots;
  }

  /// Parts of one role, in the order of their first faces; those of one plane name the same number.
  std::vector<SideRegion> regions(std::vector<std::uint32_t>& plane) {
    std::vector<SideRegion> regions;
    std::map<std::pair<std::uint32_t, SideRole>, std::size_t> number;
    for (const FaceId f : surface_.faces.ids()) {
      const SideRole role = role_of(f);
      if (role == SideRole::None) continue;
      const std::uint32_t r = root(f.index());
      const auto [found, is_new] = number.emplace(std::pair(r, role), regions.size());
      if (is_new) {
        regions.push_back({});
        regions.back().role = role;
        plane.push_back(r);
      }
      regions[found->second].faces.push_back(f);
    }
    return regions;
  }

 private:
  SideRole role_of(FaceId f) const { return role_[surface_.face_patch[f]]; }

  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(FaceId a, FaceId b) {
    const auto [low, high] = std::minmax({root(a.index()), root(b.index())});
    parent_[high] = low;
  }

  static double max_norm_of(const mesh::SurfaceMesh& surface) {
    double largest = 0;
    for (const Vec3& p : surface.points) largest = std::max(largest, max_norm(p));
    return largest;
  }

  std::vector<SideEdge> shared_edges() const {
    std::vector<SideEdge> edges;
    for (const FaceId f : surface_.faces.ids()) {
      if (role_of(f) == SideRole::None) continue;
      const auto& v = surface_.faces[f];
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [low, high] = std::minmax({v[k].index(), v[(k + 1) % 3].index()});
        edges.push_back({low, high, f});
      }
    }
    std::sort(edges.begin(), edges.end());
    return edges;
  }

  /// Whether a triangle is so narrow that rounded coordinates may turn it: it has no normal to speak of.
  bool is_needle(FaceId f) const {
    const auto [a, b, c] = surface_.triangle(f);
    const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
    return 2 * geometry::triangle_area(a, b, c) * kBend <= noise_ * longest;
  }

  /// Angle between the normals; half a turn where a face has no area.
  double bend_by(FaceId f, FaceId g) const {
    const auto [a, b, c] = surface_.triangle(f);
    const auto [p, q, r] = surface_.triangle(g);
    if (!(geometry::triangle_area(a, b, c) > 0) || !(geometry::triangle_area(p, q, r) > 0)) return geometry::kPi;
    return geometry::angle_between(geometry::triangle_normal(a, b, c), geometry::triangle_normal(p, q, r));
  }

  /// Each needle that agrees with none goes to one neighbour that has its place already: it must not join two of them.
  void place_needles(const std::vector<SideEdge>& edges, std::vector<char> is_placed) {
    for (const SideEdge& edge : edges) {
      if (!is_needle(edge.face)) is_placed[edge.face.index()] = 1;
    }
    for (bool any = true; any;) {
      any = false;
      for (std::size_t i = 1; i < edges.size(); ++i) {
        const SideEdge &a = edges[i - 1], &b = edges[i];
        if (a.low != b.low || a.high != b.high) continue;
        if (is_placed[a.face.index()] == is_placed[b.face.index()]) continue;
        join(a.face, b.face);
        is_placed[a.face.index()] = is_placed[b.face.index()] = 1;
        any = true;
      }
    }
  }

  const mesh::SurfaceMesh& surface_;
  const IdVector<PatchId, SideRole>& role_;
  double noise_ = 0;  // of coordinates [length]
  std::vector<std::uint32_t> parent_;
};

std::vector<VertexId> vertices_of(const mesh::SurfaceMesh& surface, const std::vector<FaceId>& faces) {
  std::vector<VertexId> vertices;
  for (const FaceId f : faces) {
    for (const VertexId v : surface.faces[f]) vertices.push_back(v);
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

double farthest(const mesh::SurfaceMesh& surface, const std::vector<VertexId>& vertices, const mesh::SidePlane& plane) {
  double most = 0;
  for (const VertexId v : vertices) most = std::max(most, std::abs(plane.height(surface.points[v])));
  return most;
}

/// The plane normal to an axis through the middle one of the coordinates: nearly all are the same, as a rule.
mesh::SidePlane axis_plane(const mesh::SurfaceMesh& surface, const std::vector<VertexId>& vertices, int axis,
                           bool is_positive, double extent) {
  std::vector<double> coordinates;
  for (const VertexId v : vertices) coordinates.push_back(surface.points[v][axis]);
  const auto middle = coordinates.begin() + static_cast<std::ptrdiff_t>(coordinates.size() / 2);
  std::nth_element(coordinates.begin(), middle, coordinates.end());
  // A plane through the origin that was rounded on its way here goes through it again.
  const double at = std::abs(*middle) <= kRounding * extent ? 0.0 : *middle;
  mesh::SidePlane plane;
  plane.normal[axis] = is_positive ? 1 : -1;
  plane.offset = is_positive ? at : -at;
  plane.axis = axis;
  return plane;
}

void fit_plane(const mesh::SurfaceMesh& surface, SideRegion& region) {
  const std::vector<VertexId> vertices = vertices_of(surface, region.faces);
  geometry::Box box;
  for (const VertexId v : vertices) box.include(surface.points[v]);
  Vec3 normal;
  for (const FaceId f : region.faces) {
    const auto [a, b, c] = surface.triangle(f);
    normal += cross(b - a, c - a);
  }
  const double size = norm(normal);
  if (!(size > 0)) return;
  normal = normal / size;
  const double tolerance =
      std::max(kFlatness * box.diagonal(), kFloatRounding * std::max(max_norm(box.low), max_norm(box.high)));
  for (int axis = 0; axis < 3; ++axis) {
    region.plane = axis_plane(surface, vertices, axis, normal[axis] > 0, box.diagonal());
    region.off_plane = farthest(surface, vertices, region.plane);
    region.is_flat = region.off_plane <= tolerance;
    if (region.is_flat) return;
  }
  double sum = 0;
  for (const VertexId v : vertices) sum += dot(normal, surface.points[v]);
  region.plane = {normal, sum / static_cast<double>(vertices.size()), -1};
  region.off_plane = farthest(surface, vertices, region.plane);
  region.is_flat = region.off_plane <= tolerance;
}

/// Flat regions normal to one axis that are nearer to each other than they may be uneven lie in one plane, the first's.
void unite_planes(const mesh::SurfaceMesh& surface, std::vector<SideRegion>& regions) {
  const geometry::Box box = geometry::bounding_box(surface.points.raw());
  const double tolerance = kFloatRounding * std::max({max_norm(box.low), max_norm(box.high), box.diagonal()});
  for (std::size_t i = 0; i < regions.size(); ++i) {
    mesh::SidePlane& own = regions[i].plane;
    if (!regions[i].is_flat || own.axis < 0) continue;
    for (std::size_t j = 0; j < i; ++j) {
      const mesh::SidePlane& other = regions[j].plane;
      if (!regions[j].is_flat || other.axis != own.axis || other.normal != own.normal) continue;
      if (std::abs(other.offset - own.offset) <= tolerance) own.offset = other.offset;
    }
  }
}

}  // namespace

std::vector<SideRegion> find_side_regions(const mesh::SurfaceMesh& surface, const IdVector<PatchId, SideRole>& role) {
  std::vector<std::uint32_t> plane;
  Grouping grouping(surface, role);
  std::vector<SideRegion> regions = grouping.regions(plane);
  const std::set<std::uint32_t> curved = grouping.curved();
  std::map<std::uint32_t, SideRegion> whole;
  for (std::size_t i = 0; i < regions.size(); ++i) {
    auto& faces = whole[plane[i]].faces;
    faces.insert(faces.end(), regions[i].faces.begin(), regions[i].faces.end());
  }
  for (auto& [number, all] : whole) fit_plane(surface, all);
  for (std::size_t i = 0; i < regions.size(); ++i) {
    const SideRegion& all = whole[plane[i]];
    regions[i].plane = all.plane;
    regions[i].off_plane = all.off_plane;
    regions[i].is_curved = curved.contains(plane[i]);
    regions[i].is_flat = all.is_flat && !regions[i].is_curved;
  }
  unite_planes(surface, regions);
  return regions;
}

double flatten(const std::vector<SideRegion>& regions, mesh::SurfaceMesh& surface) {
  double farthest_move = 0;
  IdVector<VertexId, Vec3> old = surface.points;
  IdVector<VertexId, std::array<char, 3>> is_fixed(surface.points.size(), {0, 0, 0});
  // Planes normal to an axis first: they are kept exactly by what moves the vertices of others.
  for (const SideRegion& region : regions) {
    if (!region.is_flat || region.plane.axis < 0) continue;
    for (const VertexId v : vertices_of(surface, region.faces)) {
      surface.points[v][region.plane.axis] = region.plane.offset * region.plane.normal[region.plane.axis];
      is_fixed[v][static_cast<std::size_t>(region.plane.axis)] = 1;
    }
  }
  for (const SideRegion& region : regions) {
    if (!region.is_flat || region.plane.axis >= 0) continue;
    for (const VertexId v : vertices_of(surface, region.faces)) {
      // What lies on it to rounding stays as it is.
      const double height = region.plane.height(surface.points[v]);
      if (std::abs(height) <= kDoubleRounding * max_norm(surface.points[v])) continue;
      Vec3 way = region.plane.normal;
      for (int axis = 0; axis < 3; ++axis) {
        if (is_fixed[v][static_cast<std::size_t>(axis)]) way[axis] = 0;
      }
      const double slope = dot(way, region.plane.normal);
      if (slope > kLeastSlope) surface.points[v] -= way * (height / slope);
    }
  }
  for (const VertexId v : old.ids()) farthest_move = std::max(farthest_move, distance(old[v], surface.points[v]));
  return farthest_move;
}

}  // namespace nearwall::surface
