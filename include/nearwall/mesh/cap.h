#pragma once

#include <array>
#include <optional>
#include <span>

#include "nearwall/mesh/cell.h"
#include "nearwall/mesh/front.h"
#include "nearwall/mesh/lines.h"

namespace nearwall::mesh {

/// The pyramid on the outer end of a virtual quad, which leaves triangles only to whatever fills the rest. It is no
/// layer: its apex belongs to no line.
struct Cap {
  std::array<LineNode, 4> base;  ///< ends of the four lines, counterclockwise seen from the apex
  std::array<Vec3, 5> corners;   ///< of the base, then the apex: the one source of its coordinates
};

/// Whether the virtual face ends in a quad: it is one, and the lines of both its vertices move.
bool has_cap(const Front& front, const Lines& lines, FrontFaceId face);

/// nullopt without a cap.
std::optional<Cap> cap_over(const Front& front, const Lines& lines, FrontFaceId face);

/// Apex over a quad: over its centre, a quarter of its narrower width above it and above the planes of its four
/// corners, so that the pyramid is positive on a warped quad, too.
Vec3 cap_apex(std::span<const Vec3, 4> base);

}  // namespace nearwall::mesh
