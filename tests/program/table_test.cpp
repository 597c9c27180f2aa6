#include "program/table.h"

#include <gtest/gtest.h>

namespace nearwall::program {
namespace {

TEST(Table, PutsNumbersToTheRightAndCountsCharactersNotBytes) {
  Table table({{"name"}, {"n", true}});
  table.add_row({"flügel", "7"});
  table.add_row({"a", "123"});
  EXPECT_EQ(table.to_text(),
            "name      n\n"
            "------  ---\n"
            "flügel    7\n"
            "a       123\n");
}

TEST(Table, WritesMarkdownWithBarsEscaped) {
  Table table({{"name"}, {"n", true}});
  table.add_row({"a|b\nc", "1"});
  EXPECT_EQ(table.to_markdown(), "| name | n |\n| --- | ---: |\n| a\\|b c | 1 |\n");
}

TEST(Grouped, SetsACommaBeforeEachThirdDigit) {
  EXPECT_EQ(grouped(0), "0");
  EXPECT_EQ(grouped(999), "999");
  EXPECT_EQ(grouped(1000), "1,000");
  EXPECT_EQ(grouped(1234567), "1,234,567");
}

TEST(Duration, ChoosesItsUnit) {
  EXPECT_EQ(duration(0.0421), "0.04 s");
  EXPECT_EQ(duration(9.999), "10.0 s");
  EXPECT_EQ(duration(59.99), "1 min 00 s");
  EXPECT_EQ(duration(185), "3 min 05 s");
  EXPECT_EQ(duration(3660), "1 h 01 min");
}

TEST(Bytes, ChoosesItsUnit) {
  EXPECT_EQ(bytes(999), "999 B");
  EXPECT_EQ(bytes(1.5e9), "1.5 GB");
}

}  // namespace
}  // namespace nearwall::program
