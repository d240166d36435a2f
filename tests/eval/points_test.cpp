#include "eval/points.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace scanchor {
namespace {

ClassRules rules_of(std::size_t classes) {
  ClassRules rules;
  for (std::size_t c = 0; c < classes; ++c) {
    rules.names.push_back("class " + std::to_string(c));
    rules.scored.push_back(c > 0 ? 1 : 0);
    rules.thing.push_back(1);
    rules.counted_as.push_back(static_cast<std::int32_t>(c));
  }
  return rules;
}

// The labels of semantic-kitti-api's example: IoU 2/3, 2/3, 6/7 and 0, mean 0.5476190476190476.
TEST(Points, GiveTheMeanIouOfSemanticKittisOwnExample) {
  std::vector<std::int32_t> truth, said;
  const auto add = [&](int n, int t, int s) {
    truth.insert(truth.end(), static_cast<std::size_t>(n), t);
    said.insert(said.end(), static_cast<std::size_t>(n), s);
  };
  add(50, 0, 0);
  add(40, 1, 1);
  add(10, 1, 2);
  add(40, 2, 2);
  add(10, 2, 1);
  add(50, 4, 3);
  add(300, 3, 3);
  const ClassRules rules = rules_of(5);
  const PointScore score = score_points(truth, said, rules);
  EXPECT_NEAR(mean_iou(score, rules, find_protocol("semantickitti")), 0.5476190476190476, 1e-9);
  EXPECT_NEAR(class_points(score, 3).iou(), 0.8571428571428571, 1e-9);
  EXPECT_EQ(score.without_truth, 50);
  EXPECT_NEAR(point_accuracy(score), 380.0 / 450.0, 1e-12);
}

TEST(Points, SaidOnPointsWithoutTruthCountsOnNeitherSide) {
  const ClassRules rules = rules_of(3);
  const std::vector<std::int32_t> truth = {0, -1, 7, 1}, said = {1, 1, 1, 1};
  const PointScore score = score_points(truth, said, rules);
  EXPECT_EQ(class_points(score, 1).wrong, 0);
  EXPECT_EQ(score.without_truth, 3);
}

TEST(Points, UnknownAndUnscoredPredictionsAreMisses) {
  const ClassRules rules = rules_of(3);
  const std::vector<std::int32_t> truth = {1, 1, 1, 1}, said = {0, -1, 99, 1};
  EXPECT_NEAR(class_points(score_points(truth, said, rules), 1).iou(), 0.25, 1e-12);
}

TEST(Points, MergedClassesCountAsOne) {
  ClassRules rules = rules_of(3);
  rules.counted_as[2] = 1;
  rules.scored[2] = 0;
  const std::vector<std::int32_t> truth = {2, 1}, said = {1, 2};
  EXPECT_EQ(class_points(score_points(truth, said, rules), 1).iou(), 1.0);
}

TEST(Points, AbsentClassesFollowTheProtocol) {
  const ClassRules rules = rules_of(5);
  const std::vector<std::int32_t> truth = {1, 2}, said = {1, 1};
  const PointScore score = score_points(truth, said, rules);
  EXPECT_NEAR(mean_iou(score, rules, find_protocol("coco")), 0.25, 1e-12);
  EXPECT_NEAR(mean_iou(score, rules, find_protocol("semantickitti")), 0.125, 1e-12);
}

TEST(Points, AgreeWithCountingPointByPoint) {
  const ClassRules rules = rules_of(6);
  SequentialRandom random(7);
  std::vector<std::int32_t> truth, said;
  for (int i = 0; i < 5000; ++i) {
    truth.push_back(static_cast<std::int32_t>(random.below(6)));
    said.push_back(random.chance(0.6) ? truth.back() : static_cast<std::int32_t>(random.below(6)));
  }
  const PointScore score = score_points(truth, said, rules);
  double mean = 0;
  for (std::int32_t c = 1; c < 6; ++c) {
    double both = 0, either = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      if (truth[i] == 0) continue;
      both += truth[i] == c && said[i] == c;
      either += truth[i] == c || said[i] == c;
    }
    EXPECT_NEAR(class_points(score, static_cast<std::size_t>(c)).iou(), both / either, 1e-12);
    mean += both / either / 5;
  }
  EXPECT_NEAR(mean_iou(score, rules, Protocol{}), mean, 1e-12);
}

TEST(Points, PoolingEqualsScoringTogether) {
  const ClassRules rules = rules_of(4);
  const std::vector<std::int32_t> t1 = {1, 2, 3}, s1 = {1, 1, 0}, t2 = {3, 3, 0}, s2 = {3, 2, 1};
  PointScore pooled = score_points(t1, s1, rules);
  pooled.add(score_points(t2, s2, rules));
  const std::vector<std::int32_t> t = {1, 2, 3, 3, 3, 0}, s = {1, 1, 0, 3, 2, 1};
  EXPECT_EQ(pooled, score_points(t, s, rules));
}

}  // namespace
}  // namespace scanchor
