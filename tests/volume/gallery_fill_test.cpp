#include <cstdlib>

#include <gtest/gtest.h>

#include "nearwall/geometry/box.h"
#include "nearwall/volume/fill.h"
#include "tests/support/gallery.h"
#include "tests/volume/boundaries.h"

namespace nearwall::volume {
namespace {

class FillOfTheGallery : public ::testing::TestWithParam<gallery::Shape> {
 protected:
  void SetUp() override { ::setenv("NEARWALL_TETGEN", NEARWALL_TETGEN_PROGRAM, 1); }
};

double enclosed_volume(const FillBoundary& boundary) {
  double six = 0;
  for (const auto& [a, b, c] : boundary.triangles) {
    six += dot(cross(boundary.points[a], boundary.points[b]), boundary.points[c]);
  }
  return six / 6;
}

double sum_of_volumes(const Fill& fill) {
  double six = 0;
  for (const auto& [a, b, c, d] : fill.tetrahedra) {
    const Vec3& p = fill.points[a];
    six += dot(cross(fill.points[b] - p, fill.points[c] - p), fill.points[d] - p);
  }
  return six / 6;
}

/// The body within a sphere of five diagonals, or its inside.
FillBoundary region_of(const gallery::Shape& shape) {
  const mesh::SurfaceMesh surface = shape.make();
  if (shape.fluid_is_inside) return boundaries_for_tests::region(surface);
  geometry::Box box;
  for (const Vec3& p : surface.points) box.include(p);
  return boundaries_for_tests::region(shapes_for_tests::sphere(2, 5 * box.diagonal(), box.centre()), {surface});
}

TEST_P(FillOfTheGallery, StandsItsCheckAndClosesTheVolume) {
  const FillBoundary boundary = region_of(GetParam());
  const Fill fill = fill_with_tetgen(boundary);  // checked exactly, or it throws
  const double whole = enclosed_volume(boundary);
  EXPECT_NEAR(sum_of_volumes(fill), whole, 1e-11 * whole);
}

INSTANTIATE_TEST_SUITE_P(Gallery, FillOfTheGallery, ::testing::ValuesIn(gallery::shapes()),
                         [](const auto& parameter) { return parameter.param.name; });

}  // namespace
}  // namespace nearwall::volume
