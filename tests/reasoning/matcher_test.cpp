#include "reasoning/matcher.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <tuple>

#include "core/random.hpp"
#include "reasoning/background.hpp"
#include "tests/reasoning/support/built.hpp"

namespace scanchor {
namespace {

TEST(Matcher, LikelihoodRatioByHand) {
  EXPECT_NEAR(log_likelihood_ratio(1.0, 0.95, 0.2), std::log(0.95 / 0.2), 1e-12);
  EXPECT_NEAR(log_likelihood_ratio(0.0, 0.95, 0.2), std::log(0.05 / 0.8), 1e-12);
  EXPECT_NEAR(log_likelihood_ratio(0.5, 0.9, 0.1), 0.0, 1e-12);
}

/// All pairs, no index, no pruning, no early end: what the matcher has to equal.
class BruteForce {
 public:
  BruteForce(const Ontology& ontology, std::vector<Item> items, const Surrounding& around)
      : ontology_(ontology),
        items_(std::move(items)),
        around_(around),
        belief_(ontology.classes.size()),
        score_(ontology.classes.size()) {
    for (const int c : evaluation_order(ontology)) {
      belief_[c].assign(items_.size(), 0.0);
      score_[c].assign(items_.size(), -INFINITY);
      for (std::size_t i = 0; i < items_.size(); ++i) {
        double score = std::log(prior_of(ontology, c));
        bool possible = true;
        for (const auto& clause : all_clauses(ontology, c)) {
          const double v = value(clause, static_cast<std::int32_t>(i));
          possible = possible && v >= required_gate;
          score +=
              clause.weight * log_likelihood_ratio(v, hit_rate_of(clause), background_of(clause));
        }
        if (!possible) continue;
        score_[c][i] = score;
        belief_[c][i] = 1.0 / (1.0 + std::exp(std::log(unknown_prior_of(ontology)) - score));
      }
    }
  }
  double score(int c, std::size_t i) const { return score_[c][i]; }
  double belief(int c, std::size_t i) const { return belief_[c][i]; }

 private:
  double value(const Clause& clause, std::int32_t i) const {
    const Item& a = items_[i];
    switch (clause.kind) {
      case ClauseKind::feature:
        return feature(clause.feature, clause.range, a).likelihood;
      case ClauseKind::horizontal:
        return horizontal(a, around_, clause.range.has_high() ? clause.range.high : 5.0).likelihood;
      case ClauseKind::vertical:
        return vertical(a, around_, clause.range.has_high() ? clause.range.high : 5.0).likelihood;
      case ClauseKind::rectangular:
        return rectangular(a).likelihood;
      default:
        break;
    }
    double best = 0.0;
    double none = 1.0;
    const int target = ontology_.find(clause.target);
    const auto said_of = [&](std::size_t t) {
      double product = 1.0;
      for (const auto& nested : clause.target_clauses) {
        // Every clause stands at a place of its own.
        const auto key = std::make_tuple(nested.place.line, nested.place.column, t);
        const auto known = said_.find(key);
        product *= known != said_.end() ? known->second
                                        : said_[key] = value(nested, static_cast<std::int32_t>(t));
      }
      return product;
    };
    for (std::size_t t = 0; t < items_.size(); ++t) {
      if (static_cast<std::int32_t>(t) == i) continue;
      double product = belief_[target][t];
      for (const auto& term : clause.relations)
        product *= relate(term, a, items_[t], around_).likelihood;
      product *= said_of(t);
      best = std::max(best, product);
      none *= 1.0 - product;
    }
    const double seen = 1.0 - a.area.hidden;
    return clause.kind == ClauseKind::negation ? seen * none + 0.5 * (1.0 - seen) : best;
  }
  const Ontology& ontology_;
  std::vector<Item> items_;
  Surrounding around_;
  std::vector<std::vector<double>> belief_, score_;
  mutable std::map<std::tuple<int, int, std::size_t>, double> said_;
};

const char* const matched_classes = R"(
class top:
    horizontal
    area 0.2..3 m2
class side:
    vertical within 15 deg
    extension 0.2..1.2 m
    rectangular
class stand:
    vertical
    below and near a top
class thing:
    orthogonal to and above a top
    width at most 0.8 m
class lid:
    parallel to a top
    above a side
    not on a thing
class other:
    coplanar within 20 cm with a lid
    elevation 0.1..1 m above a top
class shade:
    below a top that is above a side and rectangular
    not near a side that has extension at least 0.6 m and is near a top (that has width over 0.4 m) and is vertical
class neighbour:
    within 0.6 m of a side
    touching a top
    weight 0.5 area at most 1 m2
)";

TEST(Matcher, EqualsBruteForceOnRandomScenes) {
  const Ontology ontology = parse_ontology(matched_classes, "x.sdl");
  SequentialRandom random(17);
  std::size_t compared = 0;
  for (int scene = 0; scene < 1000; ++scene) {
    std::vector<test::Plate> plates;
    // Every tenth scene is large; the rest are small so that a thousand of them fit into seconds.
    const int count = scene % 100 == 0 ? 200 : 3 + static_cast<int>(random.below(14));
    for (int i = 0; i < count; ++i) {
      test::Plate plate;
      const double side = count > 100 ? 8.0 : 2.0;
      plate.center = {random.uniform(-side, side), random.uniform(-side, side),
                      random.uniform(0, 2)};
      const auto way = random.below(5);
      plate.normal = way < 2    ? Eigen::Vector3d::UnitZ()
                     : way == 2 ? Eigen::Vector3d::UnitX()
                                : Eigen::Vector3d::UnitY();
      plate.normal += 0.03 * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
      plate.along = {random.normal(), random.normal(), random.normal()};
      plate.length = random.uniform(0.2, 2.2);
      plate.width = random.uniform(0.3, 1.0) * plate.length;
      plate.hidden = random.chance(0.3) ? random.uniform(0.1, 0.8) : 0.0;
      plate.fill = random.uniform(0.6, 1.0);
      plates.push_back(plate);
      // Here and there the same surface twice or more.
      if (random.chance(0.15)) plates.push_back(plates[random.below(i + 1)]);
    }
    const auto items = make_items(test::make_surfaces(plates), Eigen::Matrix3d::Identity());
    Surrounding around;
    around.up_sigma = 0.01;
    Matcher matcher(ontology, items, around);
    matcher.run();
    const BruteForce brute(ontology, items, around);
    for (std::size_t c = 0; c < ontology.classes.size(); ++c) {
      std::vector<double> score(items.size(), -INFINITY);
      for (const auto& candidate : matcher.candidates(static_cast<int>(c)))
        score[candidate.item] = candidate.score;
      for (std::size_t i = 0; i < items.size(); ++i) {
        const bool both_out =
            std::isinf(score[i]) && std::isinf(brute.score(static_cast<int>(c), i));
        if (!both_out) {
          ASSERT_NEAR(score[i], brute.score(static_cast<int>(c), i), 1e-9)
              << ontology.classes[c].name() << " " << i;
          ++compared;
        }
        ASSERT_NEAR(matcher.belief(static_cast<int>(c), static_cast<std::int32_t>(i)),
                    brute.belief(static_cast<int>(c), i), 1e-9);
      }
    }
  }
  EXPECT_GT(compared, 5000U);
}

TEST(Matcher, WhatIsSaidOfTheTargetDecidesBetweenTargets) {
  // Two tables, one of them near a window. A box stands on the other one: moved over, it is found.
  const Ontology ontology = parse_ontology(
      "axiom window:\n    vertical\nclass table:\n    horizontal\n    extension at least 1 m\n"
      "class box:\n    extension at most 0.5 m\n    on a table that is near a window\n",
      "x.sdl");
  std::vector<test::Plate> plates = {{{0, 0, 0.7}, {0, 0, 1}, {1, 0, 0}, 1.4, 0.7},
                                     {{5, 0, 0.7}, {0, 0, 1}, {1, 0, 0}, 1.4, 0.7},
                                     {{5, 0.5, 1.2}, {0, 1, 0}, {1, 0, 0}, 1.2, 1.0},
                                     {{0, 0, 0.72}, {0, 0, 1}, {1, 0, 0}, 0.4, 0.3}};
  const auto belief_of_box = [&] {
    Matcher matcher(ontology, make_items(test::make_surfaces(plates), Eigen::Matrix3d::Identity()),
                    {});
    matcher.run();
    return matcher.belief(2, 3);
  };
  EXPECT_EQ(belief_of_box(), 0.0);
  plates[3].center.x() = 5.0;
  EXPECT_GT(belief_of_box(), 0.2);
  plates[2].center.x() = 0.0;
  plates[2].center.y() = 0.5;
  EXPECT_EQ(belief_of_box(), 0.0) << "the window moved to the other table";
}

TEST(Matcher, ContextDoesNotSupportItself) {
  // Two kinds of boxes that vouch for each other by "usually": without anything else they stay
  // where they were.
  const Ontology ontology = parse_ontology(
      "class a:\n    area 0.1..1 m2\n    usually near a b\nclass b:\n    area 0.1..1 m2\n    "
      "usually near a a\n",
      "x.sdl");
  std::vector<test::Plate> plates(2);
  plates[1].center.x() = 1.2;
  const auto items = make_items(test::make_surfaces(plates), Eigen::Matrix3d::Identity());
  Matcher matcher(ontology, items, {});
  matcher.run();
  EXPECT_NEAR(matcher.candidates(0)[0].belief, matcher.candidates(1)[0].belief, 1e-12);
  EXPECT_LT(matcher.candidates(0)[0].belief, 0.75) << "beliefs upward leave context out";
  EXPECT_NEAR(matcher.candidates(0)[0].score, matcher.candidates(1)[1].score, 1e-9);
}

}  // namespace
}  // namespace scanchor
