#include "reasoning/sdl_clause.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace scanchor {
namespace {

struct Row {
  const char* text;
  const char* canonical;
};

class ClauseTable : public testing::TestWithParam<Row> {};

TEST_P(ClauseTable, ReadsAndPrints) {
  const std::string text = GetParam().text;
  const std::string file = "x.sdl";
  ClauseReader reader(text, file);
  reader.start(scan_line(text, 1));
  Clause clause;
  if (!reader.simple_clause(clause)) {
    clause.kind = ClauseKind::relation;
    EXPECT_TRUE(reader.at_relation() || reader.at_word("top"));
    reader.relation_clause(clause);
  }
  EXPECT_TRUE(reader.at_end()) << reader.rest();
  EXPECT_EQ(clause_text(clause), GetParam().canonical);
}

INSTANTIATE_TEST_SUITE_P(
    Rows, ClauseTable,
    testing::Values(
        Row{"area 90..170 cm2", "area 90..170 cm2"}, Row{"width under 0.5 m", "width under 0.5 m"},
        Row{"horizontal within 15 deg", "horizontal within 15 deg"},
        Row{"parallel and above the desk", "parallel to and above a desk"},
        Row{"within 40cm of an old box", "within 40 cm of an old box"},
        Row{"coplanar with a wall", "coplanar with a wall"},
        Row{"top 1..2 m above a floor", "top 1..2 m above a floor"},
        Row{"set back 3..35 cm behind the wall", "set back 3..35 cm behind a wall"},
        Row{"set back at least 3 cm behind a wall that is set back 1..2 m behind a door",
            "set back at least 3 cm behind a wall that is set back 1..2 m behind a "
            "door"},
        Row{"coplanar within 35 cm with and set back 3..35 cm behind a wall",
            "coplanar within 35 cm with and set back 3..35 cm behind a wall"},
        Row{"on a desk that is lowest", "on a desk that is lowest"},
        Row{"on a desk (that is lowest)", "on a desk that is lowest"},
        Row{"near a desk that is near a box that has area over 1 m2 and lowest",
            "near a desk that is near a box that has area over 1 m2 and is lowest"}));

TEST(SdlClause, DeepDescriptionsEndInAnError) {
  std::string text = "on a desk";
  for (int i = 0; i < 100000; ++i) text += " that is near a desk";
  const std::string file = "x.sdl";
  ClauseReader reader(text, file);
  reader.start(scan_line(text, 1));
  Clause clause;
  try {
    reader.relation_clause(clause);
    FAIL() << "read";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("more than 32 descriptions lie in each other"),
              std::string::npos);
  }
}

TEST(SdlClause, NameStopsBeforeWhatIsSaidOfIt) {
  const std::string text = "meeting table 2 that is lowest";
  const std::string file = "x.sdl";
  ClauseReader reader(text, file);
  reader.start(scan_line(text, 1));
  EXPECT_EQ(reader.name({}), "meeting table 2");
  EXPECT_TRUE(reader.at_words("that is"));
}

}  // namespace
}  // namespace scanchor
