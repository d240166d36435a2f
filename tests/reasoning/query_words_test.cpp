#include <gtest/gtest.h>

#include "reasoning/query.hpp"

namespace scanchor {
namespace {

TEST(QueryWords, Ordinals) {
  EXPECT_EQ(ordinal_value("first"), 1);
  EXPECT_EQ(ordinal_value("tenth"), 10);
  EXPECT_EQ(ordinal_value("12th"), 12);
  EXPECT_EQ(ordinal_value("2nd"), 2);
  for (const auto* word : {"", "th", "2", "two", "0th", "-1st", "2ndd"})
    EXPECT_EQ(ordinal_value(word), 0) << word;
  EXPECT_EQ(ordinal_word(11), "11th");
  EXPECT_EQ(ordinal_word(21), "21st");
  EXPECT_EQ(ordinal_word(102), "102nd");
  for (int i = 1; i < 130; ++i) EXPECT_EQ(ordinal_value(ordinal_word(i)), i);
}

TEST(QueryWords, OrdersHaveOtherWords) {
  EXPECT_EQ(rank_of("narrowest"), RankKey::narrowest);
  EXPECT_EQ(rank_of("biggest"), RankKey::largest);
  EXPECT_EQ(rank_of("bottom"), RankKey::lowest);
  EXPECT_FALSE(rank_of("desk"));
}

TEST(QueryWords, EveryOrderHasItsOpposite) {
  for (const auto& word : rank_vocabulary()) {
    for (const auto& other : rank_vocabulary()) {
      if (other.key == word.opposite) {
        EXPECT_EQ(other.opposite, word.key) << word.word;
      }
    }
    QueryRef ref;
    ref.name = "desk";
    ref.rank = word.key;
    EXPECT_EQ(ref_text(ref), "the " + std::string(word.word) + " desk");
    ref.place = 3;
    EXPECT_EQ(rank_text(ref), "third " + std::string(word.word));
  }
}

}  // namespace
}  // namespace scanchor
