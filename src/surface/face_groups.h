#pragma once

#include <span>
#include <vector>

#include "nearwall/surface/admission.h"
#include "surface/edge_groups.h"

namespace nearwall::surface {

/// What a triangle is beside the others with the same three corners.
enum class Copy : char {
  None,     ///< the only one, or the first of several
  Same,     ///< runs the same way round as an earlier one
  Reversed  ///< runs the other way round than all earlier ones
};

struct Copies {
  IdVector<FaceId, Copy> kind;        ///< (n_faces)
  IdVector<FaceId, FaceId> original;  ///< (n_faces) first triangle with the same corners, itself if it has none
};

/// Triangles with a repeated corner are never copies.    Cost: O(n log n)
Copies find_copies(const mesh::SurfaceMesh& surface);

/// Component of each face: faces that share a point have the same one. Numbered in the order of their first face.
/// Cost: O(n)
IdVector<FaceId, ComponentId> find_components(const mesh::SurfaceMesh& surface, std::size_t& n_components);

/// A vertex round which the triangles form more than one fan.
struct PinchedVertex {
  VertexId vertex;
  std::vector<FaceId> faces;
};

/// Fans are linked across any edge, also one with more than two triangles, which is a fault of its own.    Cost: O(n)
std::vector<PinchedVertex> find_pinched_vertices(const mesh::SurfaceMesh& surface, const EdgeGroups& edges,
                                                 std::span<const char> is_left_out);

/// Which faces have to be turned round for all neighbours across edges of two triangles to agree. Of the two ways for
/// each set of linked faces that with fewer turns is taken. Faces of one-sided sets are left as they are. \returns
/// (n_faces) 1: turn round    Cost: O(n)
std::vector<char> find_turns(const mesh::SurfaceMesh& surface, const EdgeGroups& edges);

/// Whether the two triangles of an edge run along it in the same direction, that is, disagree.
bool disagree(const mesh::SurfaceMesh& surface, std::span<const HalfedgeId> edge_of_two);

}  // namespace nearwall::surface
