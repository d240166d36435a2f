#include "reasoning/limits.hpp"

#include <gtest/gtest.h>

#include "reasoning/relation.hpp"
#include "tests/reasoning/support/built.hpp"

namespace scanchor {
namespace {

TEST(Limits, AreWhereAClauseTurns) {
  // Just inside a limit a measured clause is likelier than not, just outside it is not.
  Clause clause;
  clause.range.low = 1.0;
  clause.range.high = 2.0;
  clause.feature = Feature::extension;
  for (const double limit : {limits_of(clause).low, limits_of(clause).high}) {
    for (const double off : {-0.02, 0.02}) {
      test::Plate plate;
      plate.length = limit + off;
      const auto item = make_items(test::make_surfaces({plate}), Eigen::Matrix3d::Identity())[0];
      const bool inside = plate.length > 1.0 && plate.length < 2.0;
      EXPECT_EQ(feature(clause.feature, clause.range, item).likelihood > 0.5, inside)
          << plate.length;
    }
  }
}

TEST(Limits, OfRelationsTurnToo) {
  RelationTerm near{Relation::near, {}};
  near.range.high = 0.8;
  EXPECT_DOUBLE_EQ(limits_of(near).high, 0.8);
  EXPECT_DOUBLE_EQ(limits_of(RelationTerm{Relation::near, {}}).high, 0.5);
  const auto value = [&](double gap) {
    const auto items =
        make_items(test::make_surfaces({{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 1.0, 1.0},
                                        {{1.0 + gap, 0, 0}, {0, 0, 1}, {1, 0, 0}, 1.0, 1.0}}),
                   Eigen::Matrix3d::Identity());
    return relate(near, items[0], items[1], {}).likelihood;
  };
  EXPECT_GT(value(0.78), 0.5);
  EXPECT_LT(value(0.82), 0.5);
  Clause negation;
  negation.kind = ClauseKind::negation;
  EXPECT_FALSE(std::isfinite(limits_of(negation).low));
}

}  // namespace
}  // namespace scanchor
