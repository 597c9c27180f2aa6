#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <nlohmann/json.hpp>

#include "tests/program/workplace.h"

namespace nearwall::program {
namespace {

using nlohmann::json;
using testing::HasSubstr;

const json& result_of(const json& batch, const std::string& name) {
  for (const json& item : batch["cases"]) {
    if (item["case"] == name) return item;
  }
  static const json kNone;
  ADD_FAILURE() << "no case " << name << " in " << batch;
  return kNone;
}

/// Three cases: one good, one whose surface is open, one with a wrong key.
void write_three_cases(const Workplace& place) {
  place.write_cube("cases/good/cube.obj");
  place.write_case("cases/good/case.toml", "cube.obj");
  place.write_open_cube("cases/open/open.obj");
  place.write_case("cases/open/case.toml", "open.obj");
  place.write_case("cases/wrong/case.toml", "cube.obj", "colour = 1\n");
  place.write("cases/pyproject.toml", "[tool]\nname = \"no case\"\n");
}

TEST(BatchCommand, OneBadCaseStopsNoOther) {
  Workplace place;
  write_three_cases(place);
  const Outcome outcome = place.run({"batch", "cases", "-j", "2", "--json"});
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  const json batch = json::parse(outcome.out);
  EXPECT_EQ(batch["cases"].size(), 3u);
  EXPECT_EQ(batch["done"], 1);
  EXPECT_EQ(batch["failed"], 2);
  const json& good = result_of(batch, "good/case.toml");
  EXPECT_EQ(good["result"], "certified");
  EXPECT_EQ(good["triangles"], 12);
  EXPECT_EQ(good["cells"], 36);
  EXPECT_NEAR(good["coverage_percent"].get<double>(), 100, 1e-9);
  EXPECT_EQ(result_of(batch, "open/case.toml")["exit_code"], 3);
  EXPECT_EQ(result_of(batch, "wrong/case.toml")["exit_code"], 2);
  EXPECT_THAT(result_of(batch, "wrong/case.toml")["message"].get<std::string>(), HasSubstr("colour"));
  EXPECT_TRUE(place.has("cases/good/out/cube.vtu"));
}

TEST(BatchCommand, PrintsATableInTheOrderOfTheCases) {
  Workplace place;
  write_three_cases(place);
  const Outcome outcome = place.run({"batch", "cases", "-j", "3"});
  EXPECT_EQ(outcome.exit_code, 1);
  const auto good = outcome.out.find("good/case.toml");
  const auto open = outcome.out.find("open/case.toml");
  const auto wrong = outcome.out.find("wrong/case.toml");
  EXPECT_LT(good, open);
  EXPECT_LT(open, wrong);
  EXPECT_THAT(outcome.out, HasSubstr("1 of 3 certified, 2 failed"));
  EXPECT_THAT(outcome.out, HasSubstr("the surface cannot be used: 3 open edges"));
}

TEST(BatchCommand, ExitsWith0IfAllAreDone) {
  Workplace place;
  write_three_cases(place);
  EXPECT_EQ(place.run({"batch", "cases/good/case.toml"}).exit_code, 0);
  EXPECT_EQ(place.run({"batch", "cases", "--exclude", "open/*", "--exclude", "wrong/*"}).exit_code, 0);
}

TEST(BatchCommand, ResumeSkipsWhatIsComplete) {
  Workplace place;
  write_three_cases(place);
  ASSERT_EQ(place.run({"batch", "cases/good"}).exit_code, 0);
  const auto written = std::filesystem::last_write_time(place.path("cases/good/out/cube.vtu"));
  const Outcome again = place.run({"batch", "cases/good", "--resume", "--json"});
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_EQ(json::parse(again.out)["cases"][0]["cells"], 36);
  EXPECT_EQ(std::filesystem::last_write_time(place.path("cases/good/out/cube.vtu")), written);
  EXPECT_EQ(place.run({"batch", "cases/good"}).exit_code, 0);
  EXPECT_NE(std::filesystem::last_write_time(place.path("cases/good/out/cube.vtu")), written);
}

TEST(BatchCommand, MeshesSurfacesByATemplate) {
  Workplace place;
  place.write_cube("surfaces/a/cube.obj");
  place.write_cube("surfaces/b \"quoted\"/cube.obj");
  place.write_cube("surfaces/b \"quoted\"/cube_domain.obj");
  place.write_open_cube("surfaces/open.obj");
  place.write_case("case.toml", "any.stl");
  const Outcome outcome = place.run({"batch", "surfaces", "--template", "case.toml", "--relative", "--exclude",
                                     "*_domain*", "-o", "there", "--table", "table.md", "--json"});
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  const json batch = json::parse(outcome.out);
  EXPECT_EQ(batch["cases"].size(), 3u);
  EXPECT_EQ(batch["done"], 2);
  EXPECT_TRUE(place.has("there/a/cube.obj/cube.vtu"));
  EXPECT_TRUE(place.has("there/b \"quoted\"/cube.obj/cube.vtu"));
  const std::string table = place.read("table.md");
  EXPECT_THAT(table, HasSubstr("| a/cube.obj | certified | 12 | 36 | 100.0 |"));
  EXPECT_THAT(table, HasSubstr("| open.obj | surface |"));
}

TEST(BatchCommand, TellsNoPathOfTheMachineInItsTable) {
  Workplace place;
  std::filesystem::create_directory(place.path("surfaces"));
  place.write("surfaces/broken.off", "OFF\n3 1 0\nno numbers\n");
  place.write_case("case.toml", "any.stl");
  EXPECT_EQ(place.run({"batch", "surfaces", "--template", "case.toml", "--table", "table.md"}).exit_code, 1);
  const std::string table = place.read("table.md");
  EXPECT_THAT(table, HasSubstr("| broken.off:2: "));
  EXPECT_THAT(table, testing::Not(HasSubstr(place.path("surfaces").string())));
}

TEST(BatchCommand, FindsNothingToDo) {
  Workplace place;
  std::filesystem::create_directory(place.path("empty"));
  const Outcome outcome = place.run({"batch", "empty"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--template"));
}

TEST(BatchCommand, CountsAMissingCaseAsFailedAndGoesOn) {
  Workplace place;
  write_three_cases(place);
  const Outcome outcome = place.run({"batch", "missing.toml", "cases/good/case.toml", "--json"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(json::parse(outcome.out)["done"], 1);
}

TEST(BatchCommand, InterruptStopsTheChildrenToo) {
  Workplace place;
  ASSERT_EQ(place.run({"shape", "sphere", "--size", "0.01", "-o", "sphere.stl"}).exit_code, 0);
  place.write_case("a.toml", "sphere.stl", "directory = \"a\"\n");
  place.write_case("b.toml", "sphere.stl", "directory = \"b\"\n");
  place.write_cube("cube.obj");
  place.write_case("first.toml", "cube.obj", "directory = \"first\"\n");
  const pid_t process = place.start({"batch", "first.toml", "a.toml", "b.toml", "--json", "--set", "layers.count=40"});
  ASSERT_TRUE(place.has_said("first.toml"));  // and a.toml begins
  kill(process, SIGINT);
  const Outcome outcome = place.wait(process);
  EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
  const json batch = json::parse(outcome.out);
  EXPECT_EQ(result_of(batch, "first.toml")["result"], "certified");
  EXPECT_EQ(result_of(batch, "a.toml")["exit_code"], 130);
  EXPECT_EQ(result_of(batch, "b.toml")["result"], "not run");
  EXPECT_THAT(place.files("a"), testing::IsEmpty());
  EXPECT_FALSE(place.has("b"));
}

}  // namespace
}  // namespace nearwall::program
