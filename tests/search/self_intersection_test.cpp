#include "nearwall/search/self_intersection.h"

#include <algorithm>
#include <array>
#include <limits>

#include <gtest/gtest.h>

#include "nearwall/core/errors.h"
#include "nearwall/core/parallel.h"
#include "nearwall/predicates/intersection.h"
#include "tests/search/soups.h"
#include "tests/support/shapes.h"

namespace nearwall::search {
namespace {

using soups_for_tests::random_soup;
using soups_for_tests::Soup;
using soups_for_tests::soup_of;
using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// Whether two triangles meet elsewhere than in what they share, corner by corner, without boxes.
bool meet(const Soup& soup, std::array<std::uint32_t, 3> a, std::array<std::uint32_t, 3> b) {
  const auto shares = [](const auto& t, std::uint32_t v) { return std::find(t.begin(), t.end(), v) != t.end(); };
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  std::stable_partition(a.begin(), a.end(), [&](std::uint32_t v) { return shares(b, v); });
  std::stable_partition(b.begin(), b.end(), [&](std::uint32_t v) { return shares(a, v); });
  const auto n_shared = std::count_if(a.begin(), a.end(), [&](std::uint32_t v) { return shares(b, v); });
  const auto triangle = [&](const auto& t) {
    return predicates::Triangle{soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]};
  };
  if (n_shared == 0) return predicates::triangles_intersect(triangle(a), triangle(b));
  if (n_shared == 1) return predicates::triangles_intersect_beyond_vertex(triangle(a), triangle(b));
  return n_shared == 3 || predicates::triangles_overlap_beyond_edge(triangle(a), triangle(b));
}

Pairs all_pairs(const Soup& soup, const std::vector<char>& moved = {}) {
  Pairs pairs;
  for (std::uint32_t i = 0; i < soup.triangles.size(); ++i) {
    for (std::uint32_t j = i + 1; j < soup.triangles.size(); ++j) {
      if (!moved.empty() && !moved[i] && !moved[j]) continue;
      if (meet(soup, soup.triangles[i], soup.triangles[j])) pairs.emplace_back(i, j);
    }
  }
  return pairs;
}

TEST(SelfIntersections, OfRandomSoupsAreThoseOfAllPairs) {
  for (const int grid : {0, 3, 10}) {
    for (unsigned seed = 1; seed <= 4; ++seed) {
      const Soup soup = random_soup(60, 150 * seed, grid, seed);
      const Pairs expected = all_pairs(soup);
      EXPECT_FALSE(expected.empty());
      EXPECT_EQ(self_intersections(soup.view()), expected) << "grid " << grid << ", seed " << seed;
    }
  }
}

TEST(SelfIntersections, WithMarksLookOnlyAtMarkedTriangles) {
  const Soup soup = random_soup(80, 400, 6, 5);
  for (const unsigned every : {1u, 2u, 7u, 399u}) {
    std::vector<char> moved(soup.triangles.size(), 0);
    for (std::size_t i = 0; i < moved.size(); i += every) moved[i] = 1;
    EXPECT_EQ(self_intersections(soup.view(), moved), all_pairs(soup, moved));
  }
  EXPECT_TRUE(self_intersections(soup.view(), std::vector<char>(soup.triangles.size(), 0)).empty());
}

TEST(SelfIntersections, OfEmbeddedSurfacesAreNone) {
  using namespace shapes_for_tests;
  for (const auto& surface : {tetrahedron(), cube(), octahedron(), sphere(4), l_step(), wedge(0.01), cone(12, 3),
                              pinched_vertex(), cubes_sharing_an_edge(), plate(9), saddle(9),
                              joined(sphere(3, 1), sphere(3, 1.0001)), subdivided(subdivided(cube()))}) {
    EXPECT_TRUE(self_intersections(soup_of(surface).view()).empty());
  }
}

TEST(SelfIntersections, CountCornersThatAreEqualInCoordinatesOnly) {
  const mesh::SurfaceMesh tetrahedron = shapes_for_tests::tetrahedron();
  EXPECT_EQ(self_intersections(soup_of(shapes_for_tests::as_soup(tetrahedron)).view()).size(), 6u);
}

TEST(SelfIntersections, FindCrossingAndDuplicateAndFoldedTriangles) {
  Soup soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, -1}, {0.2, 0.2, 1}, {2, 2, 1}, {1, 1, 0}, {0.3, 0.3, 0}},
            {{0, 1, 2}, {3, 4, 5}, {1, 0, 6}, {2, 1, 0}, {1, 2, 7}}};
  // 0 and 1 cross; 0 and 3 have the same corners; 0, 2 and 4 are folded upon each other.
  const Pairs pairs = self_intersections(soup.view());
  EXPECT_EQ(pairs, all_pairs(soup));
  for (const auto& pair : Pairs{{0, 1}, {0, 2}, {0, 3}, {0, 4}}) {
    EXPECT_TRUE(std::binary_search(pairs.begin(), pairs.end(), pair)) << pair.first << " and " << pair.second;
  }
}

TEST(SelfIntersections, AreTheSameInAnyScaleAndAxisOrderAndAtAnyNumberOfThreads) {
  const Soup soup = random_soup(300, 1200, 0, 6);
  const Pairs pairs = self_intersections(soup.view());
  Soup other = soup;
  for (Vec3& p : other.points) p = 0x1p-40 * Vec3(p.y(), p.z(), p.x());
  EXPECT_EQ(self_intersections(other.view()), pairs);
  const ThreadLimit one(1);
  EXPECT_EQ(self_intersections(soup.view()), pairs);
}

TEST(SelfIntersections, RefuseWhatIsNotFinite) {
  Soup soup = random_soup(10, 10, 0, 7);
  soup.points[soup.triangles[3][0]] = Vec3(std::numeric_limits<double>::infinity(), 0, 0);
  EXPECT_THROW(self_intersections(soup.view()), InputError);
}

TEST(SelfIntersections, OfNothingAreNone) { EXPECT_TRUE(self_intersections(Soup().view()).empty()); }

}  // namespace
}  // namespace nearwall::search
