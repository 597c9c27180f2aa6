#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "nearwall/mesh/surface_mesh.h"

namespace nearwall::mesh {

/// A face of the front: three lines, or four on a virtual quad. Counterclockwise seen from the fluid.
struct FrontFace {
  std::array<LineId, 4> lines;
  int size() const { return lines[3].is_valid() ? 4 : 3; }
};

/// The front as topology: its vertices are lines. Front faces 0 … n_wall_faces − 1 stand over the wall triangles of the
/// same number; virtual faces, of zero size at the wall, follow where a vertex owns several lines.
struct Front {
  std::vector<std::uint32_t> first_line;  ///< (n_vertices + 1): vertex v owns lines first_line[v] … first_line[v+1] − 1
  IdVector<LineId, VertexId> line_vertex;  ///< (n_lines)
  IdVector<FrontFaceId, FrontFace> faces;  ///< (n_front_faces)
  std::size_t n_wall_faces = 0;

  std::size_t n_lines() const { return line_vertex.size(); }
  std::size_t n_lines(VertexId v) const { return first_line[v.index() + std::size_t{1}] - first_line[v.index()]; }
  IdRange<LineId> lines_of(VertexId v) const { return {first_line[v.index()], first_line[v.index() + std::size_t{1}]}; }
  /// The first of its lines, which stands for the vertex where all of them would say the same.
  LineId line_of(VertexId v) const { return LineId(first_line[v.index()]); }
  bool is_wall(FrontFaceId f) const { return f.index() < n_wall_faces; }
};

/// The front with one line for each vertex: line i stands on vertex i, front face f over wall triangle f.
Front plain_front(const SurfaceMesh& wall);

}  // namespace nearwall::mesh
