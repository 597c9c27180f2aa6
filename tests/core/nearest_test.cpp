#include "nearwall/core/nearest.h"

#include <gtest/gtest.h>

#include <array>

namespace nearwall {
namespace {

const std::array<std::string, 4> kWords = {"first_height", "growth", "count", "total_thickness"};

TEST(Nearest, FindsAWordWithOneLetterWrong) { EXPECT_EQ(nearest("grouth", kWords), "growth"); }
TEST(Nearest, CountsASwapOfNeighboursAsOneChange) { EXPECT_EQ(nearest("cuont", kWords), "count"); }
TEST(Nearest, TakesNoNoticeOfCase) { EXPECT_EQ(nearest("FIRST_HEIGHT", kWords), "first_height"); }
TEST(Nearest, ForgivesAThirdOfALongWord) { EXPECT_EQ(nearest("total_thick", kWords), "total_thickness"); }
TEST(Nearest, IsEmptyWhereNothingIsNear) { EXPECT_EQ(nearest("velocity", kWords), ""); }

TEST(Nearest, DoesNotMatchAWordThatSharesNoLetter) {
  const std::array<std::string, 1> short_word = {"ab"};
  EXPECT_EQ(nearest("xy", short_word), "");
}

TEST(Nearest, TakesTheFirstOfEquallyNearWords) {
  const std::array<std::string, 2> words = {"bat", "cat"};
  EXPECT_EQ(nearest("hat", words), "bat");
}

}  // namespace
}  // namespace nearwall
