#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "nearwall/geometry/angles.h"
#include "nearwall/quality/coverage.h"
#include "nearwall/quality/metrics.h"
#include "tests/support/gallery.h"

// The cases on which nearwall is compared with other programs (docs/comparison.md), on surfaces of its own: the figures
// that must be reached.

namespace nearwall {
namespace {

using geometry::to_radians;
using growing_for_tests::TestWall;

/// A stack of layers of one ratio.
struct Stack {
  double first_height;
  int count;
  std::vector<double> heights() const {
    constexpr double kGrowth = 1.2;
    return growing_for_tests::geometric(first_height * (std::pow(kGrowth, count) - 1) / (kGrowth - 1), kGrowth, count);
  }
};

constexpr Stack kBlockStack{1e-4, 20}, kWingStack{1e-5, 25};

/// What came out on a wall.
struct Figures {
  double smallest_jacobian = std::numeric_limits<double>::infinity();  ///< scaled, of all cells over wall triangles
  double largest_height_error = 0;                                     ///< of the first height, over the asked one
  double largest_turn = 0;                                             ///< between neighbouring lines of a fan [rad]
  std::size_t n_bare_faces = 0;
  std::size_t n_cells_off_the_wall = 0;  ///< over virtual faces
};

class Layered {
 public:
  Layered(mesh::SurfaceMesh surface, const Stack& stack, const layers::GrowOptions& options = {})
      : wall_(std::move(surface)), stack_(stack), growth_(grow(options)) {}

  const layers::Growth& growth() const { return growth_; }
  const mesh::SurfaceMesh& surface() const { return wall_.surface(); }

  Figures certified_figures() const {
    const mesh::LayerMesh layers(growth_.front, growth_.lines);
    const auto certificate = certify::certify_layers(layers, wall_.certified_wall());
    EXPECT_EQ(certificate.n_bad_columns, 0u);
    EXPECT_EQ(certificate.n_front_intersections, 0u);
    EXPECT_EQ(certificate.n_covered_twice, 0u);
    EXPECT_LE(certificate.closure(), 1e-12);
    Figures figures;
    look_at_cells(layers, figures);
    look_at_walls(layers, figures);
    look_at_fans(figures);
    return figures;
  }

 private:
  layers::Growth grow(layers::GrowOptions options) const {
    options.schedules = growing_for_tests::options_for(surface(), stack_.heights()).schedules;
    return layers::grow(wall_.wall(), options);
  }

  void look_at_cells(const mesh::LayerMesh& layers, Figures& figures) const {
    for (const FrontFaceId f : growth_.front.faces.ids()) {
      if (!growth_.front.is_wall(f)) {
        figures.n_cells_off_the_wall += layers.column_end(f) - layers.column_offset(f);
        continue;
      }
      layers.for_each_cell(f, [&](const mesh::LayerCell& cell, Level) {
        const double jacobian = quality::scaled_jacobian(cell.type, mesh::corners_of(growth_.lines, cell));
        figures.smallest_jacobian = std::min(figures.smallest_jacobian, jacobian);
      });
    }
  }

  void look_at_walls(const mesh::LayerMesh& layers, Figures& figures) const {
    const auto heights = stack_.heights();
    quality::PatchRequest request;
    request.first_height = heights.front();
    for (const double h : heights) request.total_thickness += h;
    request.count = static_cast<Level>(heights.size());
    const IdVector<PatchId, quality::PatchRequest> requests(surface().patch_names.size(), request);
    const auto faces = quality::face_coverage(layers, surface(), requests,
                                              {growth_.asked_thickness, growth_.reached_thickness, growth_.reason});
    for (const auto& face : faces) {
      figures.n_bare_faces += face.has_any ? 0 : 1;
      const double error = std::abs(face.first_height / request.first_height - 1);
      figures.largest_height_error = std::max(figures.largest_height_error, error);
    }
  }

  /// Sides of virtual faces of which both lines stand on one vertex.
  void look_at_fans(Figures& figures) const {
    const mesh::Lines& lines = growth_.lines;
    const auto direction = [&](LineId line) { return lines.pieces[lines.first_piece[line.index()]].direction; };
    for (const FrontFaceId f : growth_.front.faces.ids()) {
      if (growth_.front.is_wall(f) || growth_.front.faces[f].size() != 4) continue;
      const auto& face = growth_.front.faces[f].lines;
      for (std::size_t i = 0; i < 4; ++i) {
        const LineId a = face[i], b = face[(i + 1) % 4];
        if (growth_.front.line_vertex[a] != growth_.front.line_vertex[b]) continue;
        figures.largest_turn = std::max(figures.largest_turn, geometry::angle_between(direction(a), direction(b)));
      }
    }
  }

  TestWall wall_;
  Stack stack_;
  layers::Growth growth_;
};

layers::GrowOptions one_line_for_each_point() {
  layers::GrowOptions options;
  options.several_lines = false;
  return options;
}

/// Also over ridges of 90 degrees.
layers::GrowOptions lines_over_square_ridges() {
  layers::GrowOptions options;
  options.multi_angle = to_radians(80);
  return options;
}

/// Unit cubes whose triangles are right and isosceles, with short sides of 1 / 16.
mesh::SurfaceMesh right_isosceles(const std::vector<std::array<int, 3>>& unit_cubes) {
  mesh::SurfaceMesh surface = shapes_for_tests::voxels(unit_cubes);
  for (int i = 0; i < 4; ++i) surface = shapes_for_tests::subdivided(surface);
  return surface;
}

mesh::SurfaceMesh cube() { return right_isosceles({{0, 0, 0}}); }
mesh::SurfaceMesh l_step() { return right_isosceles({{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}); }

// At the corner of a cube the one line makes an angle of cosine 1 / √3 with the normals of three faces, and where two
// triangles share a right angle each has 45 degrees: over 2 / √3, the reciprocal of the ideal prism's determinant, that
// is sin 45° · 1/√3 · 2/√3 = √2 / 3. No other direction is better for all three faces.
TEST(PeersCases, OneLineOnACubeReachesTheOptimum) {
  const Layered cube_layers(cube(), kBlockStack, one_line_for_each_point());
  const Figures figures = cube_layers.certified_figures();
  EXPECT_GE(figures.smallest_jacobian, std::sqrt(2.0) / 3 - 1e-6);
  EXPECT_EQ(figures.n_cells_off_the_wall, 0u);
  EXPECT_EQ(figures.n_bare_faces, 0u);
}

TEST(PeersCases, SeveralLinesOnACubeKeepPrismsUpright) {
  const Layered cube_layers(cube(), kBlockStack, lines_over_square_ridges());
  const Figures figures = cube_layers.certified_figures();
  EXPECT_GE(figures.smallest_jacobian, 0.8);
  EXPECT_LE(figures.largest_height_error, 0.01);
  EXPECT_LE(figures.largest_turn, to_radians(45) + 1e-9);
  EXPECT_GT(figures.n_cells_off_the_wall, 0u);
}

TEST(PeersCases, StepIsBetterThanSimpleExtrusion) {
  const Figures figures = Layered(l_step(), kBlockStack).certified_figures();
  EXPECT_GT(figures.smallest_jacobian, 0.168);
  EXPECT_EQ(figures.n_bare_faces, 0u);
}

TEST(PeersCases, GapKeepsLayersEverywhere) {
  const Figures figures =
      Layered(gallery::catalogued("two-boxes", {{"gap", 0.03}}, 0.05), kBlockStack).certified_figures();
  EXPECT_EQ(figures.n_bare_faces, 0u);
}

TEST(PeersCases, NotchKeepsLayersEverywhere) {
  const Figures figures = Layered(gallery::catalogued("notch", {{"angle", 20}}, 0.04), kBlockStack).certified_figures();
  EXPECT_EQ(figures.n_bare_faces, 0u);
}

struct Wedge {
  double angle;
  double size;
};

class PeersWedges : public testing::TestWithParam<Wedge> {};

TEST_P(PeersWedges, HaveAFanAtTheTrailingEdge) {
  const auto [angle, size] = GetParam();
  const Layered wedge(gallery::catalogued("wedge", {{"angle", angle}, {"width", 2}}, size), kWingStack);
  const Figures figures = wedge.certified_figures();
  EXPECT_LE(figures.largest_turn, to_radians(45) + 1e-9);
  EXPECT_GT(figures.largest_turn, 0);
  EXPECT_EQ(figures.n_bare_faces, 0u);
  std::size_t n_on_edge = 0;
  for (const VertexId v : wedge.surface().points.ids()) {
    const Vec3& p = wedge.surface().points[v];
    // At its two ends the fan may come down to one line.
    if (p.x() != 1 || std::abs(p.y()) == 1) continue;
    ++n_on_edge;
    const auto& first = wedge.growth().front.first_line;
    EXPECT_GE(first[v.index() + 1] - first[v.index()], 2u) << "at y = " << p.y();
  }
  EXPECT_GT(n_on_edge, 2u);
}

std::string wedge_name(const testing::TestParamInfo<Wedge>& info) {
  return "of_" + std::to_string(int(info.param.angle)) + "_degrees";
}

INSTANTIATE_TEST_SUITE_P(All, PeersWedges,
                         testing::Values(Wedge{2, 0.03}, Wedge{5, 0.02}, Wedge{10, 0.03}, Wedge{20, 0.03},
                                         Wedge{60, 0.03}),
                         wedge_name);

}  // namespace
}  // namespace nearwall
