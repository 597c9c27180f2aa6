#include "volume/size_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace nearwall::volume {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<SizeSource> scattered(std::size_t n) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> place(-1, 1), size(0.01, 1);
  std::vector<SizeSource> sources;
  for (std::size_t i = 0; i < n; ++i) sources.push_back({{place(random), place(random), place(random)}, size(random)});
  return sources;
}

double by_all(const std::vector<SizeSource>& sources, double slope, const Vec3& x) {
  double least = kInfinity;
  for (const auto& [point, size] : sources) least = std::min(least, size + slope * distance(point, x));
  return least;
}

TEST(SizeField, IsTheLeastOverAllSources) {
  const auto sources = scattered(3000);
  constexpr double kSlope = 0.3;
  const SizeField field(sources, kSlope, kInfinity);
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> place(-5, 5);
  for (int k = 0; k < 500; ++k) {
    const Vec3 x(place(random), place(random), place(random));
    const double least = by_all(sources, kSlope, x);
    EXPECT_GE(field.at(x), least);
    EXPECT_LE(field.at(x), 1.01 * least);
    EXPECT_FALSE(field.is_under(x, least));
    EXPECT_TRUE(field.is_under(x, std::nextafter(least, kInfinity)));
  }
}

TEST(SizeField, HasALargestValue) {
  const SizeField field({{{0, 0, 0}, 1}}, 0.5, 3);
  EXPECT_EQ(field.at({2, 0, 0}), 2);
  EXPECT_EQ(field.at({100, 0, 0}), 3);
  EXPECT_FALSE(field.is_under({100, 0, 0}, 3));
  EXPECT_TRUE(field.is_under({100, 0, 0}, 3.5));
}

TEST(SizesOfEdges, AreMeansOverTheEdgesAtAPoint) {
  // Two triangles back to back: sides 3, 4, 5.
  const std::vector<Vec3> points = {{0, 0, 0}, {3, 0, 0}, {0, 4, 0}};
  const std::vector<std::array<std::uint32_t, 3>> triangles = {{0, 1, 2}, {0, 2, 1}};
  const auto sizes = sizes_of_edges(points, triangles);
  EXPECT_EQ(sizes[0].size, 3.5);
  EXPECT_EQ(sizes[1].size, 4);
  EXPECT_EQ(sizes[2].size, 4.5);
  EXPECT_EQ(sizes[1].point, points[1]);
}

}  // namespace
}  // namespace nearwall::volume
