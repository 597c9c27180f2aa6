#pragma once

#include <filesystem>
#include <functional>

#include "nearwall/io/polydata_writer.h"
#include "nearwall/mesh/boundary.h"

namespace nearwall::io {

/// Where the boundary of a mesh stands whose format holds cells alone: NAME-boundary.vtp beside NAME.vtu.
std::filesystem::path boundary_file_of(const std::filesystem::path& mesh);

/// A boundary as a file of polygons, triangles first, each in the boundary's order. Point array `Node`: their numbers
/// in the mesh; cell array `Patch`; field data `PatchNames` and `PatchTypes` (kBoundaryTypeNames). \param position  of
/// a node of the mesh
PolyDataFile boundary_polydata(const mesh::Boundary& boundary, const std::function<Vec3(NodeIndex)>& position);

/// Reads such a file; without PatchTypes all types are Other.
/// \param n_points  of the mesh
/// \throws GeometryError  it is none, or has nodes that the mesh has not; InputError, IoError as read_surface
mesh::Boundary read_boundary(const std::filesystem::path& path, NodeIndex n_points);

}  // namespace nearwall::io
