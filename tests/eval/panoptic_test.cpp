#include "eval/panoptic.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "core/random.hpp"

namespace scanchor {
namespace {

struct Rows {
  std::vector<std::int32_t> truth_class, truth_instance, said_class, said_instance;
  void add(int count, int tc, int ti, int sc, int si) {
    for (int i = 0; i < count; ++i) {
      truth_class.push_back(tc);
      truth_instance.push_back(ti);
      said_class.push_back(sc);
      said_instance.push_back(si);
    }
  }
};

ClassRules rules_of(int classes, std::set<int> things) {
  ClassRules rules;
  for (int c = 0; c < classes; ++c) {
    rules.names.push_back("class " + std::to_string(c));
    rules.scored.push_back(c > 0 ? 1 : 0);
    rules.thing.push_back(things.count(c) ? 1 : 0);
    rules.counted_as.push_back(c);
  }
  return rules;
}

Segments segments_of(const Rows& rows, const ClassRules& rules, const Protocol& protocol) {
  return make_segments({rows.truth_class, rows.truth_instance},
                       {rows.said_class, rows.said_instance}, {}, {}, rules, protocol);
}

// The example at the end of semantic-kitti-api's auxiliary/eval_np.py, itself after Kirillov et
// al.: one segment each of grass (1) and sky (2), a dog (4) taken for a person (3), and three
// persons of which two are found.
TEST(Panoptic, GivesTheNumbersOfSemanticKittisOwnExample) {
  Rows rows;
  rows.add(50, 0, 0, 0, 0);
  rows.add(40, 1, 0, 1, 0);
  rows.add(10, 1, 0, 2, 0);
  rows.add(40, 2, 0, 2, 0);
  rows.add(10, 2, 0, 1, 0);
  rows.add(50, 4, 22, 3, 35);
  rows.add(150, 3, 33, 3, 8);
  rows.add(50, 3, 42, 3, 8);
  rows.add(100, 3, 11, 3, 95);
  const ClassRules rules = rules_of(5, {3, 4});
  Protocol protocol = find_protocol("semantickitti");
  protocol.min_points = 1;
  const PanopticScore score = score_panoptic(segments_of(rows, rules, protocol), rules, protocol);
  const PanopticQuality q = panoptic_quality(score, ClassKind::all, rules, protocol);
  EXPECT_NEAR(q.pq, 0.47916666666666663, 1e-9);
  EXPECT_NEAR(q.sq, 0.5520833333333333, 1e-9);
  EXPECT_NEAR(q.rq, 0.6666666666666666, 1e-9);
  const double person[] = {0.5833333333333333, 0.875, 0.6666666666666666};
  EXPECT_NEAR(panoptic_quality(score.classes[3]).pq, person[0], 1e-9);
  EXPECT_NEAR(panoptic_quality(score.classes[3]).sq, person[1], 1e-9);
  EXPECT_NEAR(panoptic_quality(score.classes[3]).rq, person[2], 1e-9);
  EXPECT_NEAR(panoptic_quality(score.classes[1]).pq, 2.0 / 3.0, 1e-9);
  EXPECT_EQ(panoptic_quality(score.classes[4]).pq, 0.0);
}

TEST(Panoptic, AbsentClassCountsZeroForSemanticKittiAndNotForCoco) {
  Rows rows;
  rows.add(100, 3, 1, 3, 1);
  const ClassRules rules = rules_of(5, {3, 4});
  const Protocol kitti = find_protocol("semantickitti");
  const Protocol coco = find_protocol("coco");
  EXPECT_NEAR(panoptic_quality(score_panoptic(segments_of(rows, rules, kitti), rules, kitti),
                               ClassKind::all, rules, kitti)
                  .pq,
              0.25, 1e-9);
  const auto q = panoptic_quality(score_panoptic(segments_of(rows, rules, coco), rules, coco),
                                  ClassKind::all, rules, coco);
  EXPECT_NEAR(q.pq, 1.0, 1e-9);
  EXPECT_EQ(q.classes, 1);
}

TEST(Panoptic, ClaimMostlyOnVoidIsNeitherRightNorWrongForCoco) {
  Rows rows;
  rows.add(60, 0, 0, 3, 1);
  rows.add(40, 3, 9, 3, 1);
  const ClassRules rules = rules_of(4, {3});
  const Protocol coco = find_protocol("coco");
  auto score = score_panoptic(segments_of(rows, rules, coco), rules, coco);
  EXPECT_EQ(score.classes[3].matched, 1);  // the 60 points without truth are no part of the union
  EXPECT_NEAR(score.classes[3].iou.value(), 1.0, 1e-9);
  rows.truth_class.assign(100, 0);
  score = score_panoptic(segments_of(rows, rules, coco), rules, coco);
  EXPECT_EQ(score.classes[3].extra, 0);
}

TEST(Panoptic, SmallTruthIsIgnoredOnBothSides) {
  Rows rows;
  rows.add(20, 3, 1, 0, -1);  // small and missed
  rows.add(20, 3, 2, 3, 2);   // small and found
  rows.add(200, 3, 3, 3, 3);
  const ClassRules rules = rules_of(4, {3});
  Protocol protocol;
  const auto score = score_panoptic(segments_of(rows, rules, protocol), rules, protocol);
  EXPECT_EQ(score.classes[3].matched, 1);
  EXPECT_EQ(score.classes[3].missed, 0);
  EXPECT_EQ(score.classes[3].extra, 0);
  protocol.small = "unpunished";  // SemanticKITTI: a small match still counts
  EXPECT_EQ(score_panoptic(segments_of(rows, rules, protocol), rules, protocol).classes[3].matched,
            2);
}

// A second implementation that shares nothing with the first: sets of points, straight from the
// definition.
PanopticQuality by_sets(const Rows& rows, const ClassRules& rules, bool kitti, int min_points) {
  double pq = 0, sq = 0, rq = 0;
  int classes = 0;
  for (int c = 1; c < static_cast<int>(rules.size()); ++c) {
    std::map<int, std::set<int>> truths, claims;
    std::set<int> void_points;
    for (int i = 0; i < static_cast<int>(rows.truth_class.size()); ++i) {
      const auto s = static_cast<std::size_t>(i);
      if (rows.truth_class[s] == 0) {
        void_points.insert(i);
        if (kitti) continue;
      }
      const bool thing = rules.thing[static_cast<std::size_t>(c)] != 0;
      if (rows.truth_class[s] == c) truths[thing ? rows.truth_instance[s] : 0].insert(i);
      if (rows.said_class[s] == c) claims[thing || kitti ? rows.said_instance[s] : 0].insert(i);
    }
    double tp = 0, fp = 0, fn = 0, iou_sum = 0;
    std::set<int> matched_claims;
    for (const auto& [t, points] : truths) {
      bool found = false;
      for (const auto& [p, said] : claims) {
        double both = 0, only = 0;
        for (const int i : said) {
          if (points.count(i))
            both += 1;
          else if (kitti || !void_points.count(i))
            only += 1;
        }
        const double iou = both / (static_cast<double>(points.size()) + only);
        if (iou <= 0.5) continue;
        tp += 1;
        iou_sum += iou;
        found = true;
        matched_claims.insert(p);
      }
      if (!found && static_cast<int>(points.size()) >= min_points) fn += 1;
    }
    for (const auto& [p, said] : claims) {
      double nothing = 0;
      for (const int i : said) nothing += void_points.count(i) ? 1 : 0;
      const bool out = kitti ? static_cast<int>(said.size()) < min_points
                             : nothing / static_cast<double>(said.size()) > 0.5;
      if (!matched_claims.count(p) && !out) fp += 1;
    }
    if (tp + fp + fn == 0) {
      classes += kitti ? 1 : 0;
      continue;
    }
    ++classes;
    pq += iou_sum / (tp + 0.5 * fp + 0.5 * fn);
    sq += tp > 0 ? iou_sum / tp : 0;
    rq += tp / (tp + 0.5 * fp + 0.5 * fn);
  }
  return {pq / classes, sq / classes, rq / classes, classes};
}

TEST(Panoptic, AgreesWithASecondImplementationOnRandomLabels) {
  const ClassRules rules = rules_of(6, {3, 4, 5});
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SequentialRandom random(seed);
    Rows rows;
    const int runs = 40;
    for (int run = 0; run < runs; ++run) {
      const int truth = static_cast<int>(random.below(6));
      const bool right = random.chance(0.7);
      const int said = right ? truth : static_cast<int>(random.below(6));
      const int instance = static_cast<int>(random.below(4));
      rows.add(1 + static_cast<int>(random.below(12)), truth, truth >= 3 ? instance : 0, said,
               right ? instance : static_cast<int>(random.below(4)));
    }
    for (const bool kitti : {false, true}) {
      Protocol protocol = find_protocol(kitti ? "semantickitti" : "coco");
      protocol.min_points = kitti ? 10 : 0;
      const auto q =
          panoptic_quality(score_panoptic(segments_of(rows, rules, protocol), rules, protocol),
                           ClassKind::all, rules, protocol);
      const auto expected = by_sets(rows, rules, kitti, protocol.min_points);
      EXPECT_NEAR(q.pq, expected.pq, 1e-9) << "seed " << seed << (kitti ? " kitti" : " coco");
      EXPECT_NEAR(q.sq, expected.sq, 1e-9);
      EXPECT_NEAR(q.rq, expected.rq, 1e-9);
      EXPECT_EQ(q.classes, expected.classes);
    }
  }
}

TEST(Panoptic, PoolingIsExactInAnyOrder) {
  const ClassRules rules = rules_of(4, {3});
  const Protocol protocol = find_protocol("coco");
  std::vector<PanopticScore> scores;
  for (int n = 51; n < 90; ++n) {
    Rows rows;
    rows.add(n, 3, 1, 3, 1);
    rows.add(100 - n, 3, 1, 0, -1);
    scores.push_back(score_panoptic(segments_of(rows, rules, protocol), rules, protocol));
  }
  PanopticScore forwards, backwards;
  for (const auto& score : scores) forwards.add(score);
  for (auto it = scores.rbegin(); it != scores.rend(); ++it) backwards.add(*it);
  EXPECT_EQ(forwards, backwards);
  EXPECT_NEAR(forwards.classes[3].iou.value(), (51 + 89) * 39 / 200.0, 1e-9);
}

}  // namespace
}  // namespace scanchor
