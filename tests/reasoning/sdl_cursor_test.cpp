#include "reasoning/sdl_cursor.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace scanchor {
namespace {

TEST(SdlCursor, WalksAlongALine) {
  const std::string text = "at least 2 (boards)";
  const std::string file = "x.sdl";
  SdlCursor cursor(text, file);
  cursor.start(scan_line(text, 1));
  EXPECT_TRUE(cursor.at_words("at least"));
  EXPECT_FALSE(cursor.accept_words("at most"));
  EXPECT_EQ(cursor.rest(), "at least 2 ( boards )");
  EXPECT_TRUE(cursor.accept_words("at least"));
  EXPECT_DOUBLE_EQ(cursor.take().value, 2.0);
  EXPECT_FALSE(cursor.accept_sign(")"));
  EXPECT_TRUE(cursor.accept_sign("("));
  EXPECT_FALSE(cursor.accept("board"));
  EXPECT_TRUE(cursor.accept("boards"));
  EXPECT_THROW(cursor.expect_end(), Error);
  cursor.take();
  EXPECT_TRUE(cursor.at_end());
  EXPECT_EQ(cursor.take().kind, Token::Kind::end) << "the end stays the end";
  EXPECT_NO_THROW(cursor.expect_end());
}

TEST(SdlCursor, FailureNamesThePlace) {
  const std::string text = "one two";
  const std::string file = "x.sdl";
  SdlCursor cursor(text, file);
  cursor.start(scan_line(text, 1));
  cursor.take();
  try {
    cursor.expect_end();
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()),
              "x.sdl:1:5: nothing more was expected here, found 'two'\n  one two\n      ^");
  }
}

}  // namespace
}  // namespace scanchor
