#include "nearwall/surface/open_wall.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "nearwall/core/errors.h"
#include "nearwall/geometry/angles.h"
#include "nearwall/geometry/measures.h"

namespace nearwall::surface {

namespace {

using RegionIndex = std::uint32_t;
constexpr RegionIndex kNoRegion = 0xffffffff;

/// Turn from which a concave edge between wall and plane is one on which layers land [rad]: with less, a line in the
/// plane would lean by more than 60 degrees from the wall's normal.
constexpr double kLeastConcave = geometry::to_radians(30);

/// An edge of a face of a side, in its direction there.
struct SideEdge {
  std::uint32_t from, to;
  RegionIndex region;
  friend auto operator<=>(const SideEdge&, const SideEdge&) = default;
};

class Opening {
 public:
  Opening(const mesh::SurfaceMesh& closed, const std::vector<SideRegion>& regions,
          const IdVector<FaceId, char>& is_wetted, const OpenWallOptions& options)
      : closed_(closed), regions_(regions), is_wetted_(is_wetted), options_(options), lands_(regions.size(), 0) {
    region_of_.resize(closed.faces.size(), kNoRegion);
    for (RegionIndex r = 0; r < regions.size(); ++r) {
      planes_.push_back(plane_into_domain(regions[r]));
      for (const FaceId f : regions[r].faces) {
        region_of_[f] = r;
        for (std::size_t k = 0; k < 3; ++k) {
          edges_.push_back({closed.faces[f][k].index(), closed.faces[f][(k + 1) % 3].index(), r});
        }
      }
    }
    std::sort(edges_.begin(), edges_.end());
    choose();
    let_neighbours_land();
  }

  OpenWall open() {
    for (auto pinched = pinched_regions(); !pinched.empty(); pinched = pinched_regions()) {
      for (const RegionIndex r : pinched) {
        lands_[r] = 0;
        notes_.push_back(
            fmt::format("{}: the wall touches itself on it: layers end at its edge, as beside nolayer", name(r)));
      }
    }
    OpenWall result;
    number_planes(result);
    take_faces(result);
    mark_planes(result);
    hold_vertices(result);
    find_corners(result);
    result.notes = notes_;
    return result;
  }

 private:
  bool is_cut_of_body(const SideRegion& region) const {
    return options_.fluid == FluidSide::Outside && region.role == SideRole::Symmetry;
  }

  mesh::SidePlane plane_into_domain(const SideRegion& region) const {
    if (!is_cut_of_body(region)) return region.plane;
    mesh::SidePlane plane = region.plane;
    plane.normal = -plane.normal;
    plane.offset = -plane.offset;
    return plane;
  }

  std::string name(RegionIndex r) const {
    const FaceId f = regions_[r].faces.front();
    return fmt::format("patch \"{}\"", closed_.patch_names[closed_.face_patch[f]]);
  }

  bool has_layers(FaceId f) const {
    return is_wetted_[f] && options_.has_layers[closed_.face_patch[f]] && region_of_[f] == kNoRegion;
  }

  /// Region of a side that has the edge from `from` to `to`; kNoRegion if there is none.
  RegionIndex region_at(VertexId from, VertexId to) const {
    const SideEdge wanted{from.index(), to.index(), 0};
    const auto found = std::lower_bound(edges_.begin(), edges_.end(), wanted);
    return found != edges_.end() && found->from == wanted.from && found->to == wanted.to ? found->region : kNoRegion;
  }

  /// Calls `body(f, k, region, lands)` for the edges between a face with layers and a region: whether its layers can
  /// land there, that is whether wall and plane make a concave corner.
  template <class Body>
  void for_each_meeting(const Body& body) const {
    for (const FaceId f : closed_.faces.ids()) {
      if (!has_layers(f)) continue;
      const auto& v = closed_.faces[f];
      for (std::size_t k = 0; k < 3; ++k) {
        const RegionIndex r = region_at(v[(k + 1) % 3], v[k]);
        if (r == kNoRegion) continue;
        const auto [a, b, c] = closed_.triangle(f);
        const Vec3 along = closed_.points[v[(k + 1) % 3]] - closed_.points[v[k]];
        const double turn = geometry::edge_turn(geometry::triangle_normal(a, b, c), planes_[r].normal, along);
        body(f, k, r, turn < -kLeastConcave);
      }
    }
  }

  /// Which regions layers land on.
  void choose() {
    std::vector<double> concave(regions_.size(), 0), convex(regions_.size(), 0);
    for_each_meeting([&](FaceId f, std::size_t k, RegionIndex r, bool lands) {
      const auto& v = closed_.faces[f];
      (lands ? concave : convex)[r] += distance(closed_.points[v[k]], closed_.points[v[(k + 1) % 3]]);
    });
    std::size_t n_planes = 0;
    for (RegionIndex r = 0; r < regions_.size(); ++r) {
      const SideRegion& region = regions_[r];
      const bool is_needed = is_cut_of_body(region);
      const bool meets_layers = concave[r] + convex[r] > 0;
      if (!region.is_flat && (meets_layers || is_needed)) {
        refuse_uneven(r, is_needed);
      } else if (is_needed || (options_.lands && concave[r] > 0 && n_planes < mesh::kNoPlane)) {
        lands_[r] = 1;
        ++n_planes;
      } else if (meets_layers && options_.lands) {
        notes_.push_back(fmt::format(
            "{}: the wall turns away from it, so no layers can land on it: they end at its edge, as beside nolayer",
            name(r)));
      }
    }
  }

  /// What lies beside a region on which layers land, in the same plane, gives way to them, too.
  void let_neighbours_land() {
    for (bool any = true; any;) {
      any = false;
      for (const SideEdge& edge : edges_) {
        const RegionIndex other = region_at(VertexId(edge.to), VertexId(edge.from));
        if (other == kNoRegion || lands_[other] || !lands_[edge.region]) continue;
        const mesh::SidePlane &p = planes_[edge.region], &q = planes_[other];
        if (p.normal != q.normal || p.offset != q.offset) continue;
        lands_[other] = 1;
        any = true;
      }
    }
  }

  void refuse_uneven(RegionIndex r, bool is_needed) {
    const std::string what =
        regions_[r].is_curved
            ? fmt::format("{} is curved", name(r))
            : fmt::format("{} is not flat: its points lie up to {:.3g} off a plane", name(r), regions_[r].off_plane);
    if (is_needed) {
      throw GeometryError(what + "; a plane of symmetry has to be flat, or its patch of another type");
    }
    const std::string note = what + ": layers end at its edge, as beside nolayer";
    if (notes_.empty() || notes_.back() != note) notes_.push_back(note);
  }

  bool stays(FaceId f) const { return region_of_[f] == kNoRegion || !lands_[region_of_[f]]; }

  /// Regions round vertices at which the faces that stay form more than one fan.
  std::vector<RegionIndex> pinched_regions() const {
    std::vector<RegionIndex> pinched;
    std::map<std::uint32_t, RegionIndex> seen;  // vertices from which a boundary edge leaves
    for (const FaceId f : closed_.faces.ids()) {
      if (!stays(f)) continue;
      const auto& v = closed_.faces[f];
      for (std::size_t k = 0; k < 3; ++k) {
        const RegionIndex r = region_at(v[(k + 1) % 3], v[k]);
        if (r == kNoRegion || !lands_[r]) continue;
        const auto [found, is_new] = seen.emplace(v[k].index(), r);
        if (is_new) continue;
        if (is_cut_of_body(regions_[r])) {
          const Vec3& p = closed_.points[v[k]];
          throw GeometryError(
              fmt::format("{}: the bodies that it cuts touch each other there at ({}, {}, {}); give "
                          "them a gap or unite them",
                          name(r), p.x(), p.y(), p.z()));
        }
        pinched.push_back(r);
        pinched.push_back(found->second);
      }
    }
    std::sort(pinched.begin(), pinched.end());
    pinched.erase(std::unique(pinched.begin(), pinched.end()), pinched.end());
    std::erase_if(pinched, [&](RegionIndex r) { return is_cut_of_body(regions_[r]); });
    return pinched;
  }

  void number_planes(OpenWall& result) {
    plane_number_.assign(regions_.size(), mesh::kNoPlane);
    auto& planes = result.planes.planes;
    for (RegionIndex r = 0; r < regions_.size(); ++r) {
      if (!lands_[r]) continue;
      const auto same = std::find_if(planes.begin(), planes.end(), [&](const mesh::SidePlane& p) {
        return p.normal == planes_[r].normal && p.offset == planes_[r].offset;
      });
      plane_number_[r] = static_cast<mesh::PlaneIndex>(same - planes.begin());
      if (same == planes.end()) {
        planes.push_back(planes_[r]);
        result.side_faces.emplace_back();
        result.patch.push_back(closed_.face_patch[regions_[r].faces.front()]);
        result.role.push_back(regions_[r].role);
      }
      auto& faces = result.side_faces[plane_number_[r]];
      faces.insert(faces.end(), regions_[r].faces.begin(), regions_[r].faces.end());
    }
  }

  void take_faces(OpenWall& result) const {
    mesh::SurfaceMesh& surface = result.surface;
    surface.patch_names = closed_.patch_names;
    IdVector<VertexId, VertexId> number(closed_.points.size());
    std::vector<char> is_used(closed_.points.size(), 0);
    for (const FaceId f : closed_.faces.ids()) {
      if (!stays(f)) continue;
      for (const VertexId v : closed_.faces[f]) is_used[v.index()] = 1;
    }
    for (const VertexId v : closed_.points.ids()) {
      if (!is_used[v.index()]) continue;
      number[v] = surface.points.push_back(closed_.points[v]);
      result.vertex.push_back(v);
    }
    for (const mesh::PointArray& array : closed_.point_arrays) {
      surface.point_arrays.push_back({array.name, {}});
      for (const VertexId v : result.vertex) surface.point_arrays.back().values.push_back(array.values[v]);
    }
    for (const FaceId f : closed_.faces.ids()) {
      if (!stays(f)) continue;
      const auto& v = closed_.faces[f];
      surface.faces.push_back({number[v[0]], number[v[1]], number[v[2]]});
      surface.face_patch.push_back(closed_.face_patch[f]);
      result.face.push_back(f);
    }
  }

  void mark_planes(OpenWall& result) const {
    mesh::SidePlanes& planes = result.planes;
    if (planes.empty()) return;
    IdVector<VertexId, std::array<mesh::PlaneIndex, 3>> of_closed(closed_.points.size(),
                                                                  {mesh::kNoPlane, mesh::kNoPlane, mesh::kNoPlane});
    for (RegionIndex r = 0; r < regions_.size(); ++r) {
      if (!lands_[r]) continue;
      const mesh::PlaneIndex plane = plane_number_[r];
      for (const FaceId f : regions_[r].faces) {
        for (const VertexId v : closed_.faces[f]) {
          auto& all = of_closed[v];
          if (std::find(all.begin(), all.end(), plane) != all.end()) continue;
          // A fourth plane would change nothing: a vertex on three of them does not move.
          *std::max_element(all.begin(), all.end()) = std::min(plane, *std::max_element(all.begin(), all.end()));
          std::sort(all.begin(), all.end());
        }
      }
    }
    for (const VertexId v : result.vertex) planes.of_vertex.push_back(of_closed[v]);
    planes.of_edge.resize(3 * result.surface.faces.size(), mesh::kNoPlane);
    for (const FaceId f : result.face.ids()) {
      const auto& v = closed_.faces[result.face[f]];
      for (std::size_t k = 0; k < 3; ++k) {
        const RegionIndex r = region_at(v[(k + 1) % 3], v[k]);
        if (r != kNoRegion && lands_[r]) planes.of_edge[HalfedgeId(3 * f.index() + k)] = plane_number_[r];
      }
    }
  }

  /// Where the wall turns away from a plane or runs on in it, its lines stay.
  void hold_vertices(OpenWall& result) const {
    if (result.planes.empty()) return;
    std::vector<char> is_held(closed_.points.size(), 0);
    bool any = false;
    for_each_meeting([&](FaceId f, std::size_t k, RegionIndex r, bool lands) {
      if (lands || !lands_[r]) return;
      any = true;
      for (const VertexId v : {closed_.faces[f][k], closed_.faces[f][(k + 1) % 3]}) is_held[v.index()] = 1;
    });
    if (!any) return;
    for (const VertexId v : result.vertex) result.planes.is_held.push_back(is_held[v.index()]);
  }

  /// Vertices that are gone at which edges between planes end: where not just two planes meet, both along one line.
  void find_corners(OpenWall& result) const {
    if (result.planes.planes.size() < 3) return;
    // By vertex and planes: edges there, and those that leave it less those that arrive, in the first plane.
    struct Edges {
      int n = 0, balance = 0;
    };
    std::map<std::uint32_t, std::map<std::array<mesh::PlaneIndex, 2>, Edges>> seams;
    for (const SideEdge& edge : edges_) {
      const RegionIndex other = region_at(VertexId(edge.to), VertexId(edge.from));
      if (other == kNoRegion || !lands_[edge.region] || !lands_[other]) continue;
      // Edges between cuts of a body run within it.
      if (is_cut_of_body(regions_[edge.region]) || is_cut_of_body(regions_[other])) continue;
      const mesh::PlaneIndex p = plane_number_[edge.region], q = plane_number_[other];
      if (p >= q) continue;
      Edges &from = seams[edge.from][{p, q}], &to = seams[edge.to][{p, q}];
      ++from.n, --from.balance;
      ++to.n, ++to.balance;
    }
    for (const VertexId v : result.vertex) seams.erase(v.index());
    for (const auto& [v, pairs] : seams) {
      mesh::PlaneCorner corner{closed_.points[VertexId(v)], {}};
      for (const auto& [pair, edges] : pairs) {
        if (edges.n == 1) corner.edges.push_back({pair, edges.balance});
      }
      if (!corner.edges.empty()) result.planes.corners.push_back(corner);
    }
  }

  const mesh::SurfaceMesh& closed_;
  const std::vector<SideRegion>& regions_;
  const IdVector<FaceId, char>& is_wetted_;
  const OpenWallOptions& options_;
  std::vector<mesh::SidePlane> planes_;  // (n_regions) into the domain
  IdVector<FaceId, RegionIndex> region_of_;
  std::vector<SideEdge> edges_;
  std::vector<char> lands_;
  std::vector<mesh::PlaneIndex> plane_number_;
  std::vector<std::string> notes_;
};

[[noreturn]] void refuse_place(const mesh::SidePlane& plane, const Vec3& p, const char* what) {
  const double at = plane.axis >= 0 ? plane.offset * plane.normal[plane.axis] : plane.offset;
  throw GeometryError(fmt::format("the surface {} its plane of symmetry{} at ({:.6g}, {:.6g}, {:.6g})", what,
                                  plane.axis >= 0 ? fmt::format(" {} = {:.6g}", "xyz"[plane.axis], at) : "", p.x(),
                                  p.y(), p.z()));
}

/// Where a cut body is in touch with its plane of symmetry elsewhere than at its cut the fluid beside it has no room.
void require_one_side(const mesh::SurfaceMesh& surface, const mesh::SidePlanes& planes,
                      const std::vector<SideRole>& role) {
  for (mesh::PlaneIndex p = 0; p < planes.planes.size(); ++p) {
    const mesh::SidePlane& plane = planes.planes[p];
    if (role[p] != SideRole::Symmetry || plane.axis < 0) continue;
    for (const VertexId v : surface.points.ids()) {
      const double height = plane.height(surface.points[v]);
      if (height < 0) refuse_place(plane, surface.points[v], "lies on both sides of");
      if (height == 0 && !planes.is_on(v, p)) refuse_place(plane, surface.points[v], "touches");
    }
    for (const FaceId f : surface.faces.ids()) {
      for (std::size_t k = 0; k < 3; ++k) {
        const VertexId a = surface.faces[f][k], b = surface.faces[f][(k + 1) % 3];
        if (planes.of_edge[HalfedgeId(3 * f.index() + k)] != mesh::kNoPlane) continue;
        if (planes.is_on(a, p) && planes.is_on(b, p)) {
          refuse_place(plane, (surface.points[a] + surface.points[b]) * 0.5, "touches");
        }
      }
    }
  }
}

}  // namespace

OpenWall open_at_sides(const mesh::SurfaceMesh& closed, const std::vector<SideRegion>& regions,
                       const IdVector<FaceId, char>& is_wetted, const OpenWallOptions& options) {
  OpenWall wall = Opening(closed, regions, is_wetted, options).open();
  if (options.fluid == FluidSide::Outside) require_one_side(wall.surface, wall.planes, wall.role);
  return wall;
}

}  // namespace nearwall::surface
