#include "nearwall/studies/report.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

namespace nearwall::studies {
namespace {

/// A number as a table shows it.
std::string shown(double value) {
  const std::string text =
      to_markdown(Table{.title = "t", .row_title = "r", .columns = {"c"}, .rows = {{"x", {value}}}});
  const std::string before = "| x | ";
  const auto begin = text.find(before) + before.size();
  return text.substr(begin, text.find(" |", begin) - begin);
}

TEST(Table, KeepsFourDigits) {
  EXPECT_EQ(shown(1.5), "1.500");
  EXPECT_EQ(shown(0.00018304), "0.0001830");
  EXPECT_EQ(shown(54.148), "54.15");
  EXPECT_EQ(shown(1234.5), "1234");
  EXPECT_EQ(shown(123456.7), "123457");
}

TEST(Table, LeavesCountsAlone) {
  EXPECT_EQ(shown(7083), "7083");
  EXPECT_EQ(shown(0), "0");
}

TEST(Table, HasADashForWhatIsNotThere) { EXPECT_EQ(shown(std::nan("")), "–"); }

TEST(Report, BecomesMarkdown) {
  const Report report{.name = "x",
                      .settings = "seed 1.",
                      .tables = {{.title = "T", .row_title = "k", .columns = {"a", "b"}, .rows = {{"r", {1, 2.5}}}}},
                      .pictures = {{"p.svg", "what it shows", ""}}};
  EXPECT_EQ(to_markdown(report),
            "# Study x\n\nseed 1.\n\nT\n\n| k | a | b |\n| --- | ---: | ---: |\n| r | 1 | 2.500 |\n"
            "\n![what it shows](p.svg)\n");
}

}  // namespace
}  // namespace nearwall::studies
