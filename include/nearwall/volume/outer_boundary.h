#pragma once

#include "nearwall/surface/open_wall.h"
#include "nearwall/volume/far_field.h"

namespace nearwall::volume {

/// Adds the far field to a wall: its faces belong to no face of the closed surface, its patches follow the others, and
/// its edges lie on the planes of symmetry. Planes on which the wall has no edge are added, too.
/// \throws InputError  if the wall does not lie within the far field, or one of the planes goes through it
void add_far_field(const FarField& far_field, surface::OpenWall& wall);

}  // namespace nearwall::volume
