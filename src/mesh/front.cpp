#include "nearwall/mesh/front.h"

#include <numeric>

namespace nearwall::mesh {

Front plain_front(const SurfaceMesh& wall) {
  Front front;
  front.first_line.resize(wall.points.size() + 1);
  std::iota(front.first_line.begin(), front.first_line.end(), 0u);
  front.line_vertex.reserve(wall.points.size());
  for (const VertexId v : wall.points.ids()) front.line_vertex.push_back(v);
  front.faces.reserve(wall.faces.size());
  for (const auto& face : wall.faces) {
    front.faces.push_back({{LineId(face[0].index()), LineId(face[1].index()), LineId(face[2].index()), LineId()}});
  }
  front.n_wall_faces = wall.faces.size();
  return front;
}

}  // namespace nearwall::mesh
