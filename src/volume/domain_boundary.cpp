#include "nearwall/volume/domain_boundary.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "nearwall/geometry/box.h"
#include "nearwall/geometry/measures.h"
#include "nearwall/mesh/cell.h"
#include "nearwall/mesh/side_face.h"

namespace nearwall::volume {

namespace {

using mesh::FaceNodes;
using mesh::kNoNode;

class BoundaryBuilder {
 public:
  BoundaryBuilder(const mesh::LayerMesh& layers, const certify::CertifiedWall& wall, const PatchOnPlane& patch_of)
      : layers_(layers), wall_(wall), patch_of_(patch_of) {}

  /// \param is_all  also triangles that have no cell of the layers
  void add_wall(bool is_all) {
    for (const FaceId f : wall_.surface.faces.ids()) {
      if (!wall_.face_component[f].is_valid()) continue;
      const FrontFaceId column(f.index());
      if (!is_all && layers_.column_offset(column) == layers_.column_end(column)) continue;
      const auto& v = wall_.surface.faces[f];
      const auto point = [&](VertexId w) { return number(w.index(), wall_.surface.points[w]); };
      const std::uint32_t a = point(v[0]), b = point(v[1]), c = point(v[2]);
      add({a, c, b, kNoNode}, wall_.surface.face_patch[f], f, mesh::kNoPlane);
    }
  }

  void add_sides() {
    if (!wall_.planes || wall_.planes->empty()) return;
    const auto front = certify::front_surface(layers_.front(), layers_.lines());
    const auto traces = certify::plane_traces(layers_.front(), *wall_.planes, front);
    for (mesh::PlaneIndex p = 0; p < traces.size(); ++p) {
      // A trace runs along the front with the rest of the plane to its left: the other way round than the wall's edge.
      for (const certify::TraceEdge& edge : traces[p]) add_side(p, LineId(edge.points[1]), LineId(edge.points[0]));
    }
  }

  void add_rest(const RestBoundary& rest, const HybridMesh& mesh) {
    for (std::size_t t = rest.n_front; t < rest.surface.triangles.size(); ++t) {
      FaceNodes face{0, 0, 0, kNoNode};
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t p = rest.surface.triangles[t][k];
        face[k] = number(mesh.node(p), rest.surface.points[p]);
      }
      const mesh::PlaneIndex plane = rest.rest_plane[t - rest.n_front];
      add(face, patch_of_(plane, middle_of(face)), FaceId(), plane);
    }
  }

  void add_front(PatchId patch) {
    const auto front = certify::front_surface(layers_.front(), layers_.lines());
    for (const auto& triangle : front.triangles) {
      if (std::none_of(triangle.begin(), triangle.end(), [&](std::uint32_t p) { return front.is_moved[p]; })) continue;
      FaceNodes face{0, 0, 0, kNoNode};
      for (std::size_t k = 0; k < 3; ++k) {
        face[k] = number(node_of_front(layers_, triangle[k]), front.points[triangle[k]]);
      }
      add(face, patch, FaceId(), mesh::kNoPlane);
    }
  }

  DomainBoundary take() { return std::move(boundary_); }

 private:
  std::uint32_t number(NodeIndex node, const Vec3& position) {
    const auto [found, is_new] = number_.emplace(node, static_cast<std::uint32_t>(boundary_.points.size()));
    if (is_new) {
      boundary_.node.push_back(node);
      boundary_.points.push_back(position);
    }
    return found->second;
  }

  std::uint32_t number(LineId line, Level level) {
    return number(layers_.node(line, level), layers_.lines().position(line, level));
  }

  Vec3 middle_of(const FaceNodes& face) const {
    Vec3 sum;
    const int n = mesh::size_of(face);
    for (int k = 0; k < n; ++k) sum += boundary_.points[face[static_cast<std::size_t>(k)]];
    return sum / n;
  }

  void add(const FaceNodes& face, PatchId patch, FaceId wall_face, mesh::PlaneIndex plane) {
    boundary_.faces.push_back(face);
    boundary_.patch.push_back(patch);
    boundary_.wall_face.push_back(wall_face);
    boundary_.plane.push_back(plane);
  }

  void add_side(mesh::PlaneIndex plane, LineId a, LineId b) {
    const auto [first, last] = mesh::level_range(layers_.lines(), a, b);
    for (Level j = first; j < last; ++j) {
      const mesh::SideFace side = mesh::side_face(layers_.front(), layers_.lines(), a, b, j);
      if (side.size < 3) continue;
      FaceNodes face{kNoNode, kNoNode, kNoNode, kNoNode};
      for (std::size_t k = 0; k < static_cast<std::size_t>(side.size); ++k) {
        face[k] = number(side.nodes[k].line, side.nodes[k].level);
      }
      add(face, patch_of_(plane, middle_of(face)), FaceId(), plane);
    }
  }

  const mesh::LayerMesh& layers_;
  const certify::CertifiedWall& wall_;
  const PatchOnPlane& patch_of_;
  std::unordered_map<NodeIndex, std::uint32_t> number_;
  DomainBoundary boundary_;
};

bool is_turned(const DomainBoundary& boundary, std::size_t face, const mesh::SidePlane& plane) {
  const auto n = static_cast<std::size_t>(boundary.size_of(face));
  std::array<Vec3, 4> corners;
  for (std::size_t k = 0; k < n; ++k) corners[k] = boundary.points[boundary.faces[face][k]];
  return certify::is_turned({corners.data(), n}, plane);
}

}  // namespace

double DomainCertificate::closure() const {
  return summed_volume > 0 ? std::abs(cells_volume - enclosed_volume) / summed_volume : 0;
}

DomainBoundary domain_boundary(const mesh::LayerMesh& layers, const certify::CertifiedWall& wall,
                               const RestBoundary& rest, const HybridMesh& mesh, const PatchOnPlane& patch_of) {
  BoundaryBuilder builder(layers, wall, patch_of);
  builder.add_wall(true);
  builder.add_sides();
  builder.add_rest(rest, mesh);
  return builder.take();
}

DomainBoundary layers_boundary(const mesh::LayerMesh& layers, const certify::CertifiedWall& wall, PatchId front,
                               const PatchOnPlane& patch_of) {
  BoundaryBuilder builder(layers, wall, patch_of);
  builder.add_wall(false);
  builder.add_sides();
  builder.add_front(front);
  return builder.take();
}

mesh::Boundary mesh_boundary(const DomainBoundary& boundary, IdVector<PatchId, mesh::BoundaryPatch> patches) {
  mesh::Boundary result;
  result.faces.reserve(boundary.faces.size());
  for (const FaceNodes& face : boundary.faces) {
    mesh::BoundaryFace nodes{0, 0, 0, mesh::kNoFourthNode};
    for (std::size_t k = 0; k < static_cast<std::size_t>(mesh::size_of(face)); ++k) nodes[k] = boundary.node[face[k]];
    result.faces.push_back(nodes);
  }
  result.patch = boundary.patch;
  result.patches = std::move(patches);
  return result;
}

DomainCertificate certify_domain(const DomainBoundary& boundary, const mesh::SidePlanes* planes, double layers_volume,
                                 const Fill& fill) {
  DomainCertificate result;
  const Vec3 centre = geometry::bounding_box(boundary.points).centre();
  geometry::CompensatedSum cells, cones, sizes;
  for (std::size_t f = 0; f < boundary.faces.size(); ++f) {
    if (boundary.plane[f] != mesh::kNoPlane) {
      ++result.n_side_faces;
      if (is_turned(boundary, f, planes->planes[boundary.plane[f]])) ++result.n_bad_side_faces;
    }
    const Vec3& first = boundary.points[boundary.faces[f][0]];
    for (int k = 1; k + 1 < boundary.size_of(f); ++k) {
      const Vec3& second = boundary.points[boundary.faces[f][static_cast<std::size_t>(k)]];
      const Vec3& third = boundary.points[boundary.faces[f][static_cast<std::size_t>(k + 1)]];
      const double cone = dot(cross(second - first, third - first), first - centre) / 6;
      cones.add(cone);
      sizes.add(std::abs(cone));
    }
  }
  cells.add(layers_volume);
  for (const auto& t : fill.tetrahedra) {
    const std::array<Vec3, 4> p = {fill.points[t[0]], fill.points[t[1]], fill.points[t[2]], fill.points[t[3]]};
    cells.add(mesh::cell_volume(mesh::CellType::Tetrahedron, p));
  }
  result.cells_volume = cells.value();
  result.enclosed_volume = cones.value();
  result.summed_volume = sizes.value();
  return result;
}

}  // namespace nearwall::volume
