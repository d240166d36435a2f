#include "core/text.hpp"

#include <gtest/gtest.h>

namespace scanchor {
namespace {

TEST(Text, EditDistanceCountsInsertDeleteReplaceSwap) {
  EXPECT_EQ(edit_distance("", ""), 0U);
  EXPECT_EQ(edit_distance("desk", ""), 4U);
  EXPECT_EQ(edit_distance("desk", "desks"), 1U);
  EXPECT_EQ(edit_distance("desk", "dusk"), 1U);
  EXPECT_EQ(edit_distance("desk", "dekc"), 2U);
  EXPECT_EQ(edit_distance("desk", "dsek"), 1U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
}

TEST(Text, EditDistanceIsSymmetric) {
  const std::vector<std::string> words = {"table", "bale", "tabel", "", "x", "cabinet"};
  for (const auto& a : words) {
    for (const auto& b : words)
      EXPECT_EQ(edit_distance(a, b), edit_distance(b, a)) << a << " " << b;
  }
}

TEST(Text, NearestWordOnlyWhereItIsASlip) {
  const std::vector<std::string> words = {"range_sigma", "lines", "beams_per_line"};
  EXPECT_EQ(nearest_word("range_sgima", words), "range_sigma");
  EXPECT_EQ(nearest_word("line", words), "lines");
  EXPECT_EQ(nearest_word("temperature", words), std::nullopt);
  EXPECT_EQ(nearest_word("x", {}), std::nullopt);
}

TEST(Text, SuggestionListsWhatIsKnownWhenNothingIsNear) {
  EXPECT_EQ(suggestion("lnes", {"lines", "beams"}), "did you mean 'lines'?");
  EXPECT_EQ(suggestion("temperature", {"lines", "beams"}), "known are: lines, beams");
}

}  // namespace
}  // namespace scanchor
