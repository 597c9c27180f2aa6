#include "nearwall/search/patch_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <random>

#include "nearwall/core/errors.h"
#include "nearwall/search/self_intersection.h"

namespace nearwall::search {
namespace {

using Corners = std::array<std::uint32_t, 4>;

struct Patches {
  std::vector<Vec3> points;
  std::vector<Corners> corners;

  IndexedPatches all() const { return {points, corners}; }
  PatchPairs pairs() const { return PatchTree(all()).intersections(1000); }
};

enum class Answer { Apart, Meeting, Undecided };

Answer answer(const Patches& two) {
  const PatchPairs found = two.pairs();
  EXPECT_TRUE(found.is_complete);
  return !found.meeting.empty() ? Answer::Meeting : !found.undecided.empty() ? Answer::Undecided : Answer::Apart;
}

/// Two patches as fine triangulations with common points on common edges, and whether these meet. What is bent less
/// than its triangles are apart from others comes out right.
class FineTriangles {
 public:
  explicit FineTriangles(const Patches& patches, int n = 16) : n_(n) {
    for (const Corners& c : patches.corners) add(patches, c);
  }

  bool patches_meet() const {
    const auto pairs = self_intersections({points_, triangles_});
    return std::any_of(pairs.begin(), pairs.end(), [&](const auto& p) { return of_[p.first] != of_[p.second]; });
  }

 private:
  /// A point k / n of the way from node a to node b, from the smaller node to have the same bits from both sides.
  std::uint32_t on_edge(const Patches& patches, std::uint32_t a, std::uint32_t b, int k) {
    if (b < a) return on_edge(patches, b, a, n_ - k);
    if (k == 0) b = a;
    if (k == n_) a = b, k = 0;
    const double t = static_cast<double>(k) / n_;
    return number({a, b, k}, patches.points[a] * (1 - t) + patches.points[b] * t);
  }
  std::uint32_t number(const std::array<std::int64_t, 3>& name, const Vec3& p) {
    const auto [at, is_new] = numbers_.try_emplace(name, static_cast<std::uint32_t>(points_.size()));
    if (is_new) points_.push_back(p);
    return at->second;
  }
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    triangles_.push_back({a, b, c});
    of_.push_back(n_patches_);
  }

  void add(const Patches& patches, const Corners& c) {
    const bool is_triangle = c[3] == kNoCorner;
    std::map<std::pair<int, int>, std::uint32_t> grid;
    for (int i = 0; i <= n_; ++i) {
      for (int j = 0; j <= (is_triangle ? n_ - i : n_); ++j) grid[{i, j}] = grid_point(patches, c, i, j);
    }
    for (int i = 0; i < n_; ++i) {
      for (int j = 0; j < (is_triangle ? n_ - i : n_); ++j) {
        triangle(grid[{i, j}], grid[{i + 1, j}], grid[{i, j + 1}]);
        const bool has_second = !is_triangle || i + j + 2 <= n_;
        if (has_second) triangle(grid[{i + 1, j}], grid[{i + 1, j + 1}], grid[{i, j + 1}]);
      }
    }
    ++n_patches_;
  }
  /// Triangles: barycentric; quads: bilinear, corner 0 at (0, 0), 1 at (n, 0), 2 at (n, n), 3 at (0, n).
  std::uint32_t grid_point(const Patches& patches, const Corners& c, int i, int j) {
    const double u = static_cast<double>(i) / n_, v = static_cast<double>(j) / n_;
    const auto& p = patches.points;
    const std::array<std::int64_t, 3> inner{-1 - n_patches_, i, j};
    if (c[3] == kNoCorner) {
      if (j == 0) return on_edge(patches, c[0], c[1], i);
      if (i == 0) return on_edge(patches, c[0], c[2], j);
      if (i + j == n_) return on_edge(patches, c[1], c[2], j);
      return number(inner, p[c[0]] * (1 - u - v) + p[c[1]] * u + p[c[2]] * v);
    }
    if (j == 0) return on_edge(patches, c[0], c[1], i);
    if (i == n_) return on_edge(patches, c[1], c[2], j);
    if (j == n_) return on_edge(patches, c[3], c[2], i);
    if (i == 0) return on_edge(patches, c[0], c[3], j);
    return number(inner, (p[c[0]] * (1 - u) + p[c[1]] * u) * (1 - v) + (p[c[3]] * (1 - u) + p[c[2]] * u) * v);
  }

  int n_;
  int n_patches_ = 0;
  std::vector<Vec3> points_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<int> of_;
  std::map<std::array<std::int64_t, 3>, std::uint32_t> numbers_;
};

/// Two patches of 3 or 4 random corners, `n_shared` of them common, at random places of each.
Patches random_pair(std::mt19937& random, std::size_t n_shared) {
  std::uniform_real_distribution<double> coordinate(0, 1);
  const auto point = [&] {
    const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
    return Vec3(x, y, z);
  };
  std::array<std::size_t, 2> size{3 + random() % 2, 4};
  Patches two;
  for (std::size_t k = 0; k < size[0] + size[1] - n_shared; ++k) two.points.push_back(point());
  for (std::size_t p = 0; p < 2; ++p) {
    std::vector<std::uint32_t> nodes;
    for (std::size_t k = 0; k < size[p]; ++k) {
      nodes.push_back(static_cast<std::uint32_t>(p == 0 || k < n_shared ? k : size[0] + k - n_shared));
    }
    std::shuffle(nodes.begin(), nodes.end(), random);
    nodes.resize(4, kNoCorner);
    two.corners.push_back({nodes[0], nodes[1], nodes[2], nodes[3]});
  }
  return two;
}

struct SharedCorners : testing::TestWithParam<std::size_t> {};

TEST_P(SharedCorners, PatchesThatAreSaidToBeApartAreAndThoseThatMeetDo) {
  std::mt19937 random(static_cast<unsigned>(GetParam()) + 1);
  std::map<Answer, int> seen;
  for (int round = 0; round < 200; ++round) {
    const Patches two = random_pair(random, GetParam());
    const Answer a = answer(two);
    ++seen[a];
    if (a == Answer::Undecided) continue;
    ASSERT_EQ(FineTriangles(two).patches_meet(), a == Answer::Meeting) << "round " << round;
  }
  EXPECT_GT(seen[Answer::Apart], 10);
  EXPECT_GT(seen[Answer::Meeting], GetParam() == 0 ? 10 : -1);
}

INSTANTIATE_TEST_SUITE_P(, SharedCorners, testing::Values(0, 1, 2), testing::PrintToStringParamName());

TEST(PatchTree, KnowsPlanarQuadsExactly) {
  const std::vector<Vec3> square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const auto with = [&](const std::vector<Vec3>& more, const Corners& second) {
    Patches two{square, {{0, 1, 2, 3}, second}};
    two.points.insert(two.points.end(), more.begin(), more.end());
    return answer(two);
  };
  EXPECT_EQ(with({{0.5, 0.5, -1}, {0.5, 0.5, 1}, {2, 2, 0}}, {4, 5, 6, kNoCorner}), Answer::Meeting);
  EXPECT_EQ(with({{0.5, 0.5, 0.1}, {0.6, 0.5, 1}, {2, 2, 1}}, {4, 5, 6, kNoCorner}), Answer::Apart);
  EXPECT_EQ(with({{0.5, 0.5, 0}, {0.6, 0.5, 1}, {2, 2, 1}}, {4, 5, 6, kNoCorner}), Answer::Meeting) << "touches";
  EXPECT_EQ(with({{2, 0, 0}, {2, 1, 0}}, {1, 4, 5, 2}), Answer::Apart) << "beside it in its plane";
  EXPECT_EQ(with({{0.5, 0, 0}, {0.5, 1, 0}}, {1, 4, 5, 2}), Answer::Meeting) << "folded upon it";
  EXPECT_EQ(with({{0.5, 0.5, 1}}, {0, 2, 4, kNoCorner}), Answer::Meeting) << "a triangle that stands on its diagonal";
  EXPECT_EQ(with({{0.5, 0.5, 1}}, {0, 1, 4, kNoCorner}), Answer::Apart) << "a triangle that stands on its edge";
  EXPECT_EQ(with({{0.5, 0.5, 1}, {0.5, 0.5, -1}}, {0, 4, 2, 5}), Answer::Meeting) << "a quad along its diagonal";
  EXPECT_EQ(with({{0.2, 0.5, 1}, {0.5, 0.2, 1}}, {0, 4, 2, 5}), Answer::Apart) << "a bent one has only its ends";
  EXPECT_EQ(with({}, {0, 1, 2, kNoCorner}), Answer::Meeting) << "its own half";
}

TEST(PatchTree, CutsUpWarpedQuads) {
  // z = x y over the unit square: 1 / 4 in the middle, where its hull reaches from 0 to 1 / 2.
  const auto with_triangle_at = [](double z) {
    return answer({{{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}, {0.45, 0.5, z}, {0.55, 0.45, z}, {0.5, 0.55, z}},
                   {{0, 1, 2, 3}, {4, 5, 6, kNoCorner}}});
  };
  EXPECT_EQ(with_triangle_at(-0.01), Answer::Apart);
  EXPECT_EQ(with_triangle_at(0.1), Answer::Apart);
  EXPECT_EQ(with_triangle_at(0.2), Answer::Apart);
  EXPECT_EQ(with_triangle_at(0.25), Answer::Undecided) << "crossed, but by no edge that leaves the hull on both sides";
  EXPECT_EQ(with_triangle_at(0.4), Answer::Apart);
  EXPECT_EQ(with_triangle_at(0.53), Answer::Apart);
}

/// z = x y and the same a little higher, closed to a box by its sides: a thin, bent plate seen from outside.
Patches bent_plate(double thickness) {
  Patches plate;
  for (const double lift : {0.0, thickness}) {
    plate.points.insert(plate.points.end(), {{0, 0, lift}, {1, 0, lift}, {1, 1, 1 + lift}, {0, 1, lift}});
  }
  plate.corners = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  return plate;
}

TEST(PatchTree, SeesThroughAPlateThinnerThanItIsBent) {
  for (const double thickness : {0.3, 0.05, 0.01, 0.002}) {
    const Patches plate = bent_plate(thickness);
    const PatchTree tree(plate.all());
    EXPECT_TRUE(tree.intersections(10).meeting.empty());
    EXPECT_TRUE(tree.intersections(10).undecided.empty()) << thickness;
    for (std::uint32_t face = 0; face < 2; ++face) {
      const auto gate = tree.gate(face);
      ASSERT_TRUE(gate.has_value()) << thickness;
      EXPECT_EQ(tree.winding_number(gate->behind), 1);
      EXPECT_EQ(tree.winding_number(gate->before), 0);
    }
  }
  EXPECT_FALSE(PatchTree(bent_plate(1e-9).all()).intersections(10).undecided.empty());
}

TEST(PatchTree, CountsWindingsOfWarpedQuadsAboutAnyPoint) {
  const double thickness = 0.2;
  const Patches plate = bent_plate(thickness);
  const PatchTree tree(plate.all());
  std::mt19937 random(11);
  std::uniform_real_distribution<double> coordinate(-0.2, 1.4);
  int n_inside = 0;
  for (int i = 0; i < 3000; ++i) {
    const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
    const bool is_inside = x > 0 && x < 1 && y > 0 && y < 1 && z > x * y && z < x * y + thickness;
    ASSERT_EQ(tree.winding_number({x, y, z}), is_inside ? 1 : 0) << x << " " << y << " " << z;
    n_inside += is_inside ? 1 : 0;
  }
  EXPECT_GT(n_inside, 100);
  EXPECT_EQ(tree.winding_number({0.5, 0.5, 0.25}), std::nullopt) << "on a patch";
}

TEST(PatchTree, KnowsPatchesThatShareThreeCorners) {
  // The plane of the three is z = 0; a bent quad meets it in its two edges at the middle one of them, corner 1.
  const std::vector<Vec3> points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 1, 1}, {0, 1, -1}, {0, 1.5, 0}};
  const auto are = [&](const Corners& first, const Corners& second) { return answer({points, {first, second}}); };
  EXPECT_EQ(are({0, 1, 2, 4}, {0, 1, 2, 5}), Answer::Apart) << "bent to either side";
  EXPECT_EQ(are({0, 1, 2, 4}, {0, 1, 2, 3}), Answer::Apart) << "bent and flat";
  EXPECT_EQ(are({0, 1, 2, 4}, {1, 0, 2, 5}), Answer::Apart) << "over other corners, to either side";
  EXPECT_EQ(are({0, 1, 2, 4}, {0, 1, 2, kNoCorner}), Answer::Apart) << "bent, over a triangle";
  EXPECT_EQ(are({0, 1, 2, 3}, {0, 1, 2, 6}), Answer::Meeting) << "flat, upon each other";
  EXPECT_EQ(are({0, 1, 2, kNoCorner}, {2, 1, 0, kNoCorner}), Answer::Meeting);
  // The edge 0–2 of the second is the diagonal of the first.
  EXPECT_EQ(are({0, 1, 2, 3}, {2, 0, 1, 4}), Answer::Meeting);
}

/// Boundary of the unit cube as quads seen from outside, its top corner lifted to bend three of them.
Patches cube(double lift) {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1 + lift, 1 + lift, 1 + lift}, {0, 1, 1}},
          {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
}

TEST(PatchTree, HasGatesThatLeadOutThroughEachFace) {
  for (const double lift : {0.0, 0.1, -0.1}) {
    const Patches c = cube(lift);
    const PatchTree tree(c.all());
    EXPECT_TRUE(tree.intersections(10).undecided.empty());
    EXPECT_TRUE(tree.intersections(10).meeting.empty());
    for (std::uint32_t face = 0; face < 6; ++face) {
      const auto gate = tree.gate(face);
      ASSERT_TRUE(gate.has_value());
      EXPECT_EQ(tree.winding_number(gate->behind), 1);
      EXPECT_EQ(tree.winding_number(gate->before), 0);
    }
  }
}

TEST(PatchTree, StopsWhereThereAreTooManyPairs) {
  // Triangles in a row, each of them twice.
  Patches row;
  for (std::uint32_t i = 0; i < 40000; ++i) {
    const double x = i;
    row.points.insert(row.points.end(), {Vec3(x, 0, 0), Vec3(x + 0.5, 0, 0), Vec3(x, 1, 0)});
    for (int twice = 0; twice < 2; ++twice) row.corners.push_back({3 * i, 3 * i + 1, 3 * i + 2, kNoCorner});
  }
  const PatchTree tree(row.all());
  const PatchPairs all = tree.intersections(1000000);
  EXPECT_TRUE(all.is_complete);
  EXPECT_EQ(all.meeting.size(), 40000u);
  const PatchPairs some = tree.intersections(10);
  EXPECT_FALSE(some.is_complete);
  EXPECT_GE(some.meeting.size(), 10u);
  EXPECT_LT(some.meeting.size(), 40000u);
}

TEST(PatchTree, RefusesWhatIsNotFinite) {
  Patches c = cube(0);
  c.points[3][1] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(PatchTree{c.all()}, InputError);
}

}  // namespace
}  // namespace nearwall::search
