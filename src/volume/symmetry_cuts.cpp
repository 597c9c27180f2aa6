#include "nearwall/volume/symmetry_cuts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "nearwall/certify/flat_edges.h"
#include "nearwall/core/errors.h"
#include "nearwall/geometry/box.h"
#include "nearwall/mesh/seams.h"
#include "nearwall/planar/crossing_edges.h"
#include "nearwall/planar/region.h"

namespace nearwall::volume {

namespace {

/// Distance over the diagonal of the surface up to which an open vertex lies on a plane.
constexpr double kOnPlane = 1e-5;

/// … or over the largest coordinate: four roundings to single precision.
constexpr double kFloatRounding = 0x1p-22;

using Edge = std::array<std::uint32_t, 2>;

/// A directed edge of one face only.
struct OpenEdge {
  Edge edge{};
  FaceId face;
  friend bool operator<(const OpenEdge& a, const OpenEdge& b) { return a.edge < b.edge; }
};

/// Directed edges of faces that no other face runs along the other way.
std::vector<OpenEdge> open_edges(const mesh::SurfaceMesh& surface) {
  std::vector<OpenEdge> all, reversed, open;
  for (const FaceId f : surface.faces.ids()) {
    const auto& v = surface.faces[f];
    for (std::size_t k = 0; k < 3; ++k) {
      all.push_back({{v[k].index(), v[(k + 1) % 3].index()}, f});
      reversed.push_back({{all.back().edge[1], all.back().edge[0]}, f});
    }
  }
  std::sort(all.begin(), all.end());
  std::sort(reversed.begin(), reversed.end());
  std::set_difference(all.begin(), all.end(), reversed.begin(), reversed.end(), std::back_inserter(open));
  return open;
}

class CutCloser {
 public:
  CutCloser(const mesh::SurfaceMesh& surface, const std::vector<CutPlane>& planes)
      : planes_(planes), box_(geometry::bounding_box(surface.points.raw())), open_(open_edges(surface)) {
    result_.surface = surface;
    tolerance_ =
        std::max(kOnPlane * box_.diagonal(), kFloatRounding * std::max(max_norm(box_.low), max_norm(box_.high)));
    for (const CutPlane& plane : planes) result_.at.push_back(position_of(plane));
    result_.caps.resize(planes.size(), 0);
  }

  CutClosing close() {
    move_vertices();
    sort_edges();
    const mesh::Seams seams = mesh::find_seams(points(), sides_, edges_);
    for (const Vec3& corner : seams.corners) result_.surface.points.push_back(corner);
    for (mesh::PointArray& array : result_.surface.point_arrays) {
      // On a cap nothing is asked for.
      array.values.resize(result_.surface.points.size(), 1.0);
    }
    for (const auto& [first, second, ends] : seams.seams) {
      edges_[first].push_back(ends);
      edges_[second].push_back({ends[1], ends[0]});
    }
    for (std::size_t p = 0; p < planes_.size(); ++p) fill(p);
    return std::move(result_);
  }

 private:
  const std::vector<Vec3>& points() const { return result_.surface.points.raw(); }

  /// The side of the surface's box with more open vertices, and the middle one of their coordinates.
  double position_of(const CutPlane& plane) const {
    if (plane.at) return *plane.at;
    std::array<std::vector<double>, 2> found;
    for (const auto& [edge, face] : open_) {
      const double x = points()[edge[0]][plane.axis];
      if (x - box_.low[plane.axis] <= tolerance_) found[0].push_back(x);
      if (box_.high[plane.axis] - x <= tolerance_) found[1].push_back(x);
    }
    std::vector<double>& most = found[0].size() >= found[1].size() ? found[0] : found[1];
    if (most.empty()) return 0;
    const auto middle = most.begin() + static_cast<std::ptrdiff_t>(most.size() / 2);
    std::nth_element(most.begin(), middle, most.end());
    return *middle;
  }

  bool is_on(std::uint32_t point, std::size_t p) const {
    return std::abs(points()[point][planes_[p].axis] - result_.at[p]) <= tolerance_;
  }

  void move_vertices() {
    for (const auto& [edge, face] : open_) {
      for (std::size_t p = 0; p < planes_.size(); ++p) {
        if (!is_on(edge[0], p)) continue;
        double& x = result_.surface.points[VertexId(edge[0])][planes_[p].axis];
        result_.farthest_move = std::max(result_.farthest_move, std::abs(x - result_.at[p]));
        x = result_.at[p];
      }
    }
  }

  /// Seen from the body, to whose other side the caps look.
  void sort_edges() {
    for (std::size_t p = 0; p < planes_.size(); ++p) {
      mesh::SidePlane side;
      side.axis = planes_[p].axis;
      const bool is_above = box_.centre()[side.axis] >= result_.at[p];
      side.normal[side.axis] = is_above ? -1 : 1;
      side.offset = side.normal[side.axis] * result_.at[p];
      sides_.push_back(side);
    }
    edges_.resize(planes_.size());
    for (const auto& [edge, face] : open_) {
      if (const auto p = plane_of(edge, face)) edges_[*p].push_back({edge[1], edge[0]});
    }
  }

  /// Of an edge on two planes: that in which the body lies beside it, behind the face.
  std::optional<std::size_t> plane_of(const Edge& edge, FaceId face) const {
    std::vector<std::size_t> on;
    for (std::size_t p = 0; p < planes_.size(); ++p) {
      if (is_on(edge[0], p) && is_on(edge[1], p)) on.push_back(p);
    }
    if (on.empty()) return std::nullopt;
    if (on.size() == 1) return on.front();
    const auto [a, b, c] = result_.surface.triangle(face);
    // Away from the other plane, into the half space of the body, and there against the normal of the face.
    const bool is_in_first = dot(sides_[on[1]].normal, cross(b - a, c - a)) > 0;
    return is_in_first ? on[0] : on[1];
  }

  [[noreturn]] void refuse(std::size_t p, std::uint32_t point, const char* what) const {
    const Vec3& x = points()[point];
    throw GeometryError(fmt::format(
        "the open edges on the plane of symmetry {} = {:.6g} {} at ({:.6g}, {:.6g}, {:.6g}); look at the surface there",
        "xyz"[planes_[p].axis], result_.at[p], what, x.x(), x.y(), x.z()));
  }

  void fill(std::size_t p) {
    if (edges_[p].empty()) return;
    const certify::FlatEdges flat(sides_[p], edges_[p], points());
    const auto crossing = planar::crossing_edges(flat.points, flat.edges);
    if (!crossing.empty()) refuse(p, edges_[p][crossing.front().first][0], "meet each other");
    const planar::RegionTriangulation cap = planar::triangulate_region(flat.points, flat.edges);
    if (!cap.contradicting_edges.empty()) {
      refuse(p, edges_[p][cap.contradicting_edges.front()][0], "do not go round a cut");
    }
    mesh::SurfaceMesh& surface = result_.surface;
    const PatchId patch = patch_of(planes_[p].patch);
    for (const auto& [a, b, c] : cap.triangles) {
      surface.faces.push_back({VertexId(flat.original[a]), VertexId(flat.original[b]), VertexId(flat.original[c])});
      surface.face_patch.push_back(patch);
    }
    result_.caps[p] = cap.triangles.size();
  }

  PatchId patch_of(const std::string& name) {
    auto& names = result_.surface.patch_names;
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return PatchId(static_cast<std::size_t>(found - names.begin()));
    return names.push_back(name);
  }

  const std::vector<CutPlane>& planes_;
  geometry::Box box_;
  std::vector<OpenEdge> open_;
  double tolerance_ = 0;
  std::vector<mesh::SidePlane> sides_;
  mesh::PlaneEdges edges_;
  CutClosing result_;
};

}  // namespace

CutClosing close_cuts(const mesh::SurfaceMesh& surface, const std::vector<CutPlane>& planes) {
  return CutCloser(surface, planes).close();
}

}  // namespace nearwall::volume
