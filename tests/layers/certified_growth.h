#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/gallery.h"

namespace nearwall::gallery {

/// Grows layers on a wall and asks for what holds of any: a certificate that closes, and some cells.
inline void expect_certified(const growing_for_tests::TestWall& wall, const std::vector<double>& heights,
                             const std::string& where) {
  const auto growth = layers::grow(wall.wall(), growing_for_tests::options_for(wall.surface(), heights));
  const mesh::LayerMesh layers(growth.front, growth.lines);
  const auto certificate = certify::certify_layers(layers, wall.certified_wall());
  EXPECT_EQ(certificate.n_bad_columns, 0u) << where;
  EXPECT_EQ(certificate.n_front_intersections, 0u) << where;
  EXPECT_EQ(certificate.n_covered_twice, 0u) << where;
  EXPECT_LE(certificate.closure(), 1e-12) << where;
  EXPECT_GT(layers.n_cells(), 0u) << where;
}

}  // namespace nearwall::gallery
