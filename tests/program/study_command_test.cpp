#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/program/workplace.h"

namespace nearwall::program {
namespace {

using nlohmann::json;
using testing::HasSubstr;

TEST(StudyCommand, ListsTheStudies) {
  const Outcome outcome = Workplace().run({"study", "--json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const json studies = json::parse(outcome.out)["studies"];
  ASSERT_EQ(studies.size(), 3u);
  EXPECT_EQ(studies[0]["name"], "ubach");
  EXPECT_EQ(studies[1]["name"], "bohdal");
  EXPECT_EQ(studies[2]["name"], "aubry-lohner");
}

TEST(StudyCommand, WritesTablesAndPlots) {
  Workplace place;
  const Outcome outcome = place.run({"study", "ubach", "--samples", "50", "-o", "out/ubach", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json result = json::parse(outcome.out);
  EXPECT_EQ(result["study"], "ubach");
  EXPECT_EQ(result["tables"][0]["columns"].size(), 11u);
  EXPECT_EQ(result["tables"][0]["rows"].size(), 7u);
  for (const json& file : result["files"]) EXPECT_TRUE(place.has(file)) << file;
  EXPECT_THAT(place.read("out/ubach/study-ubach.md"), HasSubstr("(study-ubach-6.svg)"));
  EXPECT_THAT(place.read("out/ubach/study-ubach-6.svg"), HasSubstr("<svg"));
}

TEST(StudyCommand, PrintsTheSameAtAnyNumberOfThreads) {
  const auto printed = [](const char* n_threads) {
    return Workplace().run({"study", "ubach", "--samples", "4200", "--threads", n_threads}).out;
  };
  const std::string one = printed("1");
  EXPECT_THAT(one, HasSubstr("RMSE in degrees, n_p = 6"));
  EXPECT_EQ(one, printed("2"));
}

TEST(StudyCommand, RefusesAnUnknownStudyWithTheNearest) {
  const Outcome outcome = Workplace().run({"study", "bohdahl"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("did you mean 'bohdal'?"));
}

TEST(StudyCommand, RefusesNoSamples) {
  EXPECT_EQ(Workplace().run({"study", "ubach", "--samples", "0"}).exit_code, 2);
  EXPECT_EQ(Workplace().run({"study", "bohdal", "--repetitions", "0"}).exit_code, 2);
}

TEST(StudyCommand, ExitsWith5IfTheFolderCannotBeMade) {
  Workplace place;
  place.write("file", "");
  const Outcome outcome = place.run({"study", "ubach", "--samples", "100000000", "-o", "file/below"});
  EXPECT_EQ(outcome.exit_code, 5);
  EXPECT_THAT(outcome.err, HasSubstr("file/below"));
}

}  // namespace
}  // namespace nearwall::program
