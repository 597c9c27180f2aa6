#include "program/coverage_table.h"

#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "program/table.h"

namespace nearwall::program {
namespace {

using mesh::LimitReason;
using testing::HasSubstr;
using testing::Not;

PatchReport wall(const std::string& name, double area, double full) {
  PatchReport patch{.name = name, .coverage = {}};
  quality::PatchCoverage& c = patch.coverage;
  c.area = area;
  c.full_percent = c.all_layers_percent = c.first_height_met_percent = full;
  c.mean_layers = 20 * full / 100;
  c.asked.count = 20;
  c.asked.total_thickness = 0.5;
  c.thickness.median = 0.25;
  c.limit_percent[static_cast<std::size_t>(LimitReason::Gap)] = 100 - full;
  return patch;
}

std::size_t longest_line(const std::string& text) {
  std::istringstream in(text);
  std::size_t longest = 0;
  for (std::string line; std::getline(in, line);) longest = std::max(longest, text_width(line));
  return longest;
}

TEST(CoverageTable, HasARowForEachPatchAndOneForAllWalls) {
  Report report;
  report.patches = {
      wall("wing", 3, 100), wall("hull", 1, 60), {.name = "inlet", .type = PatchType::NoLayer, .coverage = {}}};
  const std::string text = coverage_table(report, false);
  EXPECT_THAT(text, testing::ContainsRegex("wing +3 +100.0 +100.0 +20.0 of 20 +100.0 +0.25 +50.0\n"));
  EXPECT_THAT(text, testing::ContainsRegex("hull +1 +60.0 +60.0 +12.0 of 20 +60.0 +0.25 +50.0 +gap 40.0\n"));
  EXPECT_THAT(text, testing::ContainsRegex("inlet.* no layers asked\n"));
  EXPECT_THAT(text, testing::ContainsRegex("all walls +4 +90.0 +90.0 +18.0 of 20 +90.0 +- +- +gap 10.0\n"));
}

TEST(CoverageTable, OfOneWallNeedsNoSum) {
  Report report;
  report.patches = {wall("wing", 3, 100)};
  EXPECT_THAT(coverage_table(report, false), Not(HasSubstr("all walls")));
}

TEST(CoverageTable, PutsThePatchesThatLackLeastTogether) {
  Report report;
  for (int i = 0; i < 60; ++i)
    report.patches.push_back(wall(fmt::format("part-{}", i), 1, i == 59 ? 10 : 100 - i / 10.0));
  const std::string text = coverage_table(report, false);
  EXPECT_THAT(text, HasSubstr("part-59 "));
  EXPECT_THAT(text, HasSubstr("part-58 "));
  EXPECT_THAT(text, Not(HasSubstr("part-0 ")));
  // 40 patches lack 0, 0.1, …, 3.9 %: 1.95 % in the mean.
  EXPECT_THAT(text, testing::ContainsRegex("… 40 more +40 +98.0 +98.0"));
  EXPECT_THAT(text, testing::ContainsRegex("all walls +60 "));
  const std::string whole = coverage_table(report, true);
  EXPECT_THAT(whole, HasSubstr("part-0 "));
  EXPECT_THAT(whole, Not(HasSubstr("…")));
}

TEST(CoverageTable, FitsTheScreenWithLongNamesAndManyReasons) {
  Report report;
  report.patches = {wall(std::string(200, 'n') + "ü", 12345.6789, 1.25e-3),
                    wall("füüüüüüüüüüüüüüüüüüüüüüüüüüüüüüüüü", 1e-30, 50)};
  report.patches[0].coverage.limit_percent = {0, 0, 60.5, 20.5, 10.5, 8.5, 0, 0, 0};
  const std::string text = coverage_table(report, false);
  EXPECT_LE(longest_line(text), 120u) << text;
  EXPECT_THAT(text, HasSubstr(" nnnnnnnnn…nnnnnnnnü "));
  EXPECT_THAT(text, HasSubstr(" füüüüüüüü…üüüüüüüüü "));
  EXPECT_THAT(coverage_table(report, true), HasSubstr(report.patches[0].name));
}

TEST(CoverageTable, KeepsLongNamesApart) {
  Report report;
  const std::string middle(30, 'm');
  for (const char* name : {"inboard", "outboard"})
    report.patches.push_back(wall("wing-upper-surface-" + std::string(name), 1, 50));
  for (const char* c : {"a", "b", "c"}) report.patches.push_back(wall("nacelle" + middle + c + middle + "lip", 1, 50));
  const std::string text = coverage_table(report, false);
  EXPECT_THAT(text, HasSubstr("\n  wing-uppe…e-inboard "));
  EXPECT_THAT(text, HasSubstr("\n  wing-uppe…-outboard "));
  for (const char* name : {"nacellemmmmmmmmm…#3", "nacellemmmmmmmmm…#4", "nacellemmmmmmmmm…#5"})
    EXPECT_THAT(text, HasSubstr(name));
}

TEST(CoverageTable, SaysWhatPatchesWithoutLayersAre) {
  Report report;
  report.patches = {wall("wing", 3, 100), {.name = "mid", .type = PatchType::Symmetry, .coverage = {}}};
  EXPECT_THAT(coverage_table(report, false), testing::ContainsRegex("mid .* symmetry\n"));
}

TEST(CoverageTable, NeverCallsAllWhatIsNotAll) {
  Report report;
  report.patches = {wall("wing", 1, 99.9999), wall("hull", 1e6, 100)};
  EXPECT_THAT(coverage_table(report, false), testing::ContainsRegex("all walls +1e\\+06 +99.9 +99.9 "));
}

TEST(LinesAtWall, AreToldWithTheirReasonAndAPlace) {
  Report report;
  report.patches = {wall("hull", 1, 60)};
  EXPECT_EQ(lines_at_wall(report), "");
  report.limited.n_lines = 1234;
  report.limited.by_reason[static_cast<std::size_t>(LimitReason::PatchEdge)] = {
      9, 9, {{VertexId(1), PatchId(0), {1, 1, 1}, 1, 0, 0, 1}}};
  report.limited.by_reason[static_cast<std::size_t>(LimitReason::Visibility)] = {
      3, 2, {{VertexId(5), PatchId(0), {1, 0, 0.5}, 1, 0, 0, 1}}};
  report.limited.by_reason[static_cast<std::size_t>(LimitReason::Gap)] = {
      70, 0, {{VertexId(7), PatchId(0), {2, 0, 0}, 1, 4, 0.5, 1}}};
  EXPECT_EQ(lines_at_wall(report),
            "11 of 1,234 lines stay at the wall: visibility 2, one at (1, 0, 0.5) on 'hull'; patch-edge 9");
}

}  // namespace
}  // namespace nearwall::program
