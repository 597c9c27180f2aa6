#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>

#include "nearwall/surface/admission.h"
#include "nearwall/surface/open_wall.h"
#include "nearwall/surface/side_regions.h"
#include "tests/support/shapes.h"

/// Closed surfaces that are to be opened at planes.
namespace nearwall::closed_surfaces_for_tests {

using surface::FluidSide;
using surface::SideRole;

/// Roles of patches by their names.
using Roles = std::map<std::string, SideRole>;

/// Faces whose middle is chosen become a patch of their own.
template <class Chosen>
void paint(mesh::SurfaceMesh& surface, const std::string& patch, const Chosen& is_chosen) {
  const PatchId number = surface.patch_names.push_back(patch);
  for (const FaceId f : surface.faces.ids()) {
    const auto [a, b, c] = surface.triangle(f);
    if (is_chosen((a + b + c) / 3)) surface.face_patch[f] = number;
  }
}

inline IdVector<PatchId, SideRole> roles_of(const mesh::SurfaceMesh& surface, const Roles& roles) {
  IdVector<PatchId, SideRole> all;
  for (const std::string& name : surface.patch_names) {
    const auto found = roles.find(name);
    all.push_back(found == roles.end() ? SideRole::None : found->second);
  }
  return all;
}

/// A closed surface with what opens it.
struct Closed {
  mesh::SurfaceMesh surface;  ///< normals into the fluid
  IdVector<FaceId, char> is_wetted;
  IdVector<PatchId, SideRole> roles;
  surface::OpenWallOptions options;

  /// \param surface_in  normals outward \param bare  patches without layers and without a role
  Closed(mesh::SurfaceMesh surface_in, const Roles& named_roles, FluidSide fluid,
         const std::set<std::string>& bare = {}) {
    roles = roles_of(surface_in, named_roles);
    surface::flatten(surface::find_side_regions(surface_in, roles), surface_in);
    surface::Admission admission = surface::admit(std::move(surface_in), {fluid, surface::Repair::None});
    for (const FaceId f : admission.surface.faces.ids()) {
      is_wetted.push_back(admission.components[admission.face_component[f]].is_wetted ? 1 : 0);
    }
    surface = std::move(admission.surface);
    options.fluid = fluid;
    for (const PatchId p : roles.ids()) {
      options.has_layers.push_back(roles[p] == SideRole::None && !bare.contains(surface.patch_names[p]) ? 1 : 0);
    }
  }

  surface::OpenWall open() const {
    return surface::open_at_sides(surface, surface::find_side_regions(surface, roles), is_wetted, options);
  }
};

}  // namespace nearwall::closed_surfaces_for_tests
