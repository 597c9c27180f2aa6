#include <algorithm>
#include <unordered_map>

#include "nearwall/certify/certificate.h"
#include "nearwall/certify/flat_edges.h"
#include "nearwall/mesh/seams.h"
#include "nearwall/planar/crossing_edges.h"
#include "nearwall/planar/region.h"

namespace nearwall::certify {

namespace {

/// Edges of the front on each plane.
class Traces {
 public:
  Traces(const mesh::Front& front, const mesh::SidePlanes& planes, const FrontSurface& surface)
      : front_(front), planes_(planes), surface_(surface), of_plane_(planes.planes.size()) {
    for (const HalfedgeId h : planes.of_edge.ids()) {
      if (planes.of_edge[h] == mesh::kNoPlane) continue;
      const FrontFaceId f(h.index() / 3);
      const std::size_t k = h.index() % 3;
      add(planes.of_edge[h], f, front.faces[f].lines[k], front.faces[f].lines[(k + 1) % 3]);
    }
    for (std::size_t i = front.n_wall_faces; i < front.faces.size(); ++i) add_virtual(FrontFaceId(i));
  }

  std::vector<std::vector<TraceEdge>>& of_plane() { return of_plane_; }

 private:
  /// Between lines of one vertex on a plane: fans there end at the plane, so nothing else has such an edge.
  void add_virtual(FrontFaceId f) {
    const mesh::FrontFace& face = front_.faces[f];
    const auto n = static_cast<std::size_t>(face.size());
    for (std::size_t k = 0; k < n; ++k) {
      const LineId a = face.lines[k], b = face.lines[(k + 1) % n];
      const VertexId v = front_.line_vertex[a];
      if (front_.line_vertex[b] == v && planes_.is_on_plane(v)) add(planes_.of_vertex[v][0], f, a, b);
    }
  }

  void add(mesh::PlaneIndex plane, FrontFaceId f, LineId a, LineId b) {
    const std::uint32_t from = surface_.point_of_line[a], to = surface_.point_of_line[b];
    if (from != to) of_plane_[plane].push_back({{to, from}, f});
  }

  const mesh::Front& front_;
  const mesh::SidePlanes& planes_;
  const FrontSurface& surface_;
  std::vector<std::vector<TraceEdge>> of_plane_;
};

class Closer {
 public:
  Closer(const mesh::Front& front, const mesh::SidePlanes& planes, FrontSurface& surface)
      : planes_(planes), surface_(surface), traces_(plane_traces(front, planes, surface)) {
    for (const auto& trace : traces_) {
      for (const TraceEdge& edge : trace) {
        for (const std::uint32_t p : edge.points) faces_at_[p].push_back(edge.face);
      }
    }
  }

  std::vector<FrontFaceId> close() {
    add_seams();
    for (mesh::PlaneIndex p = 0; p < traces_.size() && surface_.is_closed; ++p) close_plane(p);
    std::sort(to_blame_.begin(), to_blame_.end());
    to_blame_.erase(std::unique(to_blame_.begin(), to_blame_.end()), to_blame_.end());
    if (surface_.is_closed) note_faces();
    return std::move(to_blame_);
  }

 private:
  void blame_point(std::uint32_t point) {
    for (const FrontFaceId f : faces_at_[point]) to_blame_.push_back(f);
  }

  void blame(const TraceEdge& edge) {
    if (edge.face.is_valid()) return to_blame_.push_back(edge.face);
    for (const std::uint32_t p : edge.points) blame_point(p);
  }

  void add_seams() {
    mesh::PlaneEdges edges(traces_.size());
    for (std::size_t p = 0; p < traces_.size(); ++p) {
      for (const TraceEdge& edge : traces_[p]) edges[p].push_back(edge.points);
    }
    const mesh::Seams seams = mesh::find_seams(surface_.points, planes_.planes, edges, planes_.corners);
    surface_.points.insert(surface_.points.end(), seams.corners.begin(), seams.corners.end());
    surface_.is_moved.resize(surface_.points.size(), 0);
    surface_.is_closed = seams.loose.empty();
    for (const std::uint32_t p : seams.loose) blame_point(p);
    for (const mesh::Seam& seam : seams.seams) {
      traces_[seam.first].push_back({seam.ends, FrontFaceId()});
      traces_[seam.second].push_back({{seam.ends[1], seam.ends[0]}, FrontFaceId()});
    }
  }

  void close_plane(mesh::PlaneIndex p) {
    const auto& trace = traces_[p];
    if (trace.empty()) return;
    std::vector<std::array<std::uint32_t, 2>> edges;
    for (const TraceEdge& edge : trace) edges.push_back(edge.points);
    const FlatEdges flat(planes_.planes[p], edges, surface_.points);
    for (const auto& [i, j] : planar::crossing_edges(flat.points, flat.edges)) {
      surface_.is_closed = false;
      blame(trace[i]);
      blame(trace[j]);
    }
    if (!surface_.is_closed) return;
    const planar::RegionTriangulation rest = planar::triangulate_region(flat.points, flat.edges);
    surface_.is_closed = rest.contradicting_edges.empty();
    for (const std::uint32_t edge : rest.contradicting_edges) blame(trace[edge]);
    for (const auto& [a, b, c] : rest.triangles) {
      surface_.triangles.push_back({flat.original[a], flat.original[b], flat.original[c]});
      surface_.rest_plane.push_back(p);
    }
  }

  /// For each triangle of the rest a face of the front beside each corner.
  void note_faces() {
    const std::size_t n_front = surface_.face.size();
    for (std::size_t t = n_front; t < surface_.triangles.size(); ++t) {
      std::array<FrontFaceId, 3> beside;
      for (std::size_t k = 0; k < 3; ++k) {
        for (const FrontFaceId f : faces_at_[surface_.triangles[t][k]]) {
          if (f.is_valid()) beside[k] = f;
        }
      }
      surface_.rest_beside.push_back(beside);
    }
  }

  const mesh::SidePlanes& planes_;
  FrontSurface& surface_;
  std::vector<std::vector<TraceEdge>> traces_;
  std::unordered_map<std::uint32_t, std::vector<FrontFaceId>> faces_at_;
  std::vector<FrontFaceId> to_blame_;
};

}  // namespace

std::vector<std::vector<TraceEdge>> plane_traces(const mesh::Front& front, const mesh::SidePlanes& planes,
                                                 const FrontSurface& surface) {
  return std::move(Traces(front, planes, surface).of_plane());
}

std::vector<FrontFaceId> close_front(const mesh::Front& front, const mesh::SidePlanes& planes, FrontSurface& surface) {
  if (planes.empty()) return {};
  return Closer(front, planes, surface).close();
}

}  // namespace nearwall::certify
