#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/gallery.h"

// The gallery in general position: turned at random, very small and very large, so that no coordinate is round and no
// plane lies along the axes. Every mesh is certified.

namespace nearwall {
namespace {

using growing_for_tests::options_for;
using growing_for_tests::TestWall;

/// A rotation drawn uniformly, from a random unit quaternion.
class Rotation {
 public:
  explicit Rotation(std::mt19937& random) {
    std::normal_distribution<double> normal;
    for (double& c : q_) c = normal(random);
    const double length = std::sqrt(q_[0] * q_[0] + q_[1] * q_[1] + q_[2] * q_[2] + q_[3] * q_[3]);
    for (double& c : q_) c /= length;
  }
  Vec3 operator()(const Vec3& p) const {
    const Vec3 u(q_[1], q_[2], q_[3]);
    return u * (2 * dot(u, p)) + p * (q_[0] * q_[0] - dot(u, u)) + cross(u, p) * (2 * q_[0]);
  }

 private:
  double q_[4];
};

class RotatedGallery : public testing::TestWithParam<std::size_t> {};

TEST_P(RotatedGallery, IsCertified) {
  const gallery::Shape& shape = gallery::shapes()[GetParam()];
  const mesh::SurfaceMesh upright = gallery::into_the_fluid(shape);
  std::mt19937 random(static_cast<unsigned>(GetParam()) + 1);
  for (const double scale : {1e-6, 1.0, 1e6}) {
    const Rotation rotate(random);
    const TestWall wall(shapes_for_tests::mapped(upright, [&](const Vec3& p) { return rotate(p) * scale; }),
                        shape.fluid_is_inside);
    for (const gallery::Schedule& schedule : gallery::schedules()) {
      const auto growth =
          layers::grow(wall.wall(), options_for(wall.surface(), schedule.heights(gallery::diagonal(wall.surface()))));
      const mesh::LayerMesh layers(growth.front, growth.lines);
      const auto certificate = certify::certify_layers(layers, wall.certified_wall());
      EXPECT_TRUE(certificate.is_valid()) << schedule.name << " at scale " << scale;
      EXPECT_LE(certificate.closure(), 1e-12);
      EXPECT_GT(layers.n_cells(), 0u);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, RotatedGallery, testing::Range(std::size_t{0}, gallery::shapes().size()),
                         [](const auto& shape) { return gallery::shapes()[shape.param].name; });

}  // namespace
}  // namespace nearwall
