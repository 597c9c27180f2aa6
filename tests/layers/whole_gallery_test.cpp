#include <gtest/gtest.h>

#include "tests/layers/certified_growth.h"
#include "tests/support/moved.h"

// The whole product: every shape of the gallery in many positions with every schedule. Every mesh is certified.

namespace nearwall {
namespace {

using growing_for_tests::TestWall;

constexpr unsigned kSeeds = 6;

class WholeGallery : public testing::TestWithParam<std::tuple<std::size_t, std::size_t>> {};

TEST_P(WholeGallery, IsCertified) {
  const auto [shape_number, move_number] = GetParam();
  const gallery::Shape& shape = gallery::shapes()[shape_number];
  const gallery::Move move = gallery::moves(kSeeds)[move_number];
  const TestWall wall(move(gallery::into_the_fluid(shape)), shape.fluid_is_inside);
  for (const gallery::Schedule& schedule : gallery::schedules()) {
    gallery::expect_certified(wall, schedule.heights(gallery::diagonal(wall.surface())), schedule.name);
  }
}

INSTANTIATE_TEST_SUITE_P(ShapesAndMoves, WholeGallery,
                         testing::Combine(testing::Range(std::size_t{0}, gallery::shapes().size()),
                                          testing::Range(std::size_t{0}, gallery::moves(kSeeds).size())),
                         [](const auto& parameter) {
                           return gallery::shapes()[std::get<0>(parameter.param)].name + "__" +
                                  gallery::moves(kSeeds)[std::get<1>(parameter.param)].name;
                         });

}  // namespace
}  // namespace nearwall
