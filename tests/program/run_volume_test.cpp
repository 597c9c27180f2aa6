#include <stdlib.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/program/workplace.h"

namespace nearwall::program {
namespace {

using nlohmann::json;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

const char* const kFilled = "[volume]\nfill = \"tetgen\"\nfarfield = { radius = 6, size = 3 }\n";

TEST(RunCommand, FillsTheVolumeAndCertifiesTheFile) {
  Workplace place;
  place.write_cube("cube.obj");
  place.write_case("case.toml", "cube.obj", kFilled);
  const Outcome outcome = place.run({"run", "case.toml"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("farfield"));
  EXPECT_THAT(place.files("out"), Contains("cube.vtu"));
  EXPECT_THAT(place.files("out"), Not(Contains("cube-layers.vtu")));
  const Outcome certified = place.run({"certify", "out/cube.vtu"});
  EXPECT_EQ(certified.exit_code, 0) << certified.out << certified.err;
}

TEST(RunCommand, EndsWithExitCode4WhereTheVolumeCannotBeFilled) {
  Workplace place;
  place.write_cube("cube.obj");
  place.write_case("case.toml", "cube.obj", kFilled);
  ::setenv("NEARWALL_TETGEN", "/bin/false", 1);
  const Outcome outcome = place.run({"run", "case.toml"});
  ::unsetenv("NEARWALL_TETGEN");
  EXPECT_EQ(outcome.exit_code, 4);
  const json report = json::parse(place.read("out/report.json"));
  EXPECT_THAT(outcome.err + outcome.out, HasSubstr(report["volume_failure"].get<std::string>()));
  EXPECT_THAT(place.files("out"), Contains("cube-layers.vtu"));
  EXPECT_THAT(place.files("out"), Not(Contains("cube-fill-faults.vtp")));
  EXPECT_THAT(place.files("out"), Not(Contains("cube.vtu")));
  EXPECT_EQ(place.run({"certify", "out/cube-layers.vtu"}).exit_code, 0);
}

TEST(RunCommand, RefusesAPlaneOfSymmetryThroughTheBody) {
  Workplace place;
  place.write_cube("cube.obj");
  place.write_case("case.toml", "cube.obj", std::string(kFilled) + "symmetry = [{ axis = \"x\", at = 0.5 }]\n");
  const Outcome outcome = place.run({"run", "case.toml"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("x = 0.5"));
}

}  // namespace
}  // namespace nearwall::program
