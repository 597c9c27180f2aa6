#include "nearwall/studies/ubach.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "nearwall/core/errors.h"
#include "nearwall/core/parallel.h"
#include "studies/random.h"

namespace nearwall::studies {
namespace {

TEST(RandomStream, DiffersBySeedAndStreamOnly) {
  RandomStream a(1, 2), same(1, 2), other_stream(1, 3), other_seed(2, 2);
  const std::uint64_t first = a.next();
  EXPECT_EQ(first, same.next());
  EXPECT_NE(first, other_stream.next());
  EXPECT_NE(first, other_seed.next());
}

TEST(RandomStream, IsUniform) {
  RandomStream random(1, 1);
  constexpr int kNumbers = 100000;
  double sum = 0, squares = 0;
  for (int i = 0; i < kNumbers; ++i) {
    const double u = random.uniform();
    ASSERT_TRUE(u >= 0 && u < 1);
    sum += u, squares += u * u;
  }
  // Five standard deviations of the mean: sqrt(1 / 12 / n) and sqrt(4 / 45 / n).
  EXPECT_NEAR(sum / kNumbers, 1.0 / 2, 5 * std::sqrt(1.0 / 12 / kNumbers));
  EXPECT_NEAR(squares / kNumbers, 1.0 / 3, 5 * std::sqrt(4.0 / 45 / kNumbers));
}

/// RMSE in degrees at n_p = 6 from an independent computation, in the order of kUbachWeights.
struct Expected {
  double max_curvature;
  std::array<double, 11> rmse_deg;
};

constexpr std::array<Expected, 4> kExpected = {{
    {1e-5, {1.830e-4, 1.669e-4, .0488, 1.915e-4, 1.616e-4, 1.797e-4, 3.353e-4, .0381, .0409, .2515, .0547}},
    {0.1, {1.818, 1.659, 4.886, 1.903, 1.608, 1.784, 3.316, 4.241, 4.353, 14.31, 5.830}},
    {1, {13.79, 13.11, 15.99, 14.40, 13.08, 13.66, 26.62, 17.64, 15.31, 23.52, 19.93}},
    {10, {50.14, 53.97, 51.75, 50.59, 54.15, 51.84, 72.80, 53.28, 47.75, 53.51, 47.93}},
}};

class UbachTable : public testing::TestWithParam<Expected> {};

TEST_P(UbachTable, IsReproducedWithinTheSamplingError) {
  const Expected& expected = GetParam();
  const UbachCell cell = ubach_cell(expected.max_curvature, 6, {.samples = 40000});
  for (std::size_t w = 0; w < kUbachWeights.size(); ++w) {
    // At small curvatures these weights live on a few flat triangles: their variance is hardly finite.
    const bool is_wild = w == 2 || w >= 7;
    if (is_wild && expected.max_curvature < 0.1) continue;
    // The expected figures are samples, too.
    EXPECT_NEAR(cell.rmse_deg[w], expected.rmse_deg[w], 6 * cell.standard_error_deg[w]) << kUbachNames[w];
    EXPECT_LT(cell.standard_error_deg[w], 0.05 * cell.rmse_deg[w]) << kUbachNames[w];
  }
}

INSTANTIATE_TEST_SUITE_P(Curvatures, UbachTable, testing::ValuesIn(kExpected),
                         [](const auto& at) { return fmt::format("Number{}", at.index); });

TEST(UbachStudy, AngleOverCircleBeatsMaxFromFourTrianglesOn) {
  const auto ratio = [](int n_faces) {
    const UbachCell cell = ubach_cell(1e-2, n_faces, {.samples = 20000});
    return cell.rmse_deg[4] / cell.rmse_deg[5];
  };
  EXPECT_GT(ratio(3), 1);
  EXPECT_NEAR(ratio(6), 0.899, 0.02);
  EXPECT_NEAR(ratio(9), 0.866, 0.02);
}

TEST(UbachStudy, HasTheSameBitsAtAnyNumberOfThreads) {
  const auto cell = [](int n_threads) {
    const ThreadLimit limit(n_threads);
    return ubach_cell(1, 5, {.samples = 20000});
  };
  const UbachCell one = cell(1), two = cell(2);
  EXPECT_EQ(one.rmse_deg, two.rmse_deg);
  EXPECT_EQ(one.standard_error_deg, two.standard_error_deg);
}

TEST(UbachStudy, DependsOnTheSeed) {
  EXPECT_NE(ubach_cell(1, 5, {.samples = 100, .seed = 1}).rmse_deg,
            ubach_cell(1, 5, {.samples = 100, .seed = 2}).rmse_deg);
}

TEST(UbachStudy, RefusesWhatItCannotSample) {
  EXPECT_THROW(ubach_cell(1, 6, {.samples = 0}), InputError);
  EXPECT_THROW(ubach_cell(1, 2, {}), InputError);
  EXPECT_THROW(ubach_cell(1, 65, {}), InputError);
  for (const double curvature : {std::nan(""), HUGE_VAL, -1.0, 0.0}) {
    EXPECT_THROW(ubach_cell(curvature, 6, {}), InputError) << curvature;
  }
}

TEST(UbachStudy, SamplesAllItAllows) {
  for (const double curvature : {1e-50, 1e50}) {
    const UbachCell cell = ubach_cell(curvature, 64, {.samples = 10});
    for (const double rmse : cell.rmse_deg) EXPECT_TRUE(rmse > 0 && rmse < 180) << curvature << ' ' << rmse;
  }
}

TEST(TorusStudy, MaxIsBetterAtMostNodesOfEveryMesh) {
  const auto results = compare_on_torus(1);
  ASSERT_EQ(results.size(), 5u);
  for (const TorusComparison& r : results) {
    EXPECT_GT(r.n_nodes, 7000u) << r.family;
    EXPECT_EQ(r.change_deg.size(), r.n_nodes) << r.family;
    EXPECT_TRUE(std::is_sorted(r.change_deg.begin(), r.change_deg.end())) << r.family;
    EXPECT_GT(r.improved_percent, 30) << r.family;
    EXPECT_LT(r.improved_percent, 45) << r.family;
    EXPECT_GT(r.rmse_circle_deg, r.rmse_max_deg) << r.family;
  }
}

}  // namespace
}  // namespace nearwall::studies
