#include "reasoning/sdl_lexer.hpp"

#include <gtest/gtest.h>

namespace scanchor {
namespace {

TEST(SdlLexer, SplitsRangesNumbersAndWords) {
  const auto line = scan_line("\t area 0.9..1.7 m2,  # why: \t", 7);
  ASSERT_EQ(line.tokens.size(), 7U);
  EXPECT_EQ(line.number, 7);
  EXPECT_EQ(line.indent, 5);
  EXPECT_EQ(line.tokens[0].text, "area");
  EXPECT_EQ(line.tokens[0].column, 3);
  EXPECT_DOUBLE_EQ(line.tokens[1].value, 0.9);
  EXPECT_EQ(line.tokens[2].kind, Token::Kind::dots);
  EXPECT_DOUBLE_EQ(line.tokens[3].value, 1.7);
  EXPECT_EQ(line.tokens[4].text, "m2");
  EXPECT_EQ(line.tokens[5].kind, Token::Kind::comma);
  EXPECT_EQ(line.tokens[6].kind, Token::Kind::end);
  EXPECT_EQ(line.comment, "why:");
}

TEST(SdlLexer, UnitsMayTouchTheirNumber) {
  const auto line = scan_line("12cm", 1);
  ASSERT_EQ(line.tokens.size(), 3U);
  EXPECT_DOUBLE_EQ(line.tokens[0].value, 12.0);
  EXPECT_EQ(line.tokens[1].text, "cm");
}

TEST(SdlLexer, WordsMayBeUtf8) {
  const auto line = scan_line("class Büro-Möbel:", 1);
  EXPECT_EQ(line.tokens[1].text, "Büro-Möbel");
}

TEST(SdlLexer, SplitWords) {
  EXPECT_EQ(split_words("same size as"), (std::vector<std::string>{"same", "size", "as"}));
}

}  // namespace
}  // namespace scanchor
