#include "reasoning/reach.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "reasoning/relation.hpp"
#include "reasoning/support_relations.hpp"
#include "tests/reasoning/support/built.hpp"

namespace scanchor {
namespace {

Clause clause_of(Relation relation, double high = INFINITY) {
  Clause clause;
  clause.kind = ClauseKind::relation;
  RelationTerm term;
  term.relation = relation;
  if (std::isfinite(high)) term.range.high = high;
  clause.relations = {term};
  return clause;
}

std::vector<Item> random_items(SequentialRandom& random) {
  std::vector<test::Plate> plates;
  for (int i = 0; i < 40; ++i) {
    test::Plate plate;
    plate.center = {random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(0, 2)};
    plate.normal =
        random.chance(0.5) ? Eigen::Vector3d::UnitZ().eval() : Eigen::Vector3d::UnitX().eval();
    plate.along = Eigen::Vector3d::UnitY();
    plate.length = random.uniform(0.2, 2.0);
    plate.width = random.uniform(0.1, 1.0);
    plate.hidden = random.chance(0.3) ? random.uniform(0.1, 0.8) : 0.0;
    plates.push_back(plate);
  }
  return make_items(test::make_surfaces(plates), Eigen::Matrix3d::Identity());
}

const std::vector<Clause>& clauses_that_need_nearness() {
  static const std::vector<Clause> clauses = {
      clause_of(Relation::near, 0.3), clause_of(Relation::near, 1.0), clause_of(Relation::touching),
      clause_of(Relation::above),     clause_of(Relation::below),     clause_of(Relation::on),
      clause_of(Relation::supports)};
  return clauses;
}

/// Calls visit(clause, a, b) for all pairs of some random scenes.
template <class Visit>
void each_pair(std::uint64_t seed, const Visit& visit) {
  SequentialRandom random(seed);
  for (int round = 0; round < 8; ++round) {
    const auto items = random_items(random);
    for (const auto& clause : clauses_that_need_nearness()) {
      for (const auto& a : items) {
        for (const auto& b : items) visit(clause, a, b);
      }
    }
  }
}

TEST(Reach, WhatIsOutOfReachHoldsNowhere) {
  std::size_t out = 0;
  each_pair(5, [&](const Clause& clause, const Item& a, const Item& b) {
    if (&a == &b || !out_of_reach(clause, a, b)) return;
    ++out;
    EXPECT_LT(relate(clause.relations[0], a, b, {}).likelihood, 1e-5) << "the gate is at 0.05";
  });
  EXPECT_GT(out, 10000U);
}

TEST(Reach, WhatLiesFartherInPlanIsOutOfReach) {
  std::size_t farther = 0;
  each_pair(6, [&](const Clause& clause, const Item& a, const Item& b) {
    if (reaches_far(b) || plan_gap(a, b) <= reach_of(clause, a)) return;
    ++farther;
    EXPECT_TRUE(out_of_reach(clause, a, b));
  });
  EXPECT_GT(farther, 10000U);
  SequentialRandom random(6);
  EXPECT_TRUE(std::isinf(reach_of(clause_of(Relation::parallel), random_items(random)[0])));
}

TEST(Reach, NoTargetIsLikelierThanTheBoxesSay) {
  int bounded = 0;
  for (const std::uint64_t seed : {21, 22, 23}) {
    each_pair(seed, [&](const Clause& clause, const Item& a, const Item& b) {
      const double most = at_most(clause, a, b, relation_model());
      EXPECT_LE(relate(clause.relations[0], a, b, {}).likelihood, most);
      if (most < 0.9) ++bounded;
    });
  }
  EXPECT_GT(bounded, 100);
}

}  // namespace
}  // namespace scanchor
