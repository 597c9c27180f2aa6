#include "pipeline/domain.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include <fmt/format.h>

#include "nearwall/certify/certificate.h"
#include "nearwall/core/errors.h"
#include "nearwall/predicates/volume.h"
#include "nearwall/volume/outer_boundary.h"
#include "nearwall/volume/symmetry_cuts.h"

namespace nearwall::pipeline {

namespace {

using surface::SideRole;

/// Radius of the far field in diagonals of the surface unless another one is given.
constexpr double kFarFieldDiagonals = 50;

/// Largest edge of the far field's triangles over its radius: 20 make a great circle.
constexpr double kFarFieldSize = 0.3;

/// Distance over the diagonal of the surface up to which a plane asked for is one that is there.
constexpr double kSamePlane = 1e-4;

bool has_sides(const IdVector<PatchId, SideRole>& roles) {
  return std::any_of(roles.begin(), roles.end(), [](SideRole role) { return role != SideRole::None; });
}

/// What was made has a type, unless the case gives it another.
void add_rule(Case& settings, const std::string& patch, PatchType type) {
  PatchRule rule;
  rule.pattern = patch;
  rule.type = type;
  settings.patches.insert(settings.patches.begin(), rule);
}

IdVector<FaceId, char> wetted(const surface::Admission& admission) {
  IdVector<FaceId, char> is_wetted(admission.surface.faces.size(), 1);
  for (const FaceId f : is_wetted.ids()) is_wetted[f] = admission.components[admission.face_component[f]].is_wetted;
  return is_wetted;
}

surface::OpenWall closed_wall(surface::Admission& admission) {
  surface::OpenWall wall;
  wall.surface = std::move(admission.surface);
  for (const FaceId f : wall.surface.faces.ids()) wall.face.push_back(f);
  for (const VertexId v : wall.surface.points.ids()) wall.vertex.push_back(v);
  return wall;
}

std::vector<volume::SymmetryPlane> symmetry_planes(const surface::OpenWall& wall, const Case& settings) {
  std::vector<volume::SymmetryPlane> planes;
  for (std::size_t p = 0; p < wall.planes.planes.size(); ++p) {
    const mesh::SidePlane& plane = wall.planes.planes[p];
    if (wall.role[p] != SideRole::Symmetry) continue;
    if (plane.axis < 0) {
      throw InputError(
          "the plane of symmetry of an external flow has to be normal to x, y or z; turn the surface, or "
          "give the whole domain as a surface with fluid = \"inside\"");
    }
    const double sign = plane.normal[plane.axis];
    planes.push_back({plane.axis, plane.offset * sign, sign > 0 ? 1 : -1});
  }
  const geometry::Box box = geometry::bounding_box(wall.surface.points.raw());
  const Vec3 middle = box.centre();
  const double diagonal = box.diagonal();
  for (const SymmetrySetting& asked : settings.volume.symmetry) {
    const bool is_there = std::any_of(planes.begin(), planes.end(), [&](const auto& p) {
      return p.axis == asked.axis && (!asked.at || std::abs(p.position - *asked.at) <= kSamePlane * diagonal);
    });
    const double at = asked.at.value_or(0);
    if (!is_there) planes.push_back({asked.axis, at, middle[asked.axis] >= at ? 1 : -1});
  }
  return planes;
}

bool has_opposite_planes(const volume::FarField& far) {
  for (const auto& p : far.planes) {
    for (const auto& q : far.planes) {
      if (p.axis == q.axis && p.side != q.side) return true;
    }
  }
  return false;
}

volume::FarField far_field(const surface::OpenWall& wall, const Case& settings) {
  const FarFieldSettings& asked = settings.volume.far_field;
  const geometry::Box box = geometry::bounding_box(wall.surface.points.raw());
  volume::FarField far;
  far.shape = asked.shape == FarFieldShape::Box ? volume::FarFieldShape::Box : volume::FarFieldShape::Sphere;
  far.planes = symmetry_planes(wall, settings);
  // Between two planes there is no room for a sphere.
  if (has_opposite_planes(far)) far.shape = volume::FarFieldShape::Box;
  far.centre = asked.centre.value_or(box.centre());
  for (const auto& plane : far.planes) far.centre[plane.axis] = plane.position;
  far.radius = asked.radius.value_or(kFarFieldDiagonals * box.diagonal());
  const Vec3 half(far.radius, far.radius, far.radius);
  far.box = {asked.lower.value_or(far.centre - half), asked.upper.value_or(far.centre + half)};
  // As large as tetrahedra have grown on their way there: smaller ones would make them shrink again.
  const Vec3 size = far.box.high - far.box.low;
  const double extent = asked.lower ? 0.5 * std::max({size.x(), size.y(), size.z()}) : far.radius;
  far.size = asked.size.value_or(std::min(settings.volume.growth - 1, kFarFieldSize) * extent);
  return far;
}

/// The front at the wall, before any layer, closed over the planes. \param wrong  gets what is to blame if it is not
certify::FrontSurface closed_base(const surface::OpenWall& wall, std::vector<FrontFaceId>& wrong) {
  const mesh::SurfaceMesh& surface = wall.surface;
  certify::FrontSurface base;
  base.points = surface.points.raw();
  base.is_moved.resize(base.points.size(), 0);
  for (const VertexId v : surface.points.ids()) base.point_of_line.push_back(v.index());
  for (const FaceId f : surface.faces.ids()) {
    const auto& v = surface.faces[f];
    base.triangles.push_back({v[0].index(), v[1].index(), v[2].index()});
    base.face.push_back(FrontFaceId(f.index()));
  }
  wrong = certify::close_front(mesh::plain_front(surface), wall.planes, base);
  return base;
}

/// A face beside which the edges on sides do not close to loops; invalid if they do.
FaceId face_at_gap(const surface::OpenWall& wall) {
  std::vector<FrontFaceId> wrong;
  const certify::FrontSurface base = closed_base(wall, wrong);
  if (!wrong.empty()) return FaceId(wrong.front().index());
  return base.is_closed ? FaceId() : FaceId(0);
}

/// Hollows of bodies that a plane of symmetry cuts open: closed by the plane they hold fluid of their own, which the
/// far field does not reach. Their faces leave the domain.
void leave_hollows(surface::OpenWall& wall, std::size_t n_body_faces) {
  std::vector<FrontFaceId> wrong;
  const certify::FrontSurface base = closed_base(wall, wrong);
  if (!base.is_closed) return;
  std::vector<std::uint32_t> parent(base.points.size());
  std::iota(parent.begin(), parent.end(), std::uint32_t{0});
  const auto root = [&](std::uint32_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (const auto& t : base.triangles) {
    for (const std::uint32_t p : t) {
      const auto [low, high] = std::minmax({root(t[0]), root(p)});
      parent[high] = low;
    }
  }
  std::map<std::uint32_t, std::vector<std::uint32_t>> parts;
  for (std::uint32_t t = 0; t < base.triangles.size(); ++t) parts[root(base.triangles[t][0])].push_back(t);
  if (n_body_faces < wall.surface.faces.size()) parts.erase(root(base.triangles[n_body_faces][0]));
  std::size_t n_left = 0;
  for (const auto& [name, triangles] : parts) {
    const auto triangle = [&, &members = triangles](std::size_t i) {
      const auto& [p, q, r] = base.triangles[members[i]];
      return predicates::Triangle{base.points[p], base.points[q], base.points[r]};
    };
    // Seen from the fluid a body encloses a positive volume, fluid a negative one.
    if (predicates::enclosed_volume(triangles.size(), triangle).sign != predicates::Sign::Negative) continue;
    wall.is_cut_off.resize(wall.surface.faces.size(), 0);
    for (const std::uint32_t t : triangles) {
      if (t >= wall.surface.faces.size()) continue;
      const FaceId f(t);
      ++n_left;
      wall.is_cut_off[f] = 1;
      for (std::size_t k = 0; k < 3; ++k) {
        wall.planes.of_edge[HalfedgeId(3 * t + k)] = mesh::kNoPlane;
        wall.planes.of_vertex[wall.surface.faces[f][k]] = {mesh::kNoPlane, mesh::kNoPlane, mesh::kNoPlane};
      }
    }
  }
  if (n_left > 0) {
    wall.notes.push_back(fmt::format(
        "hollows behind planes of symmetry ({} triangles) are out of the fluid's reach and get no layers", n_left));
  }
}

std::string gap_text(const surface::OpenWall& wall, FaceId f) {
  const mesh::SurfaceMesh& surface = wall.surface;
  const Vec3& p = surface.points[surface.faces[f][0]];
  return fmt::format(
      "the edges of patch \"{}\" on the sides of the domain do not close to loops, near ({:.6g}, {:.6g}, {:.6g})",
      surface.patch_names[surface.face_patch[f]], p.x(), p.y(), p.z());
}

/// The wall without the sides on which its layers land; without any where these do not close.
surface::OpenWall opened(const Case& settings, const surface::Admission& admission,
                         const IdVector<PatchId, SideRole>& roles) {
  surface::OpenWallOptions options;
  options.fluid = settings.surface.fluid;
  for (const PatchType type : patch_types(settings, admission.surface.patch_names.raw())) {
    options.has_layers.push_back(has_layers(type) ? 1 : 0);
  }
  const auto regions = surface::find_side_regions(admission.surface, roles);
  surface::OpenWall wall = surface::open_at_sides(admission.surface, regions, wetted(admission), options);
  const bool is_inside = settings.surface.fluid == surface::FluidSide::Inside;
  const FaceId gap = is_inside && !wall.planes.empty() ? face_at_gap(wall) : FaceId();
  if (!gap.is_valid()) return wall;
  options.lands = false;
  surface::OpenWall closed = surface::open_at_sides(admission.surface, regions, wetted(admission), options);
  closed.notes = wall.notes;
  closed.notes.push_back(gap_text(wall, gap) + ": layers end at all sides, as beside nolayer");
  return closed;
}

}  // namespace

bool has_far_field(const Case& settings) {
  return settings.surface.fluid == surface::FluidSide::Outside &&
         (settings.volume.fill != Fill::None || !settings.volume.symmetry.empty());
}

IdVector<PatchId, SideRole> side_roles(const Case& settings, const mesh::SurfaceMesh& surface) {
  IdVector<PatchId, SideRole> roles;
  for (const PatchType type : patch_types(settings, surface.patch_names.raw())) {
    roles.push_back(type == PatchType::Symmetry ? SideRole::Symmetry
                    : is_side(type)             ? SideRole::Opening
                                                : SideRole::None);
  }
  return roles;
}

mesh::SurfaceMesh with_flat_sides(mesh::SurfaceMesh surface, Case& settings, std::vector<std::string>& notes) {
  if (!settings.volume.symmetry.empty()) {
    std::vector<volume::CutPlane> cuts;
    for (const SymmetrySetting& plane : settings.volume.symmetry) {
      const bool is_only = settings.volume.symmetry.size() == 1;
      cuts.push_back({plane.axis, plane.at, is_only ? "symmetry" : fmt::format("symmetry-{}", "xyz"[plane.axis])});
    }
    volume::CutClosing closing = volume::close_cuts(surface, cuts);
    for (std::size_t p = 0; p < cuts.size(); ++p) {
      if (closing.caps[p] == 0 && settings.surface.fluid == surface::FluidSide::Inside) {
        throw InputError(fmt::format(
            "{}: volume.symmetry: the surface is not open at {} = {:.6g}, and with fluid = \"inside\" it is the whole "
            "boundary of the domain; leave the key out, or give the patch that lies there type = \"symmetry\"",
            settings.file.string(), "xyz"[cuts[p].axis], closing.at[p]));
      }
      if (closing.caps[p] == 0) continue;
      add_rule(settings, cuts[p].patch, PatchType::Symmetry);
      notes.push_back(fmt::format("the surface is open at the plane of symmetry {} = {:.6g} and goes on beyond it",
                                  "xyz"[cuts[p].axis], closing.at[p]));
    }
    if (closing.farthest_move > 0) {
      notes.push_back(
          fmt::format("open edges were moved onto the planes of symmetry, by {:.3g} at most", closing.farthest_move));
    }
    surface = std::move(closing.surface);
  }
  const auto roles = side_roles(settings, surface);
  if (!has_sides(roles)) return surface;
  const double move = surface::flatten(surface::find_side_regions(surface, roles), surface);
  if (move > 0)
    notes.push_back(fmt::format("points of flat sides were moved onto their planes, by {:.3g} at most", move));
  return surface;
}

surface::OpenWall open_wall(Case& settings, surface::Admission& admission) {
  const auto roles = side_roles(settings, admission.surface);
  surface::OpenWall wall;
  if (has_sides(roles)) {
    wall = opened(settings, admission, roles);
  } else {
    wall = closed_wall(admission);
  }
  const bool is_cut = settings.surface.fluid == surface::FluidSide::Outside && !wall.planes.empty();
  if (has_far_field(settings) || is_cut) {
    const std::size_t n_patches = wall.surface.patch_names.size(), n_faces = wall.surface.faces.size();
    const volume::FarField far = far_field(wall, settings);
    if (has_opposite_planes(far) && settings.volume.far_field.shape == FarFieldShape::Sphere) {
      wall.notes.push_back("between two planes of symmetry there is no room for a sphere: the far field is a box");
    }
    volume::add_far_field(far, wall);
    if (!wall.planes.empty()) leave_hollows(wall, n_faces);
    for (std::size_t p = n_patches; p < wall.surface.patch_names.size(); ++p) {
      const bool is_plane = std::find(wall.patch.begin(), wall.patch.end(), PatchId(p)) != wall.patch.end();
      add_rule(settings, wall.surface.patch_names[PatchId(p)], is_plane ? PatchType::Symmetry : PatchType::FarField);
    }
  }
  const FaceId gap = wall.planes.empty() ? FaceId() : face_at_gap(wall);
  if (!gap.is_valid()) return wall;
  throw GeometryError(
      gap_text(wall, gap) +
      "; look whether its open edges all lie on planes of symmetry, or give the sides another type than "
      "symmetry, inlet, outlet");
}

void require_domain(const surface::OpenWall& wall, const mesh::Topology& topology,
                    const IdVector<FaceId, char>& is_wetted, bool fluid_is_inside) {
  if (wall.planes.empty()) return;
  std::vector<FrontFaceId> wrong;
  const certify::FrontSurface base = closed_base(wall, wrong);
  const auto refuse = [&](FaceId f, const char* what) {
    const Vec3& p = wall.surface.points[wall.surface.faces[f][0]];
    throw GeometryError(fmt::format("patch \"{}\" {} near ({:.6g}, {:.6g}, {:.6g}); look at the surface there",
                                    wall.surface.patch_names[wall.surface.face_patch[f]], what, p.x(), p.y(), p.z()));
  };
  const auto meeting = certify::front_intersections(base);
  if (!meeting.empty()) refuse(FaceId(meeting.front().first.index()), "meets a side of the domain");
  auto component = mesh::connected_components(topology);
  for (const FaceId f : component.ids()) {
    if (!is_wetted[f]) component[f] = ComponentId();
  }
  const auto unreached = certify::covered_twice(mesh::plain_front(wall.surface), base, component, fluid_is_inside);
  if (unreached.empty()) return;
  for (const FaceId f : component.ids()) {
    if (component[f] == unreached.front()) refuse(f, "lies where the fluid does not reach");
  }
}

}  // namespace nearwall::pipeline
