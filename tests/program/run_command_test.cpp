#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <nlohmann/json.hpp>

#include "tests/program/workplace.h"

namespace nearwall::program {
namespace {

using nlohmann::json;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(RunCommand, MeshesACubeAndTellsWhereTheFilesAre) {
  Workplace place;
  place.write_cube("cube.obj");
  place.write_case("case.toml", "cube.obj");
  const Outcome outcome = place.run({"run", "case.toml"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("certified: 36 wedges"));
  EXPECT_THAT(outcome.out, HasSubstr("in out: "));
  for (const char* patch : {"sides", "bottom", "top"}) EXPECT_THAT(outcome.out, HasSubstr(patch));
  EXPECT_THAT(place.files("out"), Contains("cube.vtu"));
  EXPECT_THAT(place.files("out"), Contains("report.json"));
}

TEST(RunCommand, PrintsTheReportAsJson) {
  Workplace place;
  place.write_cube("cube.obj");
  place.write_case("case.toml", "cube.obj");
  const Outcome outcome = place.run({"run", "case.toml", "--json", "-o", "there"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const json report = json::parse(outcome.out);
  EXPECT_EQ(report["certified"], true);
  EXPECT_EQ(report["cells"]["wedge"], 36);
  EXPECT_EQ(report["patches"]["top"]["all_layers_percent"], 100);
  EXPECT_EQ(json::parse(place.read("there/report.json"))["cells"], report["cells"]);
}

TEST(RunCommand, SaysWhatEachPatchHasAndWhy) {
  Workplace place;
  place.write_cube("cube.obj");
  place.write_case("case.toml", "cube.obj", "[patches.bottom]\ntype = \"nolayer\"\n");
  const Outcome outcome = place.run({"run", "case.toml"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* title : {"area", "all %", "full %", "layers", "first %", "thickness", "reached %", "limited by"}) {
    EXPECT_THAT(outcome.out, HasSubstr(title));
  }
  EXPECT_THAT(outcome.out, testing::ContainsRegex("sides +4 +0.0 +0.0 +0.0 of 3 .*patch-edge 100.0"));
  EXPECT_THAT(outcome.out, testing::ContainsRegex("top +1 +100.0 +100.0 +3.0 of 3 +"));
  EXPECT_THAT(outcome.out, testing::ContainsRegex("bottom +1 .*no layers asked"));
  EXPECT_THAT(outcome.out, testing::ContainsRegex("4 of [0-9]+ lines stay at the wall: patch-edge 4\n"));
}

TEST(RunCommand, TakesKeysFromTheCommandLine) {
  Workplace place;
  place.write_cube("cube.obj");
  place.write_case("case.toml", "cube.obj");
  const Outcome outcome = place.run({"run", "case.toml", "--json", "--set", "layers.count=5", "--set", "name=five"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(json::parse(outcome.out)["cells"]["wedge"], 60);
  EXPECT_TRUE(place.has("out/five.vtu"));
}

TEST(RunCommand, NamesTheNearestKey) {
  Workplace place;
  place.write_cube("cube.obj");
  place.write_case("case.toml", "cube.obj", "[layrs]\ncount = 3\n");
  const Outcome outcome = place.run({"run", "case.toml"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("case.toml:10:"));
  EXPECT_THAT(outcome.err, HasSubstr("layers"));
}

TEST(RunCommand, ShowsTheWayFromASurfaceToACase) {
  Workplace place;
  place.write_cube("cube.obj");
  const Outcome outcome = place.run({"run", "cube.obj"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("nearwall init cube.obj > case.toml"));
}

TEST(RunCommand, WritesNothingOnADryRun) {
  Workplace place;
  place.write_cube("cube.obj");
  place.write_case("case.toml", "cube.obj");
  const Outcome outcome = place.run({"run", "case.toml", "--dry-run"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("36"));
  EXPECT_FALSE(place.has("out"));
}

TEST(RunCommand, ExitsWith3ForASurfaceThatCannotBeUsed) {
  Workplace place;
  place.write_open_cube("open.obj");
  place.write_case("case.toml", "open.obj");
  const Outcome outcome = place.run({"run", "case.toml"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("open"));
  EXPECT_FALSE(place.has("out/open.vtu"));
  EXPECT_TRUE(place.has("out/open-faults.vtp"));
}

TEST(RunCommand, ExitsWith4IfCoverageIsUnderItsMinimum) {
  // Every triangle of the cube's sides has a corner at the bottom, where lines stay at the wall.
  Workplace place;
  place.write_cube("cube.obj");
  place.write_case("case.toml", "cube.obj",
                   "[patches.bottom]\ntype = \"nolayer\"\n[patches.sides]\nmin_coverage = 50\n");
  const Outcome outcome = place.run({"run", "case.toml", "--json"});
  EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
  EXPECT_EQ(json::parse(outcome.out)["certified"], true);
  EXPECT_THAT(outcome.err, HasSubstr("patch 'sides': 0.0 % of its area has all layers, min_coverage asks for 50.0 %"));
}

TEST(RunCommand, TouchesNoFolderThatHoldsAnythingElse) {
  Workplace place;
  place.write_cube("cube.obj");
  place.write_case("case.toml", "cube.obj");
  place.write("out/thesis.txt", "years of work");
  const Outcome refused = place.run({"run", "case.toml"});
  EXPECT_EQ(refused.exit_code, 2) << refused.err;
  EXPECT_THAT(refused.err, HasSubstr("--force"));
  EXPECT_THAT(place.files("out"), testing::ElementsAre("thesis.txt"));
  EXPECT_EQ(place.run({"run", "case.toml", "--force"}).exit_code, 0);
  EXPECT_EQ(place.read("out/thesis.txt"), "years of work");
}

TEST(RunCommand, ReplacesItsOwnResults) {
  Workplace place;
  place.write_cube("cube.obj");
  place.write_case("case.toml", "cube.obj");
  ASSERT_EQ(place.run({"run", "case.toml"}).exit_code, 0);
  const auto first = place.files("out");
  EXPECT_EQ(place.run({"run", "case.toml", "--set", "layers.count=2"}).exit_code, 0);
  EXPECT_EQ(place.files("out"), first);
  EXPECT_EQ(json::parse(place.read("out/report.json"))["cells"]["wedge"], 24);
}

TEST(RunCommand, ResumeDoesNothingForTheSameCaseAndSurface) {
  Workplace place;
  place.write_cube("cube.obj");
  place.write_case("case.toml", "cube.obj");
  ASSERT_EQ(place.run({"run", "case.toml"}).exit_code, 0);
  const auto written = std::filesystem::last_write_time(place.path("out/cube.vtu"));
  EXPECT_THAT(place.run({"run", "case.toml", "--resume"}).out, HasSubstr("complete already"));
  EXPECT_EQ(std::filesystem::last_write_time(place.path("out/cube.vtu")), written);

  const Outcome changed = place.run({"run", "case.toml", "--resume", "--set", "layers.count=2", "--json"});
  EXPECT_EQ(json::parse(changed.out)["cells"]["wedge"], 24);
}

TEST(RunCommand, RelativeLengthsFollowTheDiagonal) {
  Workplace place;
  place.write_cube("cube.obj");
  place.write_case("case.toml", "cube.obj");
  const Outcome outcome = place.run({"run", "case.toml", "--relative", "--json", "--set",
                                     "volume.farfield={ radius = 20, centre = [1, 0, 2] }", "--set",
                                     "volume.symmetry=[{ axis = \"y\", at = -1 }]"});
  const json report = json::parse(outcome.out);
  const double diagonal = std::sqrt(3.0);
  EXPECT_DOUBLE_EQ(report["patches"]["top"]["first_height"]["asked"].get<double>(), 0.01 * diagonal);
  const json volume = report["case"]["volume"];
  EXPECT_DOUBLE_EQ(volume["farfield"]["radius"].get<double>(), 20 * diagonal);
  EXPECT_EQ(volume["farfield"]["size"], "auto");
  EXPECT_DOUBLE_EQ(volume["farfield"]["centre"][2].get<double>(), 2 * diagonal);
  EXPECT_DOUBLE_EQ(volume["symmetry"][0]["at"].get<double>(), -diagonal);
}

TEST(RunCommand, SaysNothingButResultsIfQuiet) {
  Workplace place;
  place.write_cube("cube.obj");
  place.write_case("case.toml", "cube.obj");
  const Outcome outcome = place.run({"run", "case.toml", "--quiet"});
  EXPECT_THAT(outcome.err, IsEmpty());
  EXPECT_THAT(outcome.out, HasSubstr("certified"));
}

TEST(RunCommand, InterruptedLeavesNothingBehind) {
  for (const int signal : {SIGINT, SIGTERM}) {
    Workplace place;
    ASSERT_EQ(place.run({"shape", "sphere", "--size", "0.01", "-o", "sphere.stl"}).exit_code, 0);
    place.write_case("case.toml", "sphere.stl");
    const pid_t process = place.start({"run", "case.toml", "--set", "layers.count=40"});
    ASSERT_TRUE(place.has_said("read"));
    kill(process, signal);
    const Outcome outcome = place.wait(process);
    EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
    EXPECT_THAT(place.files("out"), IsEmpty());
  }
}

TEST(InitCommand, MakesACaseThatRuns) {
  Workplace place;
  place.write_cube("cube.obj");
  const Outcome outcome = place.run({"init", "cube.obj"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  place.write("case.toml", outcome.out);
  const Outcome run = place.run({"run", "case.toml", "--dry-run"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
}

TEST(InitCommand, NamesTheSurfaceAsSeenFromTheCase) {
  Workplace place;
  place.write_cube("surfaces/cube.obj");
  std::filesystem::create_directory(place.path("cases"));
  EXPECT_EQ(place.run({"init", "surfaces/cube.obj", "-o", "cases/case.toml"}).exit_code, 0);
  const Outcome run = place.run({"run", "cases/case.toml", "--dry-run"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
}

TEST(InitCommand, ListsThePointArraysOfTheSurface) {
  Workplace place;
  place.write_cube("cube.obj");
  ASSERT_EQ(place.run({"convert", "cube.obj", "cube.vtk"}).exit_code, 0);
  place.write("cube.vtk",
              place.read("cube.vtk") + "\nPOINT_DATA 8\nSCALARS H double 1\nLOOKUP_TABLE default\n1 1 1 1 1 1 1 1\n");
  EXPECT_THAT(place.run({"init", "cube.vtk"}).out, HasSubstr("\n#   \"H\"\n"));
}

TEST(InitCommand, NeverOverwritesUnasked) {
  Workplace place;
  place.write("case.toml", "mine");
  const Outcome refused = place.run({"init", "-o", "case.toml"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr("--force"));
  EXPECT_EQ(place.read("case.toml"), "mine");
  EXPECT_EQ(place.run({"init", "-o", "case.toml", "--force"}).exit_code, 0);
  EXPECT_THAT(place.read("case.toml"), HasSubstr("format = 1"));
}

}  // namespace
}  // namespace nearwall::program
