#include "nearwall/volume/outer_boundary.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "nearwall/core/errors.h"
#include "nearwall/geometry/measures.h"
#include "nearwall/mesh/topology.h"
#include "nearwall/search/self_intersection.h"

namespace nearwall::volume {

namespace {

mesh::SidePlane side_of(const SymmetryPlane& plane) {
  mesh::SidePlane side;
  side.axis = plane.axis;
  side.normal[plane.axis] = plane.side > 0 ? 1 : -1;
  side.offset = side.normal[plane.axis] * plane.position;
  return side;
}

/// A name that no patch has yet.
std::string unused(std::string name, const mesh::SurfaceMesh& surface) {
  const auto& names = surface.patch_names;
  const std::string stem = name;
  for (int i = 2; std::find(names.begin(), names.end(), name) != names.end(); ++i) name = fmt::format("{}-{}", stem, i);
  return name;
}

/// Number of a plane among those of the wall, to which it is added if it is not there.
/// \param patch  name of its patch then
mesh::PlaneIndex number_of(const mesh::SidePlane& side, const std::string& patch, surface::OpenWall& wall) {
  auto& planes = wall.planes.planes;
  const auto same = std::find_if(planes.begin(), planes.end(), [&](const mesh::SidePlane& p) {
    return p.normal == side.normal && p.offset == side.offset;
  });
  const auto number = static_cast<mesh::PlaneIndex>(same - planes.begin());
  if (same != planes.end()) return number;
  const mesh::SurfaceMesh& surface = wall.surface;
  for (const Vec3& p : surface.points) {
    if (side.height(p) > 0) continue;
    throw InputError(fmt::format(
        "the surface has to lie on one side of the plane of symmetry {} = {:.6g}, and ({:.6g}, {:.6g}, {:.6g}) does "
        "not; give the plane's place with volume.symmetry, or the type symmetry to the patch that lies on it",
        "xyz"[side.axis], side.offset * side.normal[side.axis], p.x(), p.y(), p.z()));
  }
  planes.push_back(side);
  wall.side_faces.emplace_back();
  wall.patch.push_back(wall.surface.patch_names.push_back(unused(patch, wall.surface)));
  wall.role.push_back(surface::SideRole::Symmetry);
  if (wall.planes.of_vertex.empty()) {
    wall.planes.of_vertex.resize(surface.points.size(), {mesh::kNoPlane, mesh::kNoPlane, mesh::kNoPlane});
    wall.planes.of_edge.resize(3 * surface.faces.size(), mesh::kNoPlane);
  }
  return number;
}

void mark(const mesh::SurfaceMesh& far, const std::vector<mesh::PlaneIndex>& numbers, mesh::SidePlanes& planes) {
  const auto is_on = [&](VertexId v, mesh::PlaneIndex p) { return planes.planes[p].height(far.points[v]) == 0; };
  for (const VertexId v : far.points.ids()) {
    std::array<mesh::PlaneIndex, 3> of{mesh::kNoPlane, mesh::kNoPlane, mesh::kNoPlane};
    std::size_t n = 0;
    for (const mesh::PlaneIndex p : numbers) {
      if (is_on(v, p)) of[n++] = p;
    }
    std::sort(of.begin(), of.end());
    planes.of_vertex.push_back(of);
  }
  const mesh::Topology topology(far);
  for (std::size_t i = 0; i < 3 * far.faces.size(); ++i) {
    const HalfedgeId h(i);
    mesh::PlaneIndex plane = mesh::kNoPlane;
    for (const mesh::PlaneIndex p : numbers) {
      if (!topology.twin(h).is_valid() && is_on(topology.origin(h), p) && is_on(topology.target(h), p)) plane = p;
    }
    planes.of_edge.push_back(plane);
  }
}

void append(const mesh::SurfaceMesh& far, surface::OpenWall& wall) {
  mesh::SurfaceMesh& surface = wall.surface;
  const std::size_t n_points = surface.points.size(), n_patches = surface.patch_names.size();
  for (const Vec3& p : far.points) {
    surface.points.push_back(p);
    wall.vertex.push_back(VertexId());
  }
  if (!wall.planes.is_held.empty()) wall.planes.is_held.resize(surface.points.size(), 0);
  for (mesh::PointArray& array : surface.point_arrays) array.values.resize(surface.points.size(), 0.0);
  for (const FaceId f : far.faces.ids()) {
    const auto& v = far.faces[f];
    surface.faces.push_back(
        {VertexId(n_points + v[0].index()), VertexId(n_points + v[1].index()), VertexId(n_points + v[2].index())});
    surface.face_patch.push_back(PatchId(n_patches + far.face_patch[f].index()));
    wall.face.push_back(FaceId());
  }
  for (const std::string& name : far.patch_names) surface.patch_names.push_back(unused(name, surface));
}

/// Whether all points lie in the sphere that touches the far field from within, if it is one.
bool is_within_sphere(const surface::OpenWall& wall, const FarField& far_field, const mesh::SurfaceMesh& far) {
  if (far_field.shape != FarFieldShape::Sphere) return true;
  double radius = far_field.radius;
  for (const FaceId f : far.faces.ids()) {
    const auto [a, b, c] = far.triangle(f);
    radius = std::min(radius, std::abs(dot(geometry::triangle_normal(a, b, c), a - far_field.centre)));
  }
  const auto& points = wall.surface.points;
  return std::all_of(points.begin(), points.end(),
                     [&](const Vec3& p) { return distance(p, far_field.centre) < radius; });
}

void require_enclosed(const surface::OpenWall& wall, std::size_t n_wall_faces) {
  const mesh::SurfaceMesh& surface = wall.surface;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<char> is_far;
  for (const FaceId f : surface.faces.ids()) {
    const auto& v = surface.faces[f];
    triangles.push_back({v[0].index(), v[1].index(), v[2].index()});
    is_far.push_back(f.index() >= n_wall_faces ? 1 : 0);
  }
  const auto meeting = search::self_intersections({surface.points.raw(), triangles}, is_far);
  if (meeting.empty()) return;
  const FaceId f(meeting.front().first);
  const Vec3& p = surface.points[surface.faces[f][0]];
  throw InputError(
      fmt::format("volume.farfield: the far field cuts or touches patch \"{}\" near ({:.6g}, {:.6g}, {:.6g}); if the "
                  "body ends there "
                  "in a plane of symmetry, give that patch type = \"symmetry\", else make the far field larger",
                  surface.patch_names[surface.face_patch[f]], p.x(), p.y(), p.z()));
}

}  // namespace

void add_far_field(const FarField& far_field, surface::OpenWall& wall) {
  const mesh::SurfaceMesh far = far_field_surface(far_field);
  std::vector<mesh::PlaneIndex> numbers;
  for (const SymmetryPlane& plane : far_field.planes) {
    const std::string patch =
        far_field.planes.size() > 1 ? fmt::format("symmetry-{}", "xyz"[plane.axis]) : std::string("symmetry");
    numbers.push_back(number_of(side_of(plane), patch, wall));
  }
  const std::size_t n_wall_faces = wall.surface.faces.size();
  const geometry::Box inner = geometry::bounding_box(wall.surface.points.raw());
  if (!geometry::bounding_box(far.points.raw()).contains(inner.low) ||
      !geometry::bounding_box(far.points.raw()).contains(inner.high) || !is_within_sphere(wall, far_field, far)) {
    throw InputError(fmt::format(
        "volume.farfield: the surface does not lie within the far field: it reaches from ({:.6g}, {:.6g}, {:.6g}) to "
        "({:.6g}, {:.6g}, {:.6g}), and the far field's triangles cut its corners; make it larger, or leave it to "
        "\"auto\"",
        inner.low.x(), inner.low.y(), inner.low.z(), inner.high.x(), inner.high.y(), inner.high.z()));
  }
  if (!wall.planes.empty()) mark(far, numbers, wall.planes);
  append(far, wall);
  require_enclosed(wall, n_wall_faces);
}

}  // namespace nearwall::volume
