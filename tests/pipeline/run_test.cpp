#include "nearwall/pipeline/run.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "nearwall/core/errors.h"
#include "nearwall/core/parallel.h"
#include "nearwall/io/surface_reader.h"
#include "nearwall/io/surface_writer.h"
#include "tests/pipeline/scratch_folder.h"
#include "tests/support/shapes.h"

namespace nearwall {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using Json = nlohmann::json;

/// A folder with a cube of edge 1 and a case for it, without pictures.
class CubeCase {
 public:
  explicit CubeCase(const std::string& more = "") {
    io::write_surface(folder / "cube.ply", shapes_for_tests::cube());
    file =
        folder.write("case.toml",
                     "[surface]\nfile = \"cube.ply\"\n[layers]\nfirst_height = 1e-3\ncount = 10\n[output]\npictures = "
                     "false\n" +
                         more);
  }
  ScratchFolder folder;
  fs::path file;
};

Json without_what_may_differ(const std::string& text) {
  Json j = Json::parse(text);
  j.erase("stages");
  j.erase("peak_memory_bytes");
  j["input"].erase("file");
  return j;
}

TEST(Run, MeshesACubeFromEndToEnd) {
  const CubeCase cube;
  const Report report = run(read_case(cube.file));
  const auto n = shapes_for_tests::cube().faces.size();
  EXPECT_TRUE(report.certified);
  EXPECT_EQ(report.n_cells(), 10 * n);
  ASSERT_EQ(report.patches.size(), 1u);
  EXPECT_EQ(report.patches[0].coverage.all_layers_percent, 100);
  EXPECT_NEAR(report.patches[0].coverage.area, 6 * std::pow(report.forecast.box.diagonal() / std::sqrt(3.0), 2), 1e-12);
  EXPECT_NEAR(report.patches[0].coverage.first_height.median, 1e-3, 1e-9);
  EXPECT_EQ(report.surface.corners, 8u);
  EXPECT_LT(report.certificate.closure(), 1e-12);
  EXPECT_GT(report.peak_memory_bytes, 1000000u);
  for (const char* file : {"cube.vtu", "cube-surface.vtp", "cube-front.vtp", "report.json", "report.html"}) {
    EXPECT_TRUE(fs::exists(cube.folder / "out" / file)) << file;
  }
  EXPECT_EQ(report.files.size(), 6u);
  const Json json = Json::parse(cube.folder.read("out/report.json"));
  EXPECT_EQ(json["files"].size(), 6u);
  EXPECT_EQ(json["certified"], true);
}

TEST(Run, KeepsTheWallTriangleForTriangle) {
  const CubeCase cube;
  run(read_case(cube.file));
  const mesh::SurfaceMesh wall = io::read_surface(cube.folder / "out/cube-surface.vtp");
  const mesh::SurfaceMesh input = io::read_surface(cube.folder / "cube.ply");
  EXPECT_EQ(wall.points, input.points);
  EXPECT_EQ(wall.faces, input.faces);
}

TEST(Run, WritesTheSameBytesAtAnyNumberOfThreadsAndIntoAnyFolder) {
  const CubeCase cube;
  run(read_case(cube.file), {cube.folder / "a", false, false});
  const ThreadLimit one(1);
  run(read_case(cube.file), {cube.folder / "b", false, false});
  for (const std::string file : {"cube.vtu", "cube-surface.vtp", "cube-front.vtp", "cube-boundary.vtp"}) {
    EXPECT_EQ(cube.folder.read("a/" + file), cube.folder.read("b/" + file)) << file;
  }
  EXPECT_EQ(without_what_may_differ(cube.folder.read("a/report.json")),
            without_what_may_differ(cube.folder.read("b/report.json")));
}

TEST(Run, ScalesWithTheSurface) {
  const CubeCase cube;
  const std::vector<std::string> scaled = {"surface.scale=0.25", "layers.first_height=2.5e-4"};
  const Report a = run(read_case(cube.file));
  const Report b = run(read_case(cube.file, scaled));
  EXPECT_EQ(a.quality.scaled_jacobian.min, b.quality.scaled_jacobian.min);
  EXPECT_EQ(a.patches[0].coverage.area, 16 * b.patches[0].coverage.area);
}

TEST(Run, DryRunForecastsAndWritesNothing) {
  const CubeCase cube;
  RunOptions options;
  options.dry_run = true;
  const Report report = run(read_case(cube.file), options);
  EXPECT_EQ(report.forecast.n_cells, 10 * shapes_for_tests::cube().faces.size());
  EXPECT_FALSE(report.certified);
  EXPECT_FALSE(fs::exists(cube.folder / "out"));
  EXPECT_EQ(Json::parse(to_json(report))["dry_run"], true);
}

TEST(Run, ForecastsTheCellsOfFans) {
  const CubeCase cube("[normals]\nmulti_angle = 80\n");
  const Report report = run(read_case(cube.file));
  EXPECT_GT(report.n_cells(), 10 * shapes_for_tests::cube().faces.size());
  EXPECT_LE(report.n_cells(), report.forecast.n_cells);
  EXPECT_LE(report.points, report.forecast.n_points);
}

TEST(Run, FlagsCoverageUnderTheMinimum) {
  const CubeCase cube("[patches.\"*\"]\nmin_coverage = 100\n");
  EXPECT_FALSE(run(read_case(cube.file)).is_short_of_coverage());
  const std::vector<std::string> nolayer = {"patches.\"*\".type=nolayer"};
  EXPECT_FALSE(run(read_case(cube.file, nolayer)).is_short_of_coverage()) << "nothing was asked for";
  // A corner that no direction sees all faces of gets no line where one has to do, and so its triangles not all layers.
  io::write_surface(cube.folder / "cube.ply", shapes_for_tests::blind_corner());
  const std::vector<std::string> one_line = {"normals.multi=false"};
  const Report short_of = run(read_case(cube.file, one_line));
  EXPECT_TRUE(short_of.certified);
  EXPECT_TRUE(short_of.is_short_of_coverage());
  EXPECT_EQ(short_of.surface.blind, 1u);
}

TEST(Run, NamesTheFaultyTrianglesInAFile) {
  const CubeCase cube;
  mesh::SurfaceMesh open = shapes_for_tests::cube();
  open.faces.raw().pop_back();
  open.face_patch.raw().pop_back();
  io::write_surface(cube.folder / "cube.ply", open);
  try {
    run(read_case(cube.file));
    FAIL();
  } catch (const surface::SurfaceRejected& e) {
    EXPECT_THAT(e.what(), HasSubstr("cube-faults.vtp"));
  }
  EXPECT_FALSE(io::read_surface(cube.folder / "out/cube-faults.vtp").faces.empty());
  EXPECT_FALSE(fs::exists(cube.folder / "out/cube.vtu"));
}

TEST(Run, RejectsAPatchThatIsNotThereBeforeAnythingIsWritten) {
  const CubeCase cube("[patches.wal]\ntype = \"nolayer\"\n");
  try {
    run(read_case(cube.file));
    FAIL();
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), HasSubstr("patches.wal"));
    EXPECT_THAT(e.what(), HasSubstr("wall"));
  }
  EXPECT_FALSE(fs::exists(cube.folder / "out"));
}

/// Stops at the first sign of life of a stage.
class StopAt final : public ProgressSink {
 public:
  explicit StopAt(std::string stage) : stage_(std::move(stage)) {}
  void begin_stage(std::string_view name) override {
    if (name == stage_) throw Interrupted();
  }
  void update(double) override {}
  void end_stage() override {}
  void note(std::string_view) override {}
  void warn(std::string_view) override {}

 private:
  std::string stage_;
};

TEST(Run, LeavesTheEarlierResultsWhenInterrupted) {
  const CubeCase cube;
  run(read_case(cube.file));
  const std::string before = cube.folder.read("out/cube.vtu");
  StopAt stop("writing vtu");
  const std::vector<std::string> other = {"layers.count=4"};
  EXPECT_THROW(run(read_case(cube.file, other), &stop), Interrupted);
  EXPECT_EQ(cube.folder.read("out/cube.vtu"), before);
  EXPECT_EQ(std::distance(fs::directory_iterator(cube.folder / "out"), {}), 6);
}

TEST(IsUpToDate, KnowsTheSameCaseInputAndFiles) {
  const CubeCase cube;
  const Case settings = read_case(cube.file);
  EXPECT_FALSE(is_up_to_date(settings, {}));
  run(settings);
  EXPECT_TRUE(is_up_to_date(settings, {}));
  const std::vector<std::string> other = {"layers.count=4"};
  EXPECT_FALSE(is_up_to_date(read_case(cube.file, other), {}));
  fs::remove(cube.folder / "out/cube.vtu");
  EXPECT_FALSE(is_up_to_date(settings, {}));
  run(settings);
  io::write_surface(cube.folder / "cube.ply", shapes_for_tests::translated(shapes_for_tests::cube(), {1, 0, 0}));
  EXPECT_FALSE(is_up_to_date(settings, {}));
}

}  // namespace
}  // namespace nearwall
