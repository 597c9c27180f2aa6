#include <algorithm>
#include <cmath>
#include <iostream>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "nearwall/geometry/angles.h"
#include "tests/peers/comparison.h"

// Layers of nearwall beside those of Gmsh on the same triangulations (docs/comparison.md). The program prints the rows
// of that page's table.

namespace nearwall::peers {
namespace {

using geometry::to_radians;

/// Rounding of figures that are equal in theory.
constexpr double kSlack = 1e-6;

class Peers : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    version_ = version_of("gmsh");
    if (version_.empty()) return;
    std::cout
        << "Gmsh " << version_ << "\n"
        << "| case | program | cells | certificate | inverted | wall jacobian | smallest jacobian | first height % "
           "| lines | turn | lean | time | memory |\n| - | - | -: | - | -: | -: | -: | -: | -: | -: | -: | -: | -: |\n";
  }

  void SetUp() override {
    if (version_.empty()) GTEST_SKIP() << "gmsh is not installed; `make test-slow` installs it";
  }

  static bool is_the_version_compared() { return version_ == "4.8.4"; }

  /// What holds of every mesh of ours.
  static void expect_sound(const Meshed& m) {
    EXPECT_TRUE(m.is_valid()) << m.program;
    EXPECT_EQ(m.certificate.at("wall").at("matched").at("not"), 0) << m.program;
    EXPECT_EQ(m.figures.any_percent, 100) << m.program;
  }

  static void print(const Comparison& comparison) { std::cout << comparison.table() << std::flush; }

  static inline std::string version_;
};

// The best that one line for each point of a cube can reach: where two triangles halve the right angle at a corner, the
// line that leans alike to three faces gives them sin 45° · 1/√3 · 2/√3.
const double kOptimumOnCube = std::sqrt(2.0) / 3;

TEST_F(Peers, StructuredCube) {
  Comparison comparison({"cube, right isosceles", "cube", {{"size", 0.05}, {"structured", 1}}, 20, 1e-4});
  const Meshed peer = comparison.gmsh();
  const Meshed one = comparison.nearwall("one", {"normals.multi=false"});
  const Meshed several = comparison.nearwall("several", {"normals.multi_angle=80"});
  print(comparison);
  expect_sound(one);
  expect_sound(several);
  EXPECT_NEAR(one.figures.smallest_jacobian, kOptimumOnCube, kSlack);
  EXPECT_GE(one.figures.smallest_jacobian, peer.figures.smallest_jacobian - kSlack);
  EXPECT_GE(several.figures.smallest_wall_jacobian, 0.8);
  EXPECT_EQ(several.figures.first_height_percent, 100);
}

// Triangles along the ridges grow longer with every layer, the lines of a face's inside staying upright, unless these
// are evened out further than thickness over edge length asks for.
TEST_F(Peers, Cube) {
  Comparison comparison({"cube", "cube", {{"size", 0.05}}, 20, 1e-4});
  const Meshed peer = comparison.gmsh();
  const Meshed one = comparison.nearwall("one", {"normals.multi=false"});
  const Meshed even =
      comparison.nearwall("even", {"normals.multi=false", "smoothing.filter=most-visible", "smoothing.iterations=3"});
  const Meshed several = comparison.nearwall("several", {"normals.multi_angle=80"});
  print(comparison);
  for (const Meshed& m : {one, even, several}) {
    expect_sound(m);
    EXPECT_EQ(m.figures.first_height_percent, 100) << m.program;
  }
  EXPECT_GE(even.figures.smallest_jacobian, kOptimumOnCube - kSlack);
  EXPECT_GE(even.figures.smallest_jacobian, peer.figures.smallest_jacobian - kSlack);
  EXPECT_GE(several.figures.smallest_wall_jacobian, std::min(0.8, several.figures.upright_jacobian) - kSlack);
  EXPECT_LE(several.figures.largest_lean, to_radians(1));
}

TEST_F(Peers, Step) {
  Comparison comparison({"L step", "step", {{"size", 0.06}}, 20, 1e-4});
  const Meshed peer = comparison.gmsh();
  const Meshed own = comparison.nearwall("step");
  const Meshed several = comparison.nearwall("several", {"normals.multi_angle=80"});
  print(comparison);
  expect_sound(own);
  expect_sound(several);
  EXPECT_GT(own.figures.smallest_jacobian, std::max(0.168, peer.figures.smallest_jacobian));
}

TEST_F(Peers, Gap) {
  Comparison comparison({"gap of 0.03", "plates", {{"size", 0.05}, {"gap", 0.03}}, 20, 1e-4});
  const Meshed peer = comparison.gmsh();
  const Meshed own = comparison.nearwall("gap");
  print(comparison);
  expect_sound(own);
  EXPECT_FALSE(peer.is_valid());
  EXPECT_GT(peer.n_meeting(), 0u);
}

TEST_F(Peers, Notch) {
  Comparison comparison({"V notch of 20°", "notch", {{"size", 0.04}, {"angle", 20}}, 20, 1e-4});
  const Meshed peer = comparison.gmsh();
  const Meshed own = comparison.nearwall("notch");
  print(comparison);
  expect_sound(own);
  EXPECT_FALSE(peer.is_valid());
  EXPECT_GT(peer.n_not_positive(), 0u);
}

TEST_F(Peers, FineCube) {
  Comparison comparison({"fine cube", "cube", {{"size", 0.0125}}, 24, 1e-5});
  comparison.gmsh();
  const Meshed own = comparison.nearwall("cube");
  print(comparison);
  expect_sound(own);
  EXPECT_GT(own.figures.n_cells, 2'000'000u);
}

struct Wedge {
  double angle;
  double size;
  /// By version 4.8.4. Other triangulations have other numbers, some by luck none; nothing: cells of hardly any volume.
  std::optional<std::uint64_t> n_inverted_of_peer;
};

class PeersWedges : public Peers, public testing::WithParamInterface<Wedge> {};

TEST_P(PeersWedges, HaveAFanAtTheTrailingEdge) {
  const auto [angle, size, n_inverted_of_peer] = GetParam();
  Comparison comparison({fmt::format("wedge of {}°", angle), "wedge", {{"size", size}, {"angle", angle}}, 25, 1e-5});
  const Meshed peer = comparison.gmsh();
  const Meshed own = comparison.nearwall("wedge");
  const Meshed one = comparison.nearwall("one", {"normals.multi=false"});
  print(comparison);
  expect_sound(own);
  expect_sound(one);
  EXPECT_GE(own.figures.fewest_lines, 2u);
  EXPECT_GT(own.figures.largest_turn, 0);
  EXPECT_LE(own.figures.largest_turn, to_radians(45) + kSlack);
  EXPECT_EQ(one.figures.fewest_lines, 1u);
  if (is_the_version_compared() && n_inverted_of_peer) {
    EXPECT_EQ(peer.n_not_positive(), *n_inverted_of_peer);
    EXPECT_EQ(peer.is_valid(), *n_inverted_of_peer == 0);
  }
}

std::string wedge_name(const testing::TestParamInfo<Wedge>& info) {
  return fmt::format("of_{}_degrees", info.param.angle);
}

INSTANTIATE_TEST_SUITE_P(All, PeersWedges,
                         testing::Values(Wedge{2, 0.03, 0}, Wedge{5, 0.02, 75}, Wedge{10, 0.03, 75},
                                         Wedge{20, 0.03, 150}, Wedge{60, 0.03, std::nullopt}),
                         wedge_name);

}  // namespace
}  // namespace nearwall::peers
