#include "nearwall/mesh/cell.h"

#include <vector>

#include <gtest/gtest.h>

namespace nearwall::mesh {
namespace {

// Corners of a box of 2 x 3 x 4 cut in the ways that its cells are: each holds its share of the 24.
const std::vector<Vec3> kBox = {{0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {0, 3, 0}, {0, 0, 4}, {2, 0, 4}, {2, 3, 4}, {0, 3, 4}};

std::vector<Vec3> corners(std::initializer_list<std::size_t> which) {
  std::vector<Vec3> p;
  for (const std::size_t i : which) p.push_back(kBox[i]);
  return p;
}

TEST(CellVolume, IsTheShareOfABox) {
  EXPECT_DOUBLE_EQ(cell_volume(CellType::Hexahedron, kBox), 24);
  EXPECT_DOUBLE_EQ(cell_volume(CellType::Wedge, corners({0, 1, 3, 4, 5, 7})), 12);
  EXPECT_DOUBLE_EQ(cell_volume(CellType::Pyramid, corners({0, 1, 2, 3, 4})), 8);
  EXPECT_DOUBLE_EQ(cell_volume(CellType::Tetrahedron, corners({0, 1, 3, 4})), 4);
}

TEST(CellVolume, IsNegativeForTheMirroredCell) {
  EXPECT_DOUBLE_EQ(cell_volume(CellType::Hexahedron, corners({4, 5, 6, 7, 0, 1, 2, 3})), -24);
  EXPECT_DOUBLE_EQ(cell_volume(CellType::Wedge, corners({0, 3, 1, 4, 7, 5})), -12);
  EXPECT_DOUBLE_EQ(cell_volume(CellType::Pyramid, corners({0, 3, 2, 1, 4})), -8);
  EXPECT_DOUBLE_EQ(cell_volume(CellType::Tetrahedron, corners({0, 3, 1, 4})), -4);
}

}  // namespace
}  // namespace nearwall::mesh
