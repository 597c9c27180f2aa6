#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/program/workplace.h"

namespace nearwall::program {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

TEST(Program, AlonePrintsAnOverviewOfAllCommands) {
  const Outcome alone = Workplace().run({});
  EXPECT_EQ(alone.exit_code, 0);
  for (const char* command :
       {"run", "batch", "init", "check", "normals", "picture", "certify", "layers", "shape", "convert"}) {
    EXPECT_THAT(alone.out, HasSubstr(std::string("\n    ") + command + " "));
  }
  EXPECT_THAT(alone.err, IsEmpty());
}

TEST(Program, TellsItsVersion) {
  const Outcome version = Workplace().run({"--version"});
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_THAT(version.out, testing::MatchesRegex("nearwall [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

class EveryCommand : public testing::TestWithParam<const char*> {};

TEST_P(EveryCommand, HasHelpWithAnExampleOfItself) {
  const std::string command = GetParam();
  const Outcome help = Workplace().run({command, "--help"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_THAT(help.out, HasSubstr("\nexample\n  nearwall " + command));
  for (const char* option : {"--help", "--json", "--quiet", "--verbose", "--threads"}) {
    EXPECT_THAT(help.out, HasSubstr(option));
  }
}

TEST_P(EveryCommand, NamesTheNearestOfItsOptions) {
  const Outcome wrong = Workplace().run({GetParam(), "--qiuet"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.out, IsEmpty());
  EXPECT_THAT(wrong.err, HasSubstr("unknown option '--qiuet'; did you mean '--quiet'?"));
}

TEST_P(EveryCommand, RefusesSomeThreads) {
  EXPECT_EQ(Workplace().run({GetParam(), "--threads", "-1"}).exit_code, 2);
  EXPECT_EQ(Workplace().run({GetParam(), "--threads", "many"}).exit_code, 2);
}

INSTANTIATE_TEST_SUITE_P(Commands, EveryCommand,
                         testing::Values("run", "batch", "check", "init", "normals", "layers", "shape", "picture",
                                         "convert", "certify"),
                         [](const auto& tested) { return std::string(tested.param); });

TEST(Program, NamesTheNearestCommand) {
  const Outcome wrong = Workplace().run({"chekc"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("unknown command 'chekc'; did you mean 'check'?"));
}

TEST(Program, NamesTheNearestOptionThoughAnArgumentIsMissing) {
  const Outcome wrong = Workplace().run({"run", "--dry-rum"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("did you mean '--dry-run'?"));
}

TEST(Program, TellsWhatIsMissing) {
  const Outcome wrong = Workplace().run({"run"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("CASE.toml"));
  EXPECT_THAT(wrong.err, HasSubstr("nearwall run --help"));
}

TEST(Program, CannotBeQuietAndVerboseAtOnce) {
  EXPECT_EQ(Workplace().run({"shape", "--quiet", "--verbose"}).exit_code, 2);
}

TEST(Program, TellsErrorsAsJsonToo) {
  const Outcome wrong = Workplace().run({"run", "missing.toml", "--json"});
  const auto json = nlohmann::json::parse(wrong.out);
  EXPECT_EQ(json["error"]["exit_code"], wrong.exit_code);
  EXPECT_EQ(json["error"]["kind"], "input");
  EXPECT_THAT(json["error"]["message"].get<std::string>(), HasSubstr("missing.toml"));
  EXPECT_THAT(wrong.err, HasSubstr("missing.toml"));
}

TEST(Program, SaysWhenStandardOutputTakesNoMore) {
  Workplace place;
  std::filesystem::create_symlink("/dev/full", place.path(".out"));
  EXPECT_EQ(place.run({"shape"}).exit_code, 5);
}

TEST(Program, WritesNoControlCharactersToAFile) {
  Workplace place;
  place.write_cube("cube.obj");
  const Outcome outcome = place.run({"check", "cube.obj"});
  EXPECT_THAT(outcome.err, Not(HasSubstr("\033")));
  EXPECT_THAT(outcome.err, Not(HasSubstr("\r")));
}

}  // namespace
}  // namespace nearwall::program
