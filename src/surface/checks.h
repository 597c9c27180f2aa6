#pragma once

#include <vector>

#include "surface/edge_groups.h"
#include "surface/faults.h"

namespace nearwall::surface {

/// Triangles that later checks pass over, so that one fault is not told twice.
struct LeftOut {
  std::vector<char> of_topology;  ///< (n_faces) with a repeated corner, or an exact copy of an earlier one
  std::vector<char> of_geometry;  ///< (n_faces) those, and triangles that are not finite or have no area
};

/// Triangles one by one: coordinates, areas, copies.    Cost: O(n log n)
LeftOut check_triangles(const mesh::SurfaceMesh& surface, FaultCollector& faults);

struct EdgeCounts {
  std::vector<HalfedgeId> open;  ///< halfedges without a partner
  std::size_t n_crowded = 0;     ///< edges of more than two triangles
};

/// Edges of one triangle, of more than two, and of two that disagree about their orientation.    Cost: O(n)
EdgeCounts check_edges(const mesh::SurfaceMesh& surface, const EdgeGroups& edges, FaultCollector& faults);

/// Vertices where several fans of triangles touch.    Cost: O(n)
void check_vertices(const mesh::SurfaceMesh& surface, const EdgeGroups& edges, const LeftOut& left_out,
                    FaultCollector& faults);

/// Pairs of triangles that meet where they should not.    Cost: O(n log n + pairs)
void check_intersections(const mesh::SurfaceMesh& surface, const LeftOut& left_out, FaultCollector& faults);

}  // namespace nearwall::surface
