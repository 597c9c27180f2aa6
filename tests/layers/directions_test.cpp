#include <gtest/gtest.h>

#include "nearwall/surface/smoothing.h"
#include "tests/support/gallery.h"

// Whatever directions the layers start from, they end certified.

namespace nearwall {
namespace {

using growing_for_tests::geometric;
using growing_for_tests::options_for;
using growing_for_tests::TestWall;

class Directions : public testing::TestWithParam<std::size_t> {};

/// Grows layers on shapes of each kind. \returns the mean share of lines that kept all layers
double grown_everywhere(surface::NormalMethod normals, surface::SmoothingFilter filter) {
  constexpr int kLayers = 8;
  const auto shapes = gallery::few_shapes();
  double sum = 0;
  for (const gallery::Shape& shape : shapes) {
    const TestWall wall(gallery::into_the_fluid(shape), shape.fluid_is_inside);
    auto options = options_for(wall.surface(), geometric(0.01 * gallery::diagonal(wall.surface()), 1.2, kLayers));
    options.normals = normals;
    options.filter = filter;
    const layers::Growth growth = layers::grow(wall.wall(), options);
    const mesh::LayerMesh layers(growth.front, growth.lines);
    EXPECT_TRUE(certify::certify_layers(layers, wall.certified_wall()).is_valid()) << shape.name;
    double n_full = 0;
    for (const mesh::Window& window : growth.lines.windows) n_full += window.end == kLayers && window.moves();
    sum += n_full / static_cast<double>(growth.lines.windows.size());
  }
  return sum / static_cast<double>(shapes.size());
}

TEST_P(Directions, OfEveryMethodGiveCertifiedLayers) {
  const auto method = static_cast<surface::NormalMethod>(GetParam());
  // Blind normals of any method are replaced, so nearly all lines keep their layers.
  EXPECT_GT(grown_everywhere(method, surface::SmoothingFilter::Taubin), 0.9);
}

INSTANTIATE_TEST_SUITE_P(AllMethods, Directions, testing::Range(std::size_t{0}, surface::kNormalMethodNames.size()),
                         [](const testing::TestParamInfo<std::size_t>& parameter) {
                           std::string name(surface::kNormalMethodNames[parameter.param]);
                           for (char& c : name) c = c == '-' || c == '/' ? '_' : c;
                           return name;
                         });

TEST(SmoothedDirections, OfEveryFilterGiveCertifiedLayers) {
  for (std::size_t k = 0; k < surface::kSmoothingFilterNames.size(); ++k) {
    const auto filter = static_cast<surface::SmoothingFilter>(k);
    EXPECT_GT(grown_everywhere(surface::NormalMethod::MostVisible, filter), 0.9) << surface::filter_name(filter);
  }
}

}  // namespace
}  // namespace nearwall
