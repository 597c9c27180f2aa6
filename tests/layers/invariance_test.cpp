#include <algorithm>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "nearwall/core/parallel.h"
#include "tests/support/gallery.h"

// What a change of the input may change: scaling by powers of two and permuting the axes, just that, bit for bit;
// renumbering and rotating, just that, up to rounding; the number of threads, nothing.

namespace nearwall {
namespace {

using growing_for_tests::options_for;
using growing_for_tests::TestWall;

class Invariance : public testing::TestWithParam<std::size_t> {
 protected:
  const gallery::Shape& shape() const { return gallery::shapes()[GetParam()]; }
  mesh::SurfaceMesh surface() const { return gallery::into_the_fluid(shape()); }
  std::vector<double> heights() const { return gallery::schedules().front().heights(gallery::diagonal(surface())); }
  layers::Growth grow(const mesh::SurfaceMesh& surface, const std::vector<double>& heights) const {
    const TestWall wall(surface, shape().fluid_is_inside);
    return layers::grow(wall.wall(), options_for(surface, heights));
  }
};

/// All points of all levels, line by line.
std::vector<Vec3> points_of(const layers::Growth& growth) {
  std::vector<Vec3> points;
  for (const LineId line : growth.lines.base.ids()) {
    for (Level j = 0; j <= growth.lines.table.n_levels(); ++j) points.push_back(growth.lines.position(line, j));
  }
  return points;
}

TEST_P(Invariance, ScalingByPowersOfTwoScalesTheMeshBitForBit) {
  const auto points = points_of(grow(surface(), heights()));
  for (const double factor : {0x1p-20, 0x1p20}) {
    auto scaled_heights = heights();
    for (double& h : scaled_heights) h *= factor;
    const auto scaled = points_of(grow(shapes_for_tests::scaled(surface(), factor), scaled_heights));
    ASSERT_EQ(scaled.size(), points.size());
    for (std::size_t k = 0; k < points.size(); ++k) ASSERT_EQ(scaled[k], points[k] * factor);
  }
}

TEST_P(Invariance, PermutingTheAxesPermutesTheMeshBitForBit) {
  const auto turn = [](const Vec3& p) { return Vec3(p.y(), p.z(), p.x()); };
  const auto points = points_of(grow(surface(), heights()));
  const auto turned = points_of(grow(shapes_for_tests::mapped(surface(), turn), heights()));
  ASSERT_EQ(turned.size(), points.size());
  for (std::size_t k = 0; k < points.size(); ++k) ASSERT_EQ(turned[k], turn(points[k]));
}

TEST_P(Invariance, ThreadsChangeNothing) {
  std::vector<std::vector<Vec3>> results;
  for (const int n_threads : {1, 2}) {
    const ThreadLimit limit(n_threads);
    results.push_back(points_of(grow(surface(), heights())));
  }
  EXPECT_EQ(results[0], results[1]);
}

INSTANTIATE_TEST_SUITE_P(Shapes, Invariance, testing::Range(std::size_t{0}, gallery::shapes().size()),
                         [](const auto& shape) { return gallery::shapes()[shape.param].name; });

/// A body without symmetry, so that no tie waits for rounding to break it.
mesh::SurfaceMesh pebble() {
  return shapes_for_tests::mapped(shapes_for_tests::sphere(3), [](const Vec3& p) {
    const double bump =
        1 + 0.1 * std::sin(3.1 * p.x() + 0.3) * std::cos(2.3 * p.y()) + 0.05 * std::sin(4.7 * p.z() + 1);
    return Vec3(1.3 * p.x(), p.y(), 0.8 * p.z()) * bump;
  });
}

/// Thick enough to be limited in the hollows.
std::vector<double> pebble_heights() { return growing_for_tests::geometric(0.3, 1.2, 12); }

layers::Growth grow_pebble(const mesh::SurfaceMesh& surface) {
  const TestWall wall(surface);
  return layers::grow(wall.wall(), options_for(surface, pebble_heights()));
}

TEST(RotatedBody, HasTheRotatedMesh) {
  const double a = 0.7, b = 0.4;
  const auto rotate = [&](const Vec3& p) {
    const Vec3 q(std::cos(a) * p.x() - std::sin(a) * p.y(), std::sin(a) * p.x() + std::cos(a) * p.y(), p.z());
    return Vec3(q.x(), std::cos(b) * q.y() - std::sin(b) * q.z(), std::sin(b) * q.y() + std::cos(b) * q.z());
  };
  const auto points = points_of(grow_pebble(pebble()));
  const auto rotated = points_of(grow_pebble(shapes_for_tests::mapped(pebble(), rotate)));
  ASSERT_EQ(rotated.size(), points.size());
  for (std::size_t k = 0; k < points.size(); ++k) ASSERT_LT(distance(rotated[k], rotate(points[k])), 1e-10);
}

TEST(RenumberedBody, HasTheRenumberedMesh) {
  const mesh::SurfaceMesh surface = pebble();
  std::mt19937 random(5);
  std::vector<std::size_t> new_number(surface.points.size()), order(surface.faces.size());
  std::iota(new_number.begin(), new_number.end(), 0u);
  std::iota(order.begin(), order.end(), 0u);
  std::shuffle(new_number.begin(), new_number.end(), random);
  std::shuffle(order.begin(), order.end(), random);
  mesh::SurfaceMesh shuffled = surface;
  for (const VertexId v : surface.points.ids()) shuffled.points[VertexId(new_number[v.index()])] = surface.points[v];
  for (std::size_t f = 0; f < order.size(); ++f) {
    const auto& face = surface.faces[FaceId(order[f])];
    for (std::size_t k = 0; k < 3; ++k) {
      shuffled.faces[FaceId(f)][k] = VertexId(new_number[face[(k + f) % 3].index()]);
    }
  }
  const auto growth = grow_pebble(surface), renumbered = grow_pebble(shuffled);
  for (const VertexId v : surface.points.ids()) {
    const LineId line(v.index()), same(new_number[v.index()]);
    EXPECT_EQ(renumbered.reason[same], growth.reason[line]);
    for (Level j = 0; j <= 12; ++j) {
      ASSERT_LT(distance(renumbered.lines.position(same, j), growth.lines.position(line, j)), 1e-10);
    }
  }
}

}  // namespace
}  // namespace nearwall
