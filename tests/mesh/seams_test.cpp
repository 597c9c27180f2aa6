#include "nearwall/mesh/seams.h"

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

namespace nearwall::mesh {
namespace {

SidePlane axis_plane(int axis, double at, double sign = 1) {
  SidePlane plane;
  plane.normal[axis] = sign;
  plane.offset = sign * at;
  plane.axis = axis;
  return plane;
}

/// Points and the edges on some planes, put together by positions.
struct Domain {
  std::vector<SidePlane> planes;
  std::vector<Vec3> points;
  PlaneEdges edges;

  std::uint32_t number(const Vec3& p) {
    const auto found = std::find(points.begin(), points.end(), p);
    if (found == points.end()) {
      points.push_back(p);
      return static_cast<std::uint32_t>(points.size() - 1);
    }
    return static_cast<std::uint32_t>(found - points.begin());
  }

  void add_chain(std::size_t plane, const std::vector<Vec3>& chain) {
    edges.resize(planes.size());
    for (std::size_t i = 1; i < chain.size(); ++i) edges[plane].push_back({number(chain[i - 1]), number(chain[i])});
  }

  Seams seams() const { return find_seams(points, planes, edges); }
};

/// First plane, second plane, from, to.
using Named = std::tuple<PlaneIndex, PlaneIndex, std::uint32_t, std::uint32_t>;

std::set<Named> named(const Seams& seams) {
  std::set<Named> all;
  for (const Seam& s : seams.seams) all.insert({s.first, s.second, s.ends[0], s.ends[1]});
  EXPECT_EQ(all.size(), seams.seams.size()) << "each once";
  return all;
}

/// With the seams every chain closes: as many edges leave each point as arrive there.
void expect_loops(const Domain& domain, const Seams& seams) {
  PlaneEdges edges = domain.edges;
  for (const Seam& s : seams.seams) {
    edges[s.first].push_back(s.ends);
    edges[s.second].push_back({s.ends[1], s.ends[0]});
  }
  for (const auto& of_plane : edges) {
    std::map<std::uint32_t, int> balance;
    for (const auto& [a, b] : of_plane) ++balance[a], --balance[b];
    for (const auto& [point, n] : balance) EXPECT_EQ(n, 0) << point;
  }
}

/// Space over a square floor and under a square ceiling, with planes all round.
Domain square() {
  Domain d;
  d.planes = {axis_plane(0, 0), axis_plane(1, 0), axis_plane(0, 1, -1), axis_plane(1, 1, -1)};
  // The rest of a plane lies to the left of its edges, seen from within: above the floor's, under the ceiling's.
  const std::array<Vec3, 4> floor = {Vec3(0, 1, 0), Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0)};
  const Vec3 up(0, 0, 1);
  for (std::size_t side = 0; side < 4; ++side) {
    const Vec3 &a = floor[side], &b = floor[(side + 1) % 4];
    d.add_chain(side, {b, a});
    d.add_chain(side, {a + up, b + up});
  }
  return d;
}

TEST(FindSeams, JoinTheCornersOfAFloorToThoseOfTheCeiling) {
  const Domain d = square();
  const Seams seams = d.seams();
  EXPECT_TRUE(seams.loose.empty());
  EXPECT_EQ(seams.seams.size(), 4u);
  for (const Seam& s : seams.seams) {
    const Vec3 &a = d.points[s.ends[0]], &b = d.points[s.ends[1]];
    EXPECT_TRUE(a.x() == b.x() && a.y() == b.y() && a.z() != b.z());
  }
  expect_loops(d, seams);
}

/// The space between half circles of the given radii round the origin in a quarter of space, y ≥ 0 and z ≥ 0; bodies
/// are given by where they begin and end along x.
Domain quarter(double outer, const std::vector<std::array<double, 2>>& bodies) {
  Domain d;
  d.planes = {axis_plane(1, 0), axis_plane(2, 0)};
  const auto arc = [](double x0, double x1, const Vec3& up) {
    const Vec3 middle = Vec3(0.5 * (x0 + x1), 0, 0) + up * (0.5 * std::abs(x1 - x0));
    return std::vector<Vec3>{{x0, 0, 0}, middle, {x1, 0, 0}};
  };
  // y = 0 seen from y > 0: z to the right, x upwards. The far field is run through counterclockwise, bodies clockwise.
  d.add_chain(0, arc(-outer, outer, {0, 0, 1}));
  d.add_chain(1, arc(outer, -outer, {0, 1, 0}));
  for (const auto& [begin, end] : bodies) {
    d.add_chain(0, arc(end, begin, {0, 0, 1}));
    d.add_chain(1, arc(begin, end, {0, 1, 0}));
  }
  return d;
}

TEST(FindSeams, RunFromTheBodyOfAQuarterToItsFarField) {
  Domain d = quarter(2, {{-1, 1}});
  const Seams seams = d.seams();
  const auto at = [&](double x) { return d.number({x, 0, 0}); };
  EXPECT_EQ(named(seams), (std::set<Named>{{0, 1, at(2), at(1)}, {0, 1, at(-1), at(-2)}}));
  EXPECT_TRUE(seams.loose.empty());
  expect_loops(d, seams);
}

TEST(FindSeams, RunBetweenBodiesAlongOneSeam) {
  Domain d = quarter(4, {{1, 2}, {-1.5, 0.5}, {2.25, 3}});
  const Seams seams = d.seams();
  const auto at = [&](double x) { return d.number({x, 0, 0}); };
  EXPECT_EQ(named(seams),
            (std::set<Named>{
                {0, 1, at(4), at(3)}, {0, 1, at(2.25), at(2)}, {0, 1, at(1), at(0.5)}, {0, 1, at(-1.5), at(-4)}}));
  EXPECT_TRUE(seams.loose.empty());
  expect_loops(d, seams);
}

/// Between spheres of radii 1 and 2 where no coordinate is negative.
Domain eighth() {
  Domain d;
  for (int axis = 0; axis < 3; ++axis) d.planes.push_back(axis_plane(axis, 0));
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 u, v;
    u[(axis + 1) % 3] = 1;
    v[(axis + 2) % 3] = 1;
    d.add_chain(static_cast<std::size_t>(axis), {u * 2, (u + v) * 1.5, v * 2});
    d.add_chain(static_cast<std::size_t>(axis), {v, (u + v) * 0.75, u});
  }
  return d;
}

TEST(FindSeams, RunAlongTheThreeAxesOfAnEighth) {
  const Domain d = eighth();
  const Seams seams = d.seams();
  EXPECT_TRUE(seams.loose.empty());
  ASSERT_EQ(seams.seams.size(), 3u);
  for (const Seam& s : seams.seams) EXPECT_EQ(distance(d.points[s.ends[0]], d.points[s.ends[1]]), 1);
  expect_loops(d, seams);
}

/// Within a sphere of radius 2 where no coordinate is negative: the planes meet in the middle, where no point is.
Domain eighth_of_a_ball() {
  Domain d;
  for (int axis = 0; axis < 3; ++axis) d.planes.push_back(axis_plane(axis, 0.5));
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 u, v;
    u[(axis + 1) % 3] = 2;
    v[(axis + 2) % 3] = 2;
    const Vec3 middle(0.5, 0.5, 0.5);
    d.add_chain(static_cast<std::size_t>(axis), {middle + u, middle + (u + v) * 0.75, middle + v});
  }
  return d;
}

TEST(FindSeams, MeetInTheCornerOfThreePlanes) {
  Domain d = eighth_of_a_ball();
  const Seams seams = d.seams();
  EXPECT_TRUE(seams.loose.empty());
  ASSERT_EQ(seams.corners.size(), 1u);
  EXPECT_EQ(seams.corners[0], Vec3(0.5, 0.5, 0.5));
  ASSERT_EQ(seams.seams.size(), 3u);
  for (const Seam& s : seams.seams) {
    EXPECT_EQ(std::count(s.ends.begin(), s.ends.end(), d.points.size()), 1) << "each ends in the corner";
  }
  expect_loops(d, seams);
}

TEST(FindSeams, NothingIsAskedOfLoops) {
  Domain d = quarter(2, {});
  d.planes.pop_back();
  d.edges.pop_back();
  d.add_chain(0, {{2, 0, 0}, {-2, 0, 0}});
  const Seams seams = d.seams();
  EXPECT_TRUE(seams.seams.empty() && seams.loose.empty());
}

TEST(FindSeams, TellPointsAtWhichNothingGoesOn) {
  // One plane only: its chain ends at two points that are on no other.
  Domain d = quarter(2, {{-1, 1}});
  d.planes.pop_back();
  d.edges.pop_back();
  std::vector<std::uint32_t> ends = {d.number({-2, 0, 0}), d.number({-1, 0, 0}), d.number({1, 0, 0}),
                                     d.number({2, 0, 0})};
  std::sort(ends.begin(), ends.end());
  EXPECT_TRUE(d.seams().seams.empty());
  EXPECT_EQ(d.seams().loose, ends);

  // A body whose edges run the wrong way: what arrives would meet what arrives.
  Domain wrong = quarter(2, {{1, -1}});
  EXPECT_FALSE(wrong.seams().loose.empty());

  // A body that ends at one of the planes only, at one end.
  Domain half = quarter(2, {});
  half.add_chain(0, {{1, 0, 0}, {0, 0, 0.5}});
  const auto loose = half.seams().loose;
  EXPECT_TRUE(std::binary_search(loose.begin(), loose.end(), half.number({1, 0, 0})));
  EXPECT_TRUE(std::binary_search(loose.begin(), loose.end(), half.number({0, 0, 0.5})));
}

TEST(FindSeams, DoNotDependOnTheOrderOfEdges) {
  Domain d = quarter(4, {{1, 2}, {-1.5, 0.5}, {2.25, 3}});
  const auto expected = named(d.seams());
  std::mt19937 random(5);
  for (int i = 0; i < 10; ++i) {
    for (auto& of_plane : d.edges) std::shuffle(of_plane.begin(), of_plane.end(), random);
    EXPECT_EQ(named(d.seams()), expected);
  }
}

}  // namespace
}  // namespace nearwall::mesh
