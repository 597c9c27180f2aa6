#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "nearwall/io/surface_writer.h"
#include "nearwall/pipeline/run.h"
#include "pipeline/surface_file.h"
#include "tests/pipeline/scratch_folder.h"
#include "tests/support/growing.h"
#include "tests/support/shapes.h"

// Every line and triangle with less than was asked has its reason, in NAME-surface.vtp and in the reports.

namespace nearwall {
namespace {

using mesh::LimitReason;
using testing::HasSubstr;
using Json = nlohmann::json;

constexpr int kLayers = 10;
constexpr double kThickness = 0.05;

/// A block with a step, whose lid gets no layers, and a small box that faces it across a gap of less than a stack.
mesh::SurfaceMesh step_gap_and_lid() {
  mesh::SurfaceMesh step = shapes_for_tests::l_step();
  for (int i = 0; i < 3; ++i) step = shapes_for_tests::subdivided(step);
  step.patch_names = IdVector<PatchId, std::string>(std::vector<std::string>{"walls", "lid"});
  for (const FaceId f : step.faces.ids()) {
    const auto [a, b, c] = step.triangle(f);
    step.face_patch[f] = PatchId(a.z() == 1 && b.z() == 1 && c.z() == 1 ? std::size_t{1} : std::size_t{0});
  }
  mesh::SurfaceMesh box = shapes_for_tests::box({2.02, 0.3, 0.3}, {2.5, 0.7, 0.7});
  for (int i = 0; i < 3; ++i) box = shapes_for_tests::subdivided(box);
  box.patch_names = IdVector<PatchId, std::string>(std::vector<std::string>{"box"});
  std::fill(box.face_patch.begin(), box.face_patch.end(), PatchId(0));
  return shapes_for_tests::joined(step, box);
}

template <class Value>
const std::vector<Value>& array(const std::vector<io::DataArray>& arrays, const std::string& name) {
  const auto found = std::find_if(arrays.begin(), arrays.end(), [&](const auto& a) { return a.name == name; });
  if (found == arrays.end()) throw std::runtime_error("no array " + name);
  return std::get<std::vector<Value>>(found->values);
}

struct Grown {
  explicit Grown(mesh::SurfaceMesh surface, const std::string& without_layers = "", bool several_lines = true)
      : wall(std::move(surface)) {
    auto options =
        growing_for_tests::options_for(wall.surface(), growing_for_tests::geometric(kThickness, 1.2, kLayers));
    for (const PatchId p : wall.surface().patch_names.ids()) {
      const bool has_layers = wall.surface().patch_names[p] != without_layers;
      requests.push_back({has_layers, options.schedules[p].heights.front(), kThickness, kLayers});
      options.schedules[p].has_layers = has_layers;
    }
    options.several_lines = several_lines;
    growth = layers::grow(wall.wall(), options);
    const mesh::LayerMesh layer_mesh(growth.front, growth.lines);
    coverage = quality::face_coverage(layer_mesh, wall.surface(), requests,
                                      {growth.asked_thickness, growth.reached_thickness, growth.reason});
    IdVector<FaceId, FaceId> same;
    for (const FaceId f : wall.surface().faces.ids()) same.push_back(f);
    file = pipeline::surface_file(wall.wall(), growth, coverage, same);
  }

  growing_for_tests::TestWall wall;
  IdVector<PatchId, quality::PatchRequest> requests;
  layers::Growth growth;
  IdVector<FaceId, quality::FaceCoverage> coverage;
  io::PolyDataFile file;
};

class SurfaceFile : public testing::Test {
 protected:
  static void expect_reasons_on_points(const Grown& g) {
    const auto& levels = array<std::int32_t>(g.file.point_data, "Levels");
    const auto& thickness = array<double>(g.file.point_data, "Thickness");
    const auto& reason = array<std::int32_t>(g.file.point_data, "LimitReason");
    const auto& count = array<std::int32_t>(g.file.point_data, "LineCount");
    for (const VertexId v : g.wall.surface().points.ids()) {
      EXPECT_EQ(static_cast<std::size_t>(count[v.index()]), g.growth.front.n_lines(v));
      for (const LineId line : g.growth.front.lines_of(v)) {
        const double asked = g.growth.asked_thickness[line];
        const bool has_all = levels[v.index()] == kLayers && thickness[v.index()] >= asked * (1 - 1e-12);
        EXPECT_TRUE(asked == 0 || has_all || reason[v.index()] != 0) << "vertex " << v.index();
        EXPECT_EQ(reason[v.index()], static_cast<int>(g.growth.reason[line]));
        EXPECT_EQ(thickness[v.index()], g.growth.reached_thickness[line]);
      }
    }
  }

  static void expect_reasons_on_triangles(const Grown& g) {
    const auto& layers = array<std::int32_t>(g.file.triangle_data, "Layers");
    const auto& reason = array<std::int32_t>(g.file.triangle_data, "LimitReason");
    for (const FaceId f : g.wall.surface().faces.ids()) {
      const bool is_asked = g.requests[g.wall.surface().face_patch[f]].has_layers;
      const bool is_full = layers[f.index()] == kLayers && g.coverage[f].thickness >= 0.95 * kThickness;
      EXPECT_EQ(reason[f.index()] == 0, is_full || !is_asked) << "triangle " << f.index();
    }
  }
};

TEST_F(SurfaceFile, GivesAReasonWhereverThereIsLess) {
  const Grown grown(step_gap_and_lid(), "lid");
  expect_reasons_on_points(grown);
  expect_reasons_on_triangles(grown);
}

TEST_F(SurfaceFile, GivesTheReasonThatItIs) {
  const Grown grown(step_gap_and_lid(), "lid");
  const auto& reason = array<std::int32_t>(grown.file.point_data, "LimitReason");
  const auto& levels = array<std::int32_t>(grown.file.point_data, "Levels");
  for (const VertexId v : grown.wall.surface().points.ids()) {
    const Vec3& p = grown.wall.surface().points[v];
    if (p.z() == 1 && p.x() > 0 && p.x() < 1 && p.y() == 0) {
      EXPECT_EQ(reason[v.index()], 6) << "the lid's edge";
      EXPECT_EQ(levels[v.index()], 0);
    }
    if (p == Vec3(2, 0.5, 0.5)) {
      EXPECT_EQ(reason[v.index()], 3) << "across from the box";
    }
    if (p == Vec3(0, 1, 0.5)) {
      EXPECT_EQ(reason[v.index()], 0) << "a wall with all the room";
    }
  }
}

TEST_F(SurfaceFile, GivesAReasonAtACornerThatNoSingleLineSees) {
  mesh::SurfaceMesh corner = shapes_for_tests::blind_corner();
  corner = shapes_for_tests::subdivided(shapes_for_tests::subdivided(corner));
  const Grown grown(std::move(corner), "", false);
  expect_reasons_on_points(grown);
  expect_reasons_on_triangles(grown);
  const auto& reason = array<std::int32_t>(grown.file.point_data, "LimitReason");
  EXPECT_THAT(reason, testing::Contains(static_cast<int>(LimitReason::Visibility)));
}

/// The same wall by way of files. \returns report.json
Json reported(const ScratchFolder& folder) {
  io::write_surface(folder / "step.vtp", step_gap_and_lid());
  const auto file = folder.write("case.toml",
                                 "[surface]\nfile = \"step.vtp\"\n[layers]\ntotal_thickness = 0.05\ncount = 10\n"
                                 "[patches.lid]\ntype = \"nolayer\"\n[output]\npictures = false\n");
  run(read_case(file));
  return Json::parse(folder.read("out/report.json"));
}

TEST(Reports, CountLimitedLinesByReasonAndPatch) {
  const ScratchFolder folder;
  const Json report = reported(folder);
  const Json& limited = report["limited_lines"];
  std::size_t lines = 0, at_wall = 0;
  for (const auto& [reason, of_reason] : limited["reasons"].items()) {
    std::size_t on_patches = 0;
    for (const Json& patch : report["patches"]) {
      if (patch.contains("limited_lines")) on_patches += patch["limited_lines"].value(reason, 0u);
    }
    EXPECT_EQ(of_reason["lines"], on_patches) << reason;
    lines += of_reason["lines"].get<std::size_t>();
    at_wall += of_reason["at_wall"].get<std::size_t>();
  }
  EXPECT_EQ(limited["limited"], lines);
  EXPECT_EQ(limited["at_wall"], at_wall);
  EXPECT_TRUE(limited["reasons"].contains("gap"));
  EXPECT_TRUE(limited["reasons"].contains("patch-edge"));
  EXPECT_FALSE(report["patches"]["lid"].contains("limited_lines"));
  EXPECT_GT(report["patches"]["box"]["limited_lines"]["gap"], 0);
}

TEST(Reports, SayWhereTheLeastIsReached) {
  const ScratchFolder folder;
  const Json report = reported(folder);
  const mesh::SurfaceMesh wall = step_gap_and_lid();
  for (const auto& [reason, of_reason] : report["limited_lines"]["reasons"].items()) {
    double before = 0;
    ASSERT_FALSE(of_reason["worst"].empty()) << reason;
    for (const Json& place : of_reason["worst"]) {
      const Vec3& p = wall.points[VertexId(place["vertex"].get<std::size_t>())];
      EXPECT_EQ(place["where"], Json({p.x(), p.y(), p.z()}));
      const double share = place["thickness"].get<double>() / place["asked"].get<double>();
      EXPECT_GE(share, before) << "the worst first";
      before = share;
    }
  }
  const Json& gap = report["limited_lines"]["reasons"]["gap"]["worst"][0];
  EXPECT_GE(gap["where"][0], 2) << "between step and box";
  EXPECT_LE(gap["where"][0], 2.02);
  EXPECT_THAT(folder.read("out/report.html"), HasSubstr("Where the least is reached"));
}

}  // namespace
}  // namespace nearwall
