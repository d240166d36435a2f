#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/random.hpp"
#include "reasoning/query.hpp"
#include "tests/reasoning/support/built.hpp"

namespace scanchor {
namespace {

struct AskedRow {
  const char* asked;
  const char* read;
};

class QueryTable : public testing::TestWithParam<AskedRow> {};

TEST_P(QueryTable, IsReadAsMeant) {
  const Query query = parse_query(GetParam().asked, test::office());
  EXPECT_EQ(query_text(query), GetParam().read);
  EXPECT_EQ(query_text(parse_query(query_text(query), test::office())), GetParam().read)
      << "read again it means the same";
}

INSTANTIATE_TEST_SUITE_P(
    Rows, QueryTable,
    testing::Values(
        AskedRow{"desk", "a desk"}, AskedRow{"Desks", "a desk"},
        AskedRow{"find the screen", "the monitor"}, AskedRow{"where is the door?", "the door"},
        AskedRow{"screen on a desk", "a monitor on a desk"},
        AskedRow{"screens that are on desks", "a monitor on a desk"},
        AskedRow{"box on a desk near a window", "a box on a desk near a window"},
        AskedRow{"box on a desk and near a window", "a box on a desk and near a window"},
        AskedRow{"box on a desk that is near a window and rectangular and near a door",
                 "a box on a desk (near a window and that is rectangular and near a door)"},
        AskedRow{"box on a desk (near a window) and near a door",
                 "a box on a desk (near a window) and near a door"},
        AskedRow{"box that is on a desk and is near a window and has area over 1 m2",
                 "a box on a desk and near a window and that has area over 1 m2"},
        AskedRow{"desk with no screen", "a desk without a monitor"},
        AskedRow{"desk without a screen", "a desk without a monitor"},
        AskedRow{"desk with a screen", "a desk with a monitor"},
        AskedRow{"desk with 2 screens", "a desk with exactly 2 monitors"},
        AskedRow{"desk with at least 2 screens near a door",
                 "a desk with at least 2 monitors near a door"},
        AskedRow{"desk with area over 1 m2", "a desk that has area over 1 m2"},
        AskedRow{"nearest desk", "the nearest desk"},
        AskedRow{"the nearest chair to a desk", "the chair nearest to a desk"},
        AskedRow{"chair farthest from the door", "the chair farthest from the door"},
        AskedRow{"second largest window", "the second largest window"},
        AskedRow{"second board from the top of the shelf",
                 "the second highest shelf board of the shelf"},
        AskedRow{"2nd board from the bottom of a shelf",
                 "the second lowest shelf board of a shelf"},
        AskedRow{"last board from the top", "the lowest shelf board"},
        AskedRow{"top board of the shelf", "the highest shelf board of the shelf"},
        AskedRow{"third monitor from the left", "the third leftmost monitor"},
        AskedRow{"side of the shelf", "a side of the shelf"},
        AskedRow{"chair left of the shelf seen from the robot", "a chair left of the shelf"},
        AskedRow{"box between a desk and a door", "a box between a desk and a door"},
        AskedRow{"box between a desk near a door and a window that is rectangular",
                 "a box between a desk (near a door) and a window that is rectangular"},
        AskedRow{"what is on the desk", "a thing on the desk"},
        AskedRow{"thing within 0.5 m of a door", "a thing within 0.5 m of a door"},
        AskedRow{"chair not near a desk", "a chair not near a desk"},
        AskedRow{"board that has top at most 1 m above a floor",
                 "a shelf board top at most 1 m above a floor"},
        AskedRow{"how many chairs near a desk", "count chairs near a desk"},
        AskedRow{"how many chairs are there", "count chairs"},
        AskedRow{"how many chairs are near a desk", "count chairs near a desk"},
        AskedRow{"how many boards", "count shelf boards"}, AskedRow{"count things", "count things"},
        AskedRow{"desk with 1 screen", "a desk with exactly 1 monitor"},
        AskedRow{"desk not with 2 screens", "a desk not with exactly 2 monitors"},
        AskedRow{"last nearest chair on the second desk from the left",
                 "the farthest chair on the second leftmost desk"},
        AskedRow{"second chair nearest to a desk", "the second chair nearest to a desk"},
        AskedRow{"last chair nearest to a desk", "the chair farthest from a desk"},
        AskedRow{"where is the screen that is nearest to the door and on a desk",
                 "the monitor (on a desk) nearest to the door"},
        AskedRow{"box near a desk (with a screen) nearest to a door that is vertical",
                 "a box near the desk (with a monitor) nearest to a door (that is vertical)"},
        AskedRow{"which desks are near a window", "a desk near a window"},
        AskedRow{"how far is it from a desk to a door", "distance from a desk to a door"},
        AskedRow{"is there a chair near a desk?", "is there a chair near a desk"},
        AskedRow{"Are there chairs", "is there a chair"},
        AskedRow{"distance from the door to a desk", "distance from the door to a desk"},
        AskedRow{"distance from the nearest desk to a door",
                 "distance from the nearest desk to a door"},
        AskedRow{"distance between the door and a desk", "distance from the door to a desk"},
        AskedRow{"how far is the door from a desk", "distance from the door to a desk"}),
    [](const auto& row) { return "q" + std::to_string(row.index); });

std::string error_of(const std::string& asked) {
  try {
    parse_query(asked, test::office());
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::wrong_usage);
    return error.what();
  }
  return "";
}

TEST(QueryParser, ErrorsNameColumnCaretAndRemedy) {
  EXPECT_EQ(error_of("screen on a dsek"),
            "question:1:13: unknown class 'dsek'; did you mean 'desk'?\n"
            "  screen on a dsek\n"
            "              ^");
  const auto has = [](const std::string& asked, const std::string& part) {
    EXPECT_NE(error_of(asked).find(part), std::string::npos) << error_of(asked);
  };
  has("", "nothing is asked");
  has("desk taht is horizontal", "question:1:6: 'taht' begins nothing");
  has("desk taht is horizontal", "did you mean 'that'?");
  has("desk that is horizontl", "unknown clause 'horizontl'; did you mean 'horizontal'?");
  has("screen on", "the relation has no target");
  has("screen on a desk and", "nothing comes behind 'and'");
  has("second window", "the second in which order?");
  has("last window", "the last in which order?");
  has("desk with 3..1 screens", "question:1:14: the range is empty: 3 is above 1");
  has("desk with 99999999999999999999 screens", "a count is a whole number");
  has("box between a desk", "'between' names two things");
  has("distance from a desk", "the distance to what?");
  has("desk within 2 of a door", "a unit is missing");
  has("desk (near a door", "the bracket is not closed");
  has("nearest board from the top", "there is an order already");
  has("desk not big", "'not' goes on with a relation");
  has("desk with 1.5 screens", "a count is a whole number");
  has("how many", "a class was expected here");
}

TEST(QueryParser, CountsMeanAll) {
  EXPECT_FALSE(parse_query("count the chairs", test::office()).refs.front().definite);
  EXPECT_TRUE(parse_query("find the chair", test::office()).refs.front().definite);
}

TEST(QueryParser, DeepQuestionsEndInAnError) {
  std::string chain = "chair", that = "chair", brackets = "chair ";
  for (int i = 0; i < 20000; ++i) {
    chain += " on a desk";
    that += " that is near a desk";
    brackets += "(";
  }
  for (const auto& text : {chain, that, brackets})
    EXPECT_NE(error_of(text).find("more than 32 descriptions lie in each other"),
              std::string::npos);
}

TEST(QueryParser, SurvivesAnyText) {
  const std::string base =
      "how many 2nd boards from the top of the shelf (that is near a desk with no screen) and "
      "between a door and a window?";
  SequentialRandom random(3);
  int read = 0;
  for (int i = 0; i < 1500; ++i) {
    std::string text = base;
    for (std::uint32_t edits = 1 + random.below(5); edits > 0; --edits) {
      const auto at = random.below(static_cast<std::uint32_t>(text.size()));
      const std::uint32_t kind = random.below(3);
      if (kind == 0) text.erase(at, 1 + random.below(9));
      if (kind == 1) text.insert(at, 1, static_cast<char>(random.below(256)));
      if (kind == 2 && at < text.size()) text[at] = "() ,.0a9?"[random.below(9)];
      if (text.empty()) text = base;
    }
    try {
      const Query query = parse_query(text, test::office());
      EXPECT_EQ(query_text(parse_query(query_text(query), test::office())), query_text(query))
          << text;
      ++read;
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()).rfind("question:1:", 0), 0U) << error.what();
    }
  }
  EXPECT_GT(read, 0);
}

}  // namespace
}  // namespace scanchor
