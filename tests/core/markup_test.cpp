#include "core/markup.hpp"

#include <gtest/gtest.h>

namespace scanchor {
namespace {

TEST(Markup, WhatHasAMeaningIsWrittenOut) {
  EXPECT_EQ(escape_markup("<b a='1'>&\"</b>"), "&lt;b a=&#39;1&#39;&gt;&amp;&quot;&lt;/b&gt;");
}

TEST(Markup, ControlCharactersAreLeftOutAndUtf8Stays) {
  EXPECT_EQ(escape_markup("a\x01\x1b[0m\tb\nc"), "a[0m\tb\nc");
  EXPECT_EQ(escape_markup("\u00b1 5 \u2026"), "\u00b1 5 \u2026");
}

}  // namespace
}  // namespace scanchor
