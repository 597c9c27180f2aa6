#include "nearwall/mesh/front_part.h"

#include <gtest/gtest.h>

#include "tests/support/shapes.h"

namespace nearwall::mesh {
namespace {

/// A cube with three lines at every vertex and one virtual triangle on those of vertex 5.
Front three_lines_each(const SurfaceMesh& cube) {
  Front front;
  front.first_line.push_back(0);
  for (const VertexId v : cube.points.ids()) {
    for (int k = 0; k < 3; ++k) front.line_vertex.push_back(v);
    front.first_line.push_back(static_cast<std::uint32_t>(front.n_lines()));
  }
  for (const auto& face : cube.faces) {
    front.faces.push_back({{front.line_of(face[0]), front.line_of(face[1]), front.line_of(face[2]), {}}});
  }
  front.n_wall_faces = front.faces.size();
  front.faces.push_back({{LineId(15), LineId(16), LineId(17), {}}});
  return front;
}

TEST(FrontPart, TakesVerticesOverWithAllTheirLines) {
  const SurfaceMesh cube = shapes_for_tests::cube();
  const Front whole = three_lines_each(cube);
  FrontPart part(whole);
  const FrontFaceId taken(4), last(whole.faces.size() - 1);
  part.add(taken);
  EXPECT_EQ(part.front().n_wall_faces, 1u);
  EXPECT_EQ(part.front().n_lines(), 9u);
  for (std::size_t k = 0; k < 3; ++k) {
    const LineId line = part.front().faces[FrontFaceId(0)].lines[k];
    EXPECT_EQ(part.original_line()[line], whole.faces[taken].lines[k]);
    const VertexId v = part.front().line_vertex[line];
    EXPECT_EQ(part.original_vertex(v), cube.faces[FaceId(taken.index())][k]);
    EXPECT_EQ(part.front().n_lines(v), 3u);
  }
  const bool stands_on_5 = cube.faces[FaceId(4)][0] == VertexId(5) || cube.faces[FaceId(4)][1] == VertexId(5) ||
                           cube.faces[FaceId(4)][2] == VertexId(5);
  EXPECT_EQ(part.has_vertices_of(last), stands_on_5);
  part.add(last);
  EXPECT_TRUE(part.has_vertices_of(last));
  EXPECT_EQ(part.front().n_wall_faces, 1u);
  EXPECT_EQ(part.front().faces.size(), 2u);
}

}  // namespace
}  // namespace nearwall::mesh
