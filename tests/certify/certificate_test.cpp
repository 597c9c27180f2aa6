#include "nearwall/certify/certificate.h"

#include <gtest/gtest.h>

#include "nearwall/core/parallel.h"
#include "tests/support/growing.h"
#include "tests/support/shapes.h"

// Each point of the certificate with its counterexample.

namespace nearwall::certify {
namespace {

using namespace shapes_for_tests;

/// Plain lines of given directions on a surface; levels at the given distances.
struct Layers {
  Layers(mesh::SurfaceMesh surface, const std::vector<double>& distances)
      : wall(std::move(surface)), front(mesh::plain_front(wall)) {
    lines.table = mesh::HeightTable({distances});
    for (const VertexId v : wall.points.ids()) {
      lines.first_piece.push_back(v.index());
      lines.base.push_back(wall.points[v]);
      lines.pieces.push_back({});
      lines.heights.push_back({});
      lines.windows.push_back({0, lines.table.n_levels()});
    }
    lines.first_piece.push_back(static_cast<std::uint32_t>(wall.points.size()));
  }

  CertifiedWall certified_wall(bool fluid_is_inside = false) const {
    return {wall, mesh::connected_components(mesh::Topology(wall)), fluid_is_inside};
  }
  Certificate certify(bool fluid_is_inside = false) const {
    return certify_layers(mesh::LayerMesh(front, lines), certified_wall(fluid_is_inside));
  }
  /// Line i along d(base point), stretched.
  template <class Direction>
  void point_lines(Direction&& d) {
    for (const LineId line : lines.base.ids()) lines.pieces[line.index()].direction = d(lines.base[line], line.index());
  }

  mesh::SurfaceMesh wall;
  mesh::Front front;
  mesh::Lines lines;
};

TEST(Certificate, HoldsForTheShellOfASphereWithItsVolume) {
  Layers layers(sphere(3), {0, 0.1, 0.3});
  layers.point_lines([](const Vec3& p, std::size_t) { return p; });
  const Certificate c = layers.certify();
  EXPECT_TRUE(c.is_valid());
  EXPECT_EQ(c.n_cells, 2 * layers.wall.faces.size());
  EXPECT_LT(c.closure(), 1e-14);
  // The front is the wall scaled by 1.3: volumes scale by the cube.
  const double wall_volume = c.front_volume - c.enclosed_volume;
  EXPECT_NEAR(c.front_volume, 1.3 * 1.3 * 1.3 * wall_volume, 1e-12);
}

TEST(Certificate, ClosesUpToRoundingInAGapABillionthAsWideAsItsWalls) {
  const double gap = 1e-9;
  Layers layers(joined(flipped(sphere(2)), sphere(2, 1 - gap)), {0, gap / 8, gap / 4});
  const std::size_t n_outer = layers.wall.points.size() / 2;
  layers.point_lines([&](const Vec3& p, std::size_t i) { return i < n_outer ? -p : p; });
  const Certificate c = layers.certify(true);
  EXPECT_TRUE(c.is_valid());
  EXPECT_LT(c.front_volume, 20 * gap);
  EXPECT_LT(c.closure(), 1e-14);
}

TEST(Certificate, NamesTheColumnsOfALineThatPointsIntoTheBody) {
  Layers layers(sphere(2), {0, 0.05, 0.1});
  layers.point_lines([](const Vec3& p, std::size_t i) { return i == 5 ? -p : p; });
  const auto bad = bad_columns(layers.front, layers.lines);
  const mesh::Topology topology(layers.wall);
  EXPECT_EQ(bad.size(), topology.fan(VertexId(5)).size());
  for (const BadColumn& column : bad) {
    EXPECT_EQ(column.level, 0);
    const auto& face = layers.wall.faces[FaceId(column.face.index())];
    EXPECT_NE(std::find(face.begin(), face.end(), VertexId(5)), face.end());
  }
  EXPECT_FALSE(layers.certify().is_valid());
}

TEST(Certificate, FindsTheFirstBadLevelOfAColumn) {
  // Inside a sphere of radius 1 all lines meet in the centre: levels beyond it are inverted.
  Layers layers(flipped(sphere(2)), {0, 0.4, 0.8, 1.2});
  layers.point_lines([](const Vec3& p, std::size_t) { return -p; });
  const auto bad = bad_columns(layers.front, layers.lines);
  ASSERT_EQ(bad.size(), layers.wall.faces.size());
  for (const BadColumn& column : bad) EXPECT_EQ(column.level, 2);
}

TEST(Certificate, LooksAtTheAskedColumnsOnly) {
  Layers layers(sphere(2), {0, 0.1});
  layers.point_lines([](const Vec3& p, std::size_t) { return -p; });
  const std::vector<FrontFaceId> some = {FrontFaceId(3), FrontFaceId(9)};
  const auto bad = bad_columns(layers.front, layers.lines, some);
  ASSERT_EQ(bad.size(), 2u);
  EXPECT_EQ(bad[0].face, some[0]);
  EXPECT_EQ(bad[1].face, some[1]);
}

TEST(Certificate, SeesFrontsThatMeetInAGap) {
  Layers layers(joined(cube(), cube(0.5, {1.1, 0, 0})), {0, 0.1});
  layers.point_lines([](const Vec3& p, std::size_t i) { return (p - (i < 8 ? Vec3() : Vec3(1.1, 0, 0))) * 2; });
  const Certificate c = layers.certify();
  EXPECT_EQ(c.n_bad_columns, 0u) << "every cell is positive";
  EXPECT_GT(c.n_front_intersections, 0u);
}

TEST(Certificate, SeesConcentricLayersThatFillTheSameSpace) {
  // r = 1 with layers out to 3, r = 4 with layers in to 2: surfaces at 1, 2, 3, 4 do not meet, 2 < r < 3 is covered
  // twice.
  const std::size_t n = sphere(3).points.size();
  Layers layers(joined(sphere(3), flipped(sphere(3, 4.0))), {0, 1, 2});
  layers.point_lines([&](const Vec3& p, std::size_t i) { return i < n ? p : -(p / 4.0); });
  const Certificate c = layers.certify(true);
  EXPECT_EQ(c.n_bad_columns, 0u);
  EXPECT_EQ(c.n_front_intersections, 0u);
  EXPECT_EQ(c.n_covered_twice, 2u);
  EXPECT_LT(c.closure(), 1e-14) << "volumes do not tell";
}

TEST(Certificate, AcceptsConcentricLayersThatShareTheGap) {
  const std::size_t n = sphere(3).points.size();
  Layers layers(joined(sphere(3), flipped(sphere(3, 4.0))), {0, 0.5, 1});
  layers.point_lines([&](const Vec3& p, std::size_t i) { return i < n ? p : -(p / 4.0); });
  EXPECT_TRUE(layers.certify(true).is_valid());
}

TEST(Certificate, SeesABodyThatIsSwallowed) {
  const std::size_t n = sphere(3).points.size();
  const Vec3 centre(1.5, 0, 0);
  Layers layers(joined(sphere(3), sphere(2, 0.05, centre)), {0, 0.01, 1});
  layers.point_lines([&](const Vec3& p, std::size_t i) { return i < n ? p : (p - centre) * 0.01; });
  const Certificate c = layers.certify();
  EXPECT_EQ(c.n_bad_columns, 0u);
  EXPECT_EQ(c.n_front_intersections, 0u);
  EXPECT_EQ(c.n_covered_twice, 1u);
}

TEST(Certificate, DoesNotCountWhatTheFluidCannotReach) {
  Layers layers(joined(sphere(3, 2.0), sphere(3)), {0, 0.1});
  layers.point_lines([&](const Vec3& p, std::size_t) { return p / 2.0; });
  auto wall = layers.certified_wall();
  for (const FaceId f : wall.face_component.ids()) {
    if (wall.face_component[f] == ComponentId(1)) wall.face_component[f] = ComponentId();
  }
  for (const LineId line : layers.lines.windows.ids()) {
    if (line.index() >= layers.wall.points.size() / 2) layers.lines.windows[line] = {};
  }
  EXPECT_TRUE(certify_layers(mesh::LayerMesh(layers.front, layers.lines), wall).is_valid());
}

TEST(Certificate, GivesTheSameBitsOnAnyNumberOfThreads) {
  Layers layers(sphere(4), {0, 0.01, 0.03, 0.07});
  layers.point_lines([](const Vec3& p, std::size_t) { return p; });
  double volume[2];
  for (int k = 0; k < 2; ++k) {
    const ThreadLimit limit(k + 1);
    volume[k] = layers.certify().cells_volume;
  }
  EXPECT_EQ(volume[0], volume[1]);
}

}  // namespace
}  // namespace nearwall::certify
