#include "nearwall/core/expect.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nearwall/core/errors.h"

namespace nearwall {
namespace {

TEST(Expect, SaysWhereAndWhatWasExpected) {
  try {
    expect(false, "the moon to be round");
    FAIL() << "did not throw";
  } catch (const InternalError& e) {
    EXPECT_THAT(e.what(), testing::HasSubstr("expected the moon to be round"));
    EXPECT_THAT(e.what(), testing::HasSubstr("expect_test.cpp:"));
  }
}

TEST(Expect, IsSilentWhenAllIsWell) { EXPECT_NO_THROW(expect(true, "nothing")); }

}  // namespace
}  // namespace nearwall
