#include "nearwall/core/markup.h"

#include <gtest/gtest.h>

namespace nearwall {
namespace {

TEST(EscapedMarkup, LeavesNothingThatAParserWouldTakeForMarkup) {
  EXPECT_EQ(escaped_markup("<a href=\"x\" b='y'>&amp;</a>"),
            "&lt;a href=&quot;x&quot; b=&#39;y&#39;&gt;&amp;amp;&lt;/a&gt;");
}

TEST(EscapedMarkup, LeavesOtherTextAlone) { EXPECT_EQ(escaped_markup("wing, 2 µm; 50 %"), "wing, 2 µm; 50 %"); }

}  // namespace
}  // namespace nearwall
