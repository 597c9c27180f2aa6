#include "nearwall/volume/fill.h"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <map>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nearwall/predicates/cells.h"
#include "nearwall/shapes/shapes.h"
#include "tests/support/shapes.h"
#include "tests/volume/boundaries.h"

namespace nearwall::volume {
namespace {

using boundaries_for_tests::region;
namespace shapes_ = shapes_for_tests;

class FillWithTetgen : public ::testing::Test {
 protected:
  void SetUp() override { ::setenv("NEARWALL_TETGEN", NEARWALL_TETGEN_PROGRAM, 1); }
  void TearDown() override { ::unsetenv("NEARWALL_TETGEN"); }
};

double enclosed_volume(const FillBoundary& boundary) {
  long double six = 0;
  for (const auto& [a, b, c] : boundary.triangles) {
    six += dot(cross(boundary.points[a], boundary.points[b]), boundary.points[c]);
  }
  return static_cast<double>(six / 6);
}

double sum_of_volumes(const Fill& fill) {
  long double six = 0;
  for (const auto& [a, b, c, d] : fill.tetrahedra) {
    const Vec3& p = fill.points[a];
    six += dot(cross(fill.points[b] - p, fill.points[c] - p), fill.points[d] - p);
  }
  return static_cast<double>(six / 6);
}

/// Outer faces as they are seen from outside, turned so that the least corner is first.
using Face = std::array<std::uint32_t, 3>;

Face turned(Face f) {
  std::rotate(f.begin(), std::min_element(f.begin(), f.end()), f.end());
  return f;
}

std::vector<Face> outer_faces(const Fill& fill) {
  std::map<Face, int> count;
  for (const auto& [a, b, c, d] : fill.tetrahedra) {
    // From outside of a tetrahedron (b − a) × (c − a) · (d − a) > 0.
    for (const Face& f : {Face{a, c, b}, Face{a, b, d}, Face{b, c, d}, Face{a, d, c}}) ++count[turned(f)];
  }
  std::vector<Face> outer;
  for (const auto& [face, n] : count) {
    EXPECT_EQ(n, 1);
    if (!count.contains(turned({face[0], face[2], face[1]}))) outer.push_back(face);
  }
  return outer;
}

/// All that a fill must be, by means of its own.
void expect_fill(const FillBoundary& boundary, const Fill& fill) {
  ASSERT_GE(fill.points.size(), boundary.points.size());
  EXPECT_EQ(std::memcmp(fill.points.data(), boundary.points.data(), boundary.points.size() * sizeof(Vec3)), 0);
  for (const auto& [a, b, c, d] : fill.tetrahedra) {
    const std::array<Vec3, 4> p{fill.points[a], fill.points[b], fill.points[c], fill.points[d]};
    ASSERT_EQ(predicates::tetrahedron(p), predicates::Positivity::Positive);
  }
  std::vector<Face> given;
  for (const Face& t : boundary.triangles) given.push_back(turned(t));
  std::sort(given.begin(), given.end());
  EXPECT_TRUE(outer_faces(fill) == given);
  const double whole = enclosed_volume(boundary);
  EXPECT_NEAR(sum_of_volumes(fill), whole, 1e-12 * whole);
}

struct Region {
  std::string name;
  std::function<FillBoundary()> make;
};

void PrintTo(const Region& region, std::ostream* out) { *out << region.name; }

mesh::SurfaceMesh shape(const char* name, const shapes::ParameterValues& parameters, double size) {
  return shapes::make_shape(name, parameters, size);
}

std::vector<Region> regions() {
  using namespace shapes_for_tests;
  return {
      {"Tetrahedron", [] { return region(tetrahedron()); }},
      {"Box", [] { return region(shape("cube", {}, 0.25)); }},
      {"BoxInBox", [] { return region(scaled(shape("cube", {}, 0.25), 4), {shape("cube", {}, 0.25)}); }},
      {"SphereInSphere", [] { return region(sphere(2, 5), {sphere(3)}); }},
      {"TwoBodies",
       [] {
         return region(sphere(2, 8), {sphere(2, 1, {-2, 0, 0}), sphere(3, 1, {1, 1, 0})});
       }},
      {"BodiesWithACommonPoint", [] { return region(cube(4), {pinched_vertex()}); }},
      {"BodiesWithACommonEdge", [] { return region(cube(4), {cubes_sharing_an_edge()}); }},
      {"CavityInABodyInABox",
       [] {
         FillBoundary boundary = region(cube(4), {sphere(3, 2)});
         boundaries_for_tests::add(boundary, sphere(2, 1));
         return boundary;
       }},
      {"InsideOfATorus", [] { return region(shape("torus", {}, 0.2)); }},
      {"OutsideOfATorus", [] { return region(cube(4), {shape("torus", {}, 0.2)}); }},
      // TetGen goes round in circles on it where the points come in this order.
      {"InsideOfAnOmniSaddle", [] { return region(shape("omni-saddle", {}, 0.5)); }},
      {"TwoRegions",
       [] {
         FillBoundary boundary = region(sphere(2));
         boundaries_for_tests::add(boundary, sphere(2, 1, {3, 0, 0}));
         return boundary;
       }},
  };
}

class FillOfRegions : public FillWithTetgen, public ::testing::WithParamInterface<Region> {};

TEST_P(FillOfRegions, KeepsTheBoundaryAndFillsItWithPositiveTetrahedra) {
  const FillBoundary boundary = GetParam().make();
  expect_fill(boundary, fill_with_tetgen(boundary));
}

INSTANTIATE_TEST_SUITE_P(Shapes, FillOfRegions, ::testing::ValuesIn(regions()),
                         [](const auto& parameter) { return parameter.param.name; });

TEST_F(FillWithTetgen, IsTheSameForTheSameInputWhateverRanBefore) {
  const FillBoundary boundary = region(shapes_::sphere(2, 5), {shapes_::sphere(3)});
  const Fill first = fill_with_tetgen(boundary);
  fill_with_tetgen(region(shapes_::cube(2)));
  const Fill second = fill_with_tetgen(boundary);
  EXPECT_EQ(first.tetrahedra, second.tetrahedra);
  EXPECT_EQ(first.points, second.points);
}

TEST_F(FillWithTetgen, ScalesWithPowersOfTwo) {
  FillBoundary boundary = region(shapes_::sphere(2, 5), {shapes_::sphere(3)});
  const Fill fill = fill_with_tetgen(boundary);
  constexpr double kScale = 1.0 / 1024;
  for (Vec3& p : boundary.points) p *= kScale;
  const Fill small = fill_with_tetgen(boundary);
  EXPECT_EQ(fill.tetrahedra, small.tetrahedra);
}

FillFailed failure_of(const FillBoundary& boundary) {
  try {
    fill_with_tetgen(boundary);
  } catch (const FillFailed& failure) {
    return failure;
  }
  ADD_FAILURE() << "it was filled";
  return {"", {}};
}

TEST_F(FillWithTetgen, NamesTrianglesThatCross) {
  FillBoundary boundary = region(shapes_::cube(4));
  const auto n = static_cast<std::uint32_t>(boundary.triangles.size());
  boundaries_for_tests::add(boundary, shapes_::tetrahedron(), true);
  boundaries_for_tests::add(boundary, shapes_::translated(shapes_::tetrahedron(), {0.25, 0.25, 0.25}), true);
  const FillFailed failure = failure_of(boundary);
  ASSERT_FALSE(failure.triangles.empty());
  EXPECT_THAT(failure.triangles, ::testing::Each(::testing::Ge(n)));
  // Some of either body.
  EXPECT_LT(failure.triangles.front(), n + 4);
  EXPECT_GE(failure.triangles.back(), n + 4);
}

TEST_F(FillWithTetgen, NamesTheTrianglesRoundAHole) {
  FillBoundary boundary = region(shapes_::sphere(2));
  const auto lost = boundary.triangles.back();
  boundary.triangles.pop_back();
  const FillFailed failure = failure_of(boundary);
  EXPECT_EQ(failure.triangles.size(), 3u);
  for (const std::uint32_t f : failure.triangles) {
    int shared = 0;
    for (const std::uint32_t v : boundary.triangles[f]) shared += std::count(lost.begin(), lost.end(), v) > 0;
    EXPECT_EQ(shared, 2);
  }
}

TEST_F(FillWithTetgen, RefusesARegionOnTheWrongSide) {
  EXPECT_THAT(failure_of(region(shapes_::flipped(shapes_::sphere(2)))).what(), ::testing::HasSubstr("normals"));
  // A body in a box whose normals point away from it has no region of winding number one beside it.
  FillBoundary boundary = region(shapes_::cube(4));
  boundaries_for_tests::add(boundary, shapes_::sphere(2));
  EXPECT_THAT(failure_of(boundary).what(), ::testing::HasSubstr("normals"));
}

TEST_F(FillWithTetgen, RefusesTrianglesWithoutArea) {
  FillBoundary boundary = region(shapes_::cube(1));
  // A flap of no area between two triangles: closed, oriented, flat.
  const auto [a, b, c] = boundary.triangles[0];
  const auto m = static_cast<std::uint32_t>(boundary.points.size());
  boundary.points.push_back((boundary.points[a] + boundary.points[b]) * 0.5);
  boundary.triangles[0] = {a, m, c};
  boundary.triangles.push_back({m, b, c});
  boundary.triangles.push_back({a, b, m});
  EXPECT_EQ(failure_of(boundary).triangles, std::vector<std::uint32_t>{m == 8 ? 13u : 0u});
}

TEST_F(FillWithTetgen, RefusesWhatIsNotInRange) {
  const FillBoundary good = region(shapes_::cube(1));
  EXPECT_THROW(fill_with_tetgen(good, {.growth = 1, .largest = {}}), InputError);
  EXPECT_THROW(fill_with_tetgen(good, {.growth = 1.3, .largest = 0.0}), InputError);
  FillBoundary bad = good;
  bad.triangles[0][0] = 8;
  EXPECT_THROW(fill_with_tetgen(bad), InputError);
  bad = good;
  bad.points[3] = {0, 0, std::numeric_limits<double>::quiet_NaN()};
  EXPECT_THROW(fill_with_tetgen(bad), InputError);
  bad = good;
  bad.points.push_back({0, 0, 0});
  EXPECT_THROW(fill_with_tetgen(bad), InputError);
  EXPECT_THROW(fill_with_tetgen({}), FillFailed);
}

TEST_F(FillWithTetgen, LeavesNoLargerTetrahedraThanAsked) {
  const FillBoundary boundary = region(shapes_::sphere(2, 5), {shapes_::sphere(3)});
  const auto coarse = fill_with_tetgen(boundary), fine = fill_with_tetgen(boundary, {.growth = 1.3, .largest = 0.4});
  EXPECT_GT(fine.tetrahedra.size(), 2 * coarse.tetrahedra.size());
  EXPECT_GT(coarse.tetrahedra.size(), fill_with_tetgen(boundary, {.growth = 2, .largest = {}}).tetrahedra.size());
}

/// In the place of nearwall-tetgen.
class ScriptedHelper {
 public:
  explicit ScriptedHelper(const std::string& commands)
      : file_(std::filesystem::temp_directory_path() / ("nearwall-helper-" + std::to_string(::getpid()))) {
    std::ofstream(file_) << "#!/bin/sh\n" << commands << "\n";
    std::filesystem::permissions(file_, std::filesystem::perms::owner_all);
    ::setenv("NEARWALL_TETGEN", file_.c_str(), 1);
  }
  ~ScriptedHelper() {
    std::filesystem::remove(file_);
    ::setenv("NEARWALL_TETGEN", NEARWALL_TETGEN_PROGRAM, 1);
  }

 private:
  std::filesystem::path file_;
};

TEST_F(FillWithTetgen, SaysThatItsProcessWasKilled) {
  const ScriptedHelper helper("echo a word >&2; kill -9 $$");
  try {
    fill_with_tetgen(region(shapes_::cube(1)));
    FAIL();
  } catch (const BackendError& error) {
    EXPECT_THAT(error.what(), ::testing::AllOf(::testing::HasSubstr("signal 9"), ::testing::HasSubstr("a word")));
  }
}

TEST_F(FillWithTetgen, BelievesNoEmptyResult) {
  const ScriptedHelper helper("exit 0");
  EXPECT_THROW(fill_with_tetgen(region(shapes_::cube(1))), BackendError);
}

TEST_F(FillWithTetgen, NamesTheTrianglesThatTetgenNames) {
  const FillBoundary boundary = region(shapes_::cube(1));
  const auto [a, b, c] = boundary.triangles[5];
  const auto [d, e, f] = boundary.triangles[2];
  const ScriptedHelper helper("echo '  1st: [" + std::to_string(b) + ", " + std::to_string(a) + ", " +
                              std::to_string(c) + "] #1' >&2; echo '  2nd: [" + std::to_string(f) + "," +
                              std::to_string(e) + ", " + std::to_string(d) + "] #2' >&2; exit 3");
  const FillFailed failure = failure_of(boundary);
  EXPECT_THAT(failure.triangles, ::testing::ElementsAre(2, 5));
  EXPECT_THAT(failure.what(), ::testing::HasSubstr("too close"));
}

TEST_F(FillWithTetgen, TriesAnotherOrderWhereTetgenCrashes) {
  const FillBoundary boundary = region(shapes_::sphere(2, 5), {shapes_::sphere(3)});
  const std::string program = NEARWALL_TETGEN_PROGRAM;
  // exec keeps the process, whose parent must be this one.
  const ScriptedHelper helper("if [ $2 = 0 ]; then kill -SEGV $$; fi; exec " + program + " $1 $2");
  expect_fill(boundary, fill_with_tetgen(boundary));
}

TEST_F(FillWithTetgen, FillsRoundDetailsFarSmallerThanTheWhole) {
  const FillBoundary boundary = region(shapes_::sphere(1, 100), {shapes_::sphere(2, 1e-9, {1e-8, 0, 0})});
  expect_fill(boundary, fill_with_tetgen(boundary));
}

/// Interrupts at the first sign of life after the helper has said its name.
class InterruptingSink : public ProgressSink {
 public:
  explicit InterruptingSink(std::filesystem::path file) : file_(std::move(file)) {}
  void begin_stage(std::string_view) override {}
  void update(double fraction) override {
    EXPECT_GE(fraction, last);
    EXPECT_LT(fraction, 1);
    last = fraction;
    if (std::filesystem::exists(file_) && std::ifstream(file_) >> pid) throw Interrupted();
  }
  void end_stage() override {}
  void note(std::string_view) override {}
  void warn(std::string_view) override {}
  double last = 0;
  int pid = 0;

 private:
  std::filesystem::path file_;
};

TEST_F(FillWithTetgen, EndsItsProcessWhenItIsInterrupted) {
  const auto file = std::filesystem::temp_directory_path() / ("nearwall-pid-" + std::to_string(::getpid()));
  const ScriptedHelper helper("echo $$ > " + file.string() + "; exec sleep 60");
  InterruptingSink sink(file);
  EXPECT_THROW(fill_with_tetgen(region(shapes_::cube(1)), {}, sink), Interrupted);
  std::filesystem::remove(file);
  ASSERT_GT(sink.pid, 0);
  EXPECT_EQ(::kill(sink.pid, 0), -1);
}

}  // namespace
}  // namespace nearwall::volume
