#include "nearwall/studies/bohdal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "nearwall/core/errors.h"
#include "nearwall/core/parallel.h"
#include "nearwall/geometry/angles.h"
#include "studies/height_field.h"

namespace nearwall::studies {
namespace {

std::size_t number_of(std::string_view name) {
  const auto at =
      std::find_if(kBohdalMethods.begin(), kBohdalMethods.end(), [&](const auto& m) { return m.name == name; });
  EXPECT_NE(at, kBohdalMethods.end()) << name;
  return static_cast<std::size_t>(at - kBohdalMethods.begin());
}

/// What the message of an InputError says; empty if there is none.
template <class Call>
std::string refusal(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// One set of 36 meshes.
std::vector<BohdalErrors> errors_of_set(std::uint64_t seed) {
  constexpr std::array<std::size_t, 4> kSizes = {4900, 2500, 900, 100};
  std::vector<BohdalErrors> errors(9 * kSizes.size());
  parallel_blocks(errors.size(), 1, [&](std::size_t i, std::size_t) {
    errors[i] = bohdal_errors(static_cast<int>(i % 9) + 1, kSizes[i / 9], seed);
  });
  return errors;
}

double mean_deg(const std::vector<BohdalErrors>& errors, std::string_view name,
                BohdalRemoval removal = BohdalRemoval::None) {
  double sum = 0;
  for (const BohdalErrors& e : errors) {
    sum += std::log(e.normals_deg[static_cast<std::size_t>(removal)][number_of(name)]);
  }
  return std::exp(sum / static_cast<double>(errors.size()));
}

TEST(BohdalStudy, ReproducesTheGeometricMeans) {
  const auto errors = errors_of_set(11);
  // From an independent computation; sets of 36 random meshes differ by some five percent, those of fits by more.
  const std::map<std::string, double> weights = {{"Max", 1.44},     {"Little-Max", 1.77}, {"Little, r = 1", 2.01},
                                                 {"Gouraud", 4.15}, {"Thürmer", 4.92},    {"Akima2", 5.53},
                                                 {"Akima", 8.07}};
  for (const auto& [name, mean] : weights) EXPECT_NEAR(mean_deg(errors, name), mean, 0.1 * mean) << name;
  const std::map<std::string, double> fits = {{"thin plate, one ring", 1.53},
                                              {"thin plate, two rings", 0.90},
                                              {"Renka & Cline, two rings", 1.08},
                                              {"quadratic, two rings", 4.5},
                                              {"Nielson", 1.18}};
  for (const auto& [name, mean] : fits) EXPECT_NEAR(mean_deg(errors, name), mean, 0.15 * mean) << name;

  // Removal helps weak weights and harms Max's.
  const auto gain = [&](std::string_view name, BohdalRemoval removal) {
    return mean_deg(errors, name, removal) / mean_deg(errors, name);
  };
  EXPECT_NEAR(gain("Akima", BohdalRemoval::ThinInPlane), 6.18 / 8.07, 0.1);
  EXPECT_NEAR(gain("Max", BohdalRemoval::UnsuitableEverywhere), 1.25, 0.08);
  EXPECT_LT(gain("Max", BohdalRemoval::UnsuitableAtBoundary), 1.1);
}

TEST(BohdalStudy, FitsMakeBetterInterpolantsThanAreas) {
  const std::size_t fit = number_of("thin plate, two rings"), akima = number_of("Akima");
  for (int function = 1; function <= 9; ++function) {
    const BohdalErrors e = bohdal_errors(function, 900, 11);
    EXPECT_LT(e.clough_tocher[fit], e.clough_tocher[akima]) << function;
    EXPECT_LT(e.powell_sabin[fit], e.powell_sabin[akima]) << function;
    EXPECT_LT(e.clough_tocher_of_truth, e.clough_tocher[akima]) << function;
  }
}

TEST(BohdalErrorsOfAMesh, RefuseWhatIsNoMesh) {
  EXPECT_EQ(refusal([] { bohdal_errors(0, 100, 1); }), "study bohdal: expected a function 1 to 9, found 0");
  EXPECT_EQ(refusal([] { bohdal_errors(10, 100, 1); }), "study bohdal: expected a function 1 to 9, found 10");
  EXPECT_EQ(refusal([] { bohdal_errors(1, 3, 1); }), "study bohdal: expected at least 4 points, found 3");
  EXPECT_EQ(refusal([] { bohdal_seconds(3, 1); }), "study bohdal: expected at least 4 points, found 3");
}

TEST(BohdalStudy, RefusesToRepeatNothing) {
  EXPECT_EQ(refusal([] { study_bohdal({.repetitions = 0}, silent_progress()); }),
            "study bohdal: expected at least 1 repetition, found 0");
}

TEST(HeightField, DiffersByFunctionAndSeed) {
  const auto first_point = [](int function, std::uint64_t seed) {
    return height_field(function, 100, seed).points[0].x;
  };
  EXPECT_EQ(first_point(1, 1), first_point(1, 1));
  EXPECT_NE(first_point(1, 1), first_point(2, 1));
  EXPECT_NE(first_point(1, 1), first_point(1, 2));
}

TEST(WithoutThinBoundary, TakesThinTrianglesFromTheBoundaryInwards) {
  // A side of the square with three points hardly inside it: two thin triangles hide a third.
  const std::vector<Point2> points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 1e-3}, {0.25, 8e-4}};
  const auto triangles = delaunay(points);
  const auto left = without_thin_boundary(points, triangles, geometry::to_radians(178));
  ASSERT_EQ(triangles.size(), 6u);
  EXPECT_EQ(left.size(), 4u);
  std::set<std::uint32_t> used;
  for (const Triangle2& t : left) used.insert(t.begin(), t.end());
  EXPECT_EQ(used.size(), points.size());
}

TEST(WithoutThinBoundary, LeavesInnerTrianglesAlone) {
  const std::vector<Point2> points = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0.9, 1}, {1, 1.0001}, {1.1, 1}};
  const auto triangles = delaunay(points);
  EXPECT_EQ(without_thin_boundary(points, triangles, geometry::to_radians(170)).size(), triangles.size());
}

TEST(RandomPlaces, LieInTheirTriangles) {
  const HeightField field = height_field(1, 100, 1);
  for (const Place& place : random_places(field, 1000, 1)) {
    const Triangle2& t = field.triangles[place.triangle];
    for (std::size_t k = 0; k < 3; ++k) {
      const Point2 &a = field.points[t[k]], &b = field.points[t[(k + 1) % 3]], &p = place.point;
      EXPECT_GT((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x), -1e-15);
    }
  }
}

TEST(RandomPlaces, AreUniformInTheHull) {
  const HeightField field = height_field(1, 100, 1);
  double area = 0, moment = 0;
  for (const Triangle2& t : field.triangles) {
    const Point2 &a = field.points[t[0]], &b = field.points[t[1]], &c = field.points[t[2]];
    const double of_triangle = ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
    area += of_triangle, moment += of_triangle * (a.x + b.x + c.x) / 3;
  }
  constexpr std::size_t kPlaces = 20000;
  double sum = 0;
  for (const Place& place : random_places(field, kPlaces, 1)) sum += place.point.x;
  // The coordinate of a place has a standard deviation of about sqrt(1 / 12).
  EXPECT_NEAR(sum / kPlaces, moment / area, 5 * std::sqrt(1.0 / 12 / kPlaces));
}

}  // namespace
}  // namespace nearwall::studies
