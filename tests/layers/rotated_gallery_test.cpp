#include <gtest/gtest.h>

#include "tests/layers/certified_growth.h"
#include "tests/support/moved.h"

// The gallery in general position: turned at random, very small, very large, far from the origin. Every mesh is
// certified. One position and schedule for each kind of move; all schedules in many positions are slow tests.

namespace nearwall {
namespace {

using growing_for_tests::TestWall;

class RotatedGallery : public testing::TestWithParam<std::size_t> {};

TEST_P(RotatedGallery, IsCertified) {
  const gallery::Shape& shape = gallery::shapes()[GetParam()];
  const mesh::SurfaceMesh upright = gallery::into_the_fluid(shape);
  std::size_t k = GetParam();
  for (const gallery::Move& move : gallery::moves(1)) {
    const gallery::Schedule& schedule = gallery::schedules()[k++ % gallery::schedules().size()];
    const TestWall wall(move(upright), shape.fluid_is_inside);
    gallery::expect_certified(wall, schedule.heights(gallery::diagonal(wall.surface())),
                              move.name + ", " + schedule.name);
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, RotatedGallery, testing::Range(std::size_t{0}, gallery::shapes().size()),
                         [](const auto& shape) { return gallery::shapes()[shape.param].name; });

}  // namespace
}  // namespace nearwall
