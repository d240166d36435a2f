#include "cloud/text_lines.hpp"

#include <gtest/gtest.h>

namespace scanchor {
namespace {

TEST(TextLines, TokensBetweenBlanks) {
  std::string_view rest = "  a\tbc  d\r";
  EXPECT_EQ(next_token(rest), "a");
  EXPECT_EQ(next_token(rest), "bc");
  EXPECT_EQ(next_token(rest), "d");
  EXPECT_EQ(next_token(rest), "");
  EXPECT_EQ(next_token(rest), "");
}

TEST(TextLines, FurtherSeparators) {
  std::string_view rest = "1,2; 3";
  EXPECT_EQ(next_token(rest, ',', ';'), "1");
  EXPECT_EQ(next_token(rest, ',', ';'), "2");
  EXPECT_EQ(next_token(rest, ',', ';'), "3");
}

TEST(TextLines, LinesOfBothKindsAreCounted) {
  LineReader lines("a\r\n\nb", 10);
  std::string_view line;
  ASSERT_TRUE(lines.next(line));
  EXPECT_EQ(line, "a");
  EXPECT_EQ(lines.number(), 10U);
  ASSERT_TRUE(lines.next(line));
  EXPECT_EQ(line, "");
  EXPECT_EQ(lines.rest(), "b");
  ASSERT_TRUE(lines.next(line));
  EXPECT_EQ(line, "b");
  EXPECT_EQ(lines.number(), 12U);
  EXPECT_FALSE(lines.next(line));
}

}  // namespace
}  // namespace scanchor
