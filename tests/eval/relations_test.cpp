#include "eval/relations.hpp"

#include <gtest/gtest.h>

namespace scanchor {
namespace {

NamedRelation fact(const char* name, int a, int b, bool holds = true, bool borderline = false) {
  return {name, a, b, holds, borderline, 1.0};
}
NamedRelation claim(const char* name, int a, int b, double p) {
  return {name, a, b, true, false, p};
}

TEST(Relations, ByHand) {
  const auto score = score_relations({fact("on", 1, 2), fact("on", 3, 2), fact("on", 5, 2, false)},
                                     {claim("on", 1, 2, 0.9), claim("on", 5, 2, 0.8),
                                      claim("on", 7, 8, 0.7), claim("on", 3, 2, 0.4)});
  const auto& on = score.clear.at("on");
  EXPECT_EQ(on.right, 1);
  EXPECT_EQ(on.wrong, 2);
  EXPECT_EQ(on.missed, 1);
  EXPECT_NEAR(on.precision(), 1.0 / 3.0, 1e-12);
  EXPECT_NEAR(on.recall(), 0.5, 1e-12);
  EXPECT_NEAR(on.brier.value(), 0.01 + 0.64 + 0.49 + 0.36, 1e-9);
}

TEST(Relations, BorderlinePairsAreApart) {
  const auto score = score_relations({fact("near", 1, 2, true, true), fact("near", 1, 3)},
                                     {claim("near", 1, 3, 1.0)});
  EXPECT_EQ(score.clear.at("near").recall(), 1.0);
  EXPECT_EQ(score.borderline.at("near").missed, 1);
}

TEST(Relations, DuplicatesCountOnceAndUnknownRelationsNotAtAll) {
  const auto score =
      score_relations({fact("on", 1, 2)},
                      {claim("on", 1, 2, 0.6), claim("on", 1, 2, 0.9), claim("hugs", 1, 2, 1.0)});
  EXPECT_EQ(score.clear.at("on").right, 1);
  EXPECT_EQ(score.clear.at("on").wrong, 0);
  EXPECT_EQ(score.clear.count("hugs"), 0U);
}

TEST(Relations, PoolingAddsByName) {
  auto a = score_relations({fact("on", 1, 2)}, {});
  a.add(score_relations({fact("on", 1, 2), fact("near", 1, 2)}, {claim("on", 1, 2, 1.0)}));
  EXPECT_EQ(a.clear.at("on").missed, 1);
  EXPECT_EQ(a.clear.at("on").right, 1);
  EXPECT_EQ(a.clear.at("near").missed, 1);
}

}  // namespace
}  // namespace scanchor
