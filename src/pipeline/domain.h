#pragma once

#include "nearwall/surface/open_wall.h"
#include "pipeline/prepare.h"

namespace nearwall::pipeline {

/// Whether the domain is bounded by a far field of our own.
bool has_far_field(const Case& settings);

/// What a patch is to the layers beside it.
IdVector<PatchId, surface::SideRole> side_roles(const Case& settings, const mesh::SurfaceMesh& surface);

/// Closes bodies that are cut open at planes of symmetry and moves flat sides onto their planes.
/// \param settings  gets rules for the patches that are made
/// \param notes     gets what was done
mesh::SurfaceMesh with_flat_sides(mesh::SurfaceMesh surface, Case& settings, std::vector<std::string>& notes);

/// Takes the sides on which layers land out of the admitted surface and adds the far field.
/// \param admission  its surface is moved where nothing is taken out
/// \throws GeometryError  if the sides do not close what they bound, InputError from the far field
surface::OpenWall open_wall(Case& settings, surface::Admission& admission);

/// Whether the domain is one before any layer is in it: what the sides close does not meet itself, and the fluid
/// reaches all that is to have layers. \throws GeometryError  if not, with a place
void require_domain(const surface::OpenWall& wall, const mesh::Topology& topology,
                    const IdVector<FaceId, char>& is_wetted, bool fluid_is_inside);

}  // namespace nearwall::pipeline
