#include "eval/overlap.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "core/random.hpp"

namespace scanchor {
namespace {

TEST(Overlap, CountsEveryPairInOrder) {
  const std::vector<std::int32_t> a = {2, -1, 2, 0, -7}, b = {5, 5, 5, -1, 3};
  const auto table = overlap_table(a, b);
  ASSERT_EQ(table.size(), 4U);
  EXPECT_EQ(table[0].truth, -1);
  EXPECT_EQ(table[0].predicted, 3);
  EXPECT_EQ(table[1].predicted, 5);
  EXPECT_EQ(table[2].truth, 0);
  EXPECT_EQ(table[2].predicted, -1);
  EXPECT_EQ(table[3].points, 2);
}

TEST(Overlap, EmptyIsEmpty) { EXPECT_TRUE(overlap_table({}, {}).empty()); }

TEST(Overlap, AgreesWithAMapAndDoesNotDependOnTheOrder) {
  SequentialRandom random(3);
  std::vector<std::int32_t> a, b;
  std::map<std::pair<std::int32_t, std::int32_t>, std::int64_t> expected;
  for (int i = 0; i < 3000; ++i) {
    a.push_back(static_cast<std::int32_t>(random.below(30)) - 1);
    b.push_back(static_cast<std::int32_t>(random.below(2000000)) * 1000 - 1);
    ++expected[{a.back(), b.back()}];
  }
  const auto table = overlap_table(a, b);
  ASSERT_EQ(table.size(), expected.size());
  std::size_t i = 0;
  for (const auto& [pair, count] : expected) {
    EXPECT_EQ(table[i].truth, pair.first);
    EXPECT_EQ(table[i].predicted, pair.second);
    EXPECT_EQ(table[i++].points, count);
  }
  std::reverse(a.begin(), a.end());
  std::reverse(b.begin(), b.end());
  EXPECT_EQ(overlap_table(a, b).size(), table.size());
}

}  // namespace
}  // namespace scanchor
