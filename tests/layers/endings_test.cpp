#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "nearwall/certify/mesh_certificate.h"
#include "tests/layers/asked.h"
#include "tests/support/volume_meshes.h"

// How layers end: at patches without layers, at vertices that no line can leave, in gaps, with and without stairs.

namespace nearwall::layers {
namespace {

using growing_for_tests::TestWall;
using mesh::LimitReason;

/// A shape with patches that get no layers.
struct Ending {
  std::string name;
  std::string shape;
  shapes::ParameterValues parameters;
  double size = 0;
  std::vector<std::string> bare;
  bool fluid_is_inside = false;
};

const std::vector<Ending>& endings() {
  static const std::vector<Ending> all = {
      {"side_of_a_box", "box", {}, 0.15, {"x-max"}},
      {"edges_of_a_plate", "plate", {}, 0.12, {"leading-edge", "side-left"}},
      {"ends_of_a_pipe", "bend", {}, 0.25, {"inlet", "outlet"}, true},
      {"plate_below_a_fin", "fin-on-plate", {}, 0.2, {"plate", "plate-side", "plate-bottom"}},
      {"sphere_beside_a_bare_one", "two-spheres", {{"gap", 0.05}}, 0.2, {"second"}},
      {"gap", "two-boxes", {{"gap", 0.05}}, 0.15, {}},
      {"blind_octants", "octants", {{"pattern", 139}}, 0.2, {}},
      {"omni_saddle", "omni-saddle", {{"arms", 3}, {"arm-width", 0.3}}, 0.2, {}},
      {"narrow_notch", "notch", {{"angle", 15}}, 0.2, {}},
      {"crown", "crown", {{"points", 5}, {"ridge-slope", 50}, {"valley-slope", 55}}, 0.3, {}},
  };
  return all;
}

double mean_edge(const mesh::SurfaceMesh& surface) {
  double sum = 0;
  for (const FaceId f : surface.faces.ids()) {
    const auto t = surface.triangle(f);
    for (std::size_t k = 0; k < 3; ++k) sum += distance(t[k], t[(k + 1) % 3]);
  }
  return sum / (3.0 * static_cast<double>(surface.faces.size()));
}

mesh::SurfaceMesh surface_of(const Ending& ending) {
  mesh::SurfaceMesh surface = gallery::catalogued(ending.shape, ending.parameters, ending.size);
  return ending.fluid_is_inside ? shapes_for_tests::flipped(std::move(surface)) : surface;
}

GrowOptions options_of(const Ending& ending, const mesh::SurfaceMesh& surface, double thickness, OnConflict on_conflict,
                       std::optional<int> step) {
  GrowOptions options = ten_layers(surface, [&](const std::string& patch) {
    return std::find(ending.bare.begin(), ending.bare.end(), patch) == ending.bare.end() ? thickness : 0.0;
  });
  for (PatchSchedule& schedule : options.schedules) {
    schedule.on_conflict = on_conflict;
    schedule.max_level_step = step;
  }
  return options;
}

class Endings : public testing::TestWithParam<std::size_t> {};

TEST_P(Endings, AreConformingAndShowTrianglesOnlyHoweverThickTheLayers) {
  const Ending& ending = endings()[GetParam()];
  const TestWall wall(surface_of(ending), ending.fluid_is_inside);
  const double edge = mean_edge(wall.surface());
  for (const double edges : {1.0, 5.0, 20.0}) {
    for (const auto& [on_conflict, step] : {std::pair<OnConflict, std::optional<int>>{OnConflict::Auto, std::nullopt},
                                            {OnConflict::Stair, std::nullopt},
                                            {OnConflict::Stair, 1}}) {
      SCOPED_TRACE(testing::Message() << edges << " edges thick, on_conflict " << static_cast<int>(on_conflict));
      const Growth growth = grow(wall.wall(), options_of(ending, wall.surface(), edges * edge, on_conflict, step));
      const mesh::LayerMesh layers(growth.front, growth.lines);
      EXPECT_TRUE(certify::certify_layers(layers, wall.certified_wall()).is_valid());
      const mesh::VolumeMesh cells = volume_meshes_for_tests::read(
          mesh::LayerSource(layers, wall.surface().face_patch, wall.surface().points.raw()));
      const certify::MeshCertificate certificate = certify::certify_mesh(cells);
      EXPECT_TRUE(certificate.is_valid());
      EXPECT_TRUE(certificate.faces.nonconforming.empty());
      std::size_t n_quads = 0;
      for (const mesh::FaceName face : certificate.faces.boundary) {
        n_quads += mesh::size_of(mesh::nodes_of(cells, face)) == 4;
      }
      EXPECT_EQ(n_quads, 0u) << "quads that a tetrahedral filler would meet";
    }
  }
}

TEST_P(Endings, LeaveAllLevelsToTheNeighboursOfVerticesThatStay) {
  const Ending& ending = endings()[GetParam()];
  const TestWall wall(surface_of(ending), ending.fluid_is_inside);
  const Growth growth = grow(
      wall.wall(), options_of(ending, wall.surface(), 2 * mean_edge(wall.surface()), OnConflict::Auto, std::nullopt));
  for (const LineId line : growth.lines.windows.ids()) {
    const mesh::Window window = growth.lines.windows[line];
    EXPECT_EQ(window.end, window.moves() ? 10 : 0) << "layers are thinned, none is left out";
  }
}

INSTANTIATE_TEST_SUITE_P(Layers, Endings, testing::Range(std::size_t{0}, endings().size()),
                         [](const auto& i) { return endings()[i.param].name; });

TEST(Grade, ReachesFullThicknessAQuarterOfItAwayFromABarePatch) {
  for (const double thickness : {0.03, 0.1, 0.3}) {
    Asked a(gallery::catalogued("plate", {}, 0.05),
            [&](const std::string& patch) { return patch == "upper" ? thickness : 0.0; });
    const mesh::SurfaceMesh& surface = a.wall.surface();
    const geometry::Box box = geometry::bounding_box(surface.points.raw());
    grade(a.wall.wall(), a.field, {});
    std::size_t n_full = 0, n_thin = 0;
    for (const VertexId v : surface.points.ids()) {
      if (!(a.field.asked[v] > 0)) continue;
      const Vec3& p = surface.points[v];
      const double from_edge =
          std::min({p.x() - box.low.x(), box.high.x() - p.x(), p.y() - box.low.y(), box.high.y() - p.y()});
      if (from_edge == 0) {
        EXPECT_EQ(a.field.thickness[v], 0);
        continue;
      }
      // Along edges of triangles it is farther than straight on.
      EXPECT_GE(a.field.thickness[v], std::min(a.field.asked[v], 4 * from_edge * (1 - 1e-12)));
      n_full += a.field.thickness[v] == a.field.asked[v];
      n_thin += a.field.thickness[v] < a.field.asked[v];
    }
    EXPECT_GT(n_full, 0u);
    EXPECT_EQ(n_thin > 0, thickness > 0.2) << "only layers thicker than four edges are thinner next to the edge";
  }
}

TEST(Grade, RisesFromEachLimitAtItsOwnRate) {
  const mesh::SurfaceMesh sphere = shapes_for_tests::sphere(4);
  for (const auto& [reason, thickness, slope] : {std::tuple{LimitReason::Gap, 0.01, 1.0},
                                                 {LimitReason::Curvature, 0.01, 2.0},
                                                 {LimitReason::Quality, 0.01, 2.0},
                                                 {LimitReason::Visibility, 0.0, 4.0},
                                                 {LimitReason::Gap, 0.0, 4.0}}) {
    Asked a(sphere, 0.8);
    a.field.lower(VertexId(7), thickness, reason);
    const auto lowered = grade(a.wall.wall(), a.field, {VertexId(7)});
    EXPECT_FALSE(lowered.empty());
    EXPECT_EQ(a.field.thickness[VertexId(7)], thickness);
    double steepest = 0;
    for (const FaceId f : sphere.faces.ids()) {
      for (std::size_t k = 0; k < 3; ++k) {
        const VertexId v = sphere.faces[f][k], u = sphere.faces[f][(k + 1) % 3];
        steepest = std::max(steepest, std::abs(a.field.thickness[v] - a.field.thickness[u]) /
                                          distance(sphere.points[v], sphere.points[u]));
      }
    }
    EXPECT_NEAR(steepest, slope, 1e-12 * slope);
    for (const VertexId v : lowered) EXPECT_EQ(a.field.reason[v], LimitReason::Neighbour);
    // Nothing is left to lower.
    EXPECT_TRUE(grade(a.wall.wall(), a.field, {}).empty());
  }
}

TEST(Grade, LetsNothingLimitWhereNoLayerIsAskedFor) {
  Asked a(gallery::catalogued("two-spheres", {{"gap", 0.3}}, 0.2),
          [](const std::string& patch) { return patch == "first" ? 0.1 : 0.0; });
  EXPECT_TRUE(grade(a.wall.wall(), a.field, {}).empty());
}

}  // namespace
}  // namespace nearwall::layers
