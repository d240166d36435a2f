#include "eval/labels.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"
#include "tests/eval/support/small_scan.hpp"

namespace scanchor {
namespace {

LabelledThing thing(std::int32_t truth, std::int32_t label, double p) {
  return {truth, label, false, p, {}};
}

TEST(Labels, ByHand) {
  Protocol protocol;
  protocol.calibration_bins = 2;
  // Bin (0, 0.5]: 0.4 wrong. Bin (0.5, 1]: 0.8 right, 0.6 wrong.
  const auto score =
      score_labels({thing(8, 8, 0.8), thing(8, 12, 0.6), thing(8, 12, 0.4)}, protocol);
  EXPECT_NEAR(expected_calibration_error(score), (std::abs(1 - 1.4) + std::abs(0 - 0.4)) / 3, 1e-9);
  EXPECT_NEAR(brier_score(score), (0.04 + (0.36 + 1) + (0.16 + 1)) / 3, 1e-9);
}

TEST(Labels, BrierTakesTheWholeDistribution) {
  LabelledThing t = thing(8, 8, 0.7);
  t.distribution = {{8, 0.7}, {12, 0.2}, {0, 0.1}};
  EXPECT_NEAR(brier_score(score_labels({t}, Protocol{})), 0.09 + 0.04 + 0.01, 1e-9);
}

TEST(Labels, HonestProbabilitiesAreCalibrated) {
  SequentialRandom random(4);
  std::vector<LabelledThing> honest, boastful;
  for (int i = 0; i < 20000; ++i) {
    const double p = random.uniform();
    const bool right = random.chance(p);
    honest.push_back(thing(right ? 8 : 12, 8, p));
    boastful.push_back(thing(right ? 8 : 12, 8, std::sqrt(p)));
  }
  EXPECT_LT(expected_calibration_error(score_labels(honest, Protocol{})), 0.015);
  EXPECT_NEAR(expected_calibration_error(score_labels(boastful, Protocol{})), 1.0 / 6.0,
              0.02);  // integral of sqrt(p) - p
}

TEST(Labels, UnknownAndAmbiguousAreCountedApart) {
  LabelledThing unsure = thing(8, 8, 0.5);
  unsure.ambiguous = true;
  const auto score =
      score_labels({thing(0, 0, 0.9), thing(8, 0, 0.6), unsure, thing(8, 8, 1.0)}, Protocol{});
  EXPECT_NEAR(unknown_rate(score), 0.5, 1e-12);
  EXPECT_EQ(score.unknown_right, 1);
  EXPECT_NEAR(ambiguous_rate(score), 0.25, 1e-12);
  EXPECT_NEAR(risk_coverage(score).back().coverage, 0.25, 1e-12);
}

TEST(Labels, RiskFallsWhenTheUnsureAreLeftOut) {
  const auto score = score_labels(
      {thing(8, 8, 0.95), thing(8, 8, 0.9), thing(8, 12, 0.6), thing(8, 8, 0.55)}, Protocol{});
  const auto points = risk_coverage(score);
  ASSERT_EQ(points.size(), 4U);
  EXPECT_EQ(points[1].risk, 0.0);
  EXPECT_NEAR(points[2].risk, 1.0 / 3.0, 1e-12);
  EXPECT_NEAR(points[3].coverage, 1.0, 1e-12);
  EXPECT_NEAR(area_under_risk(score), 0.25 * (1.0 / 3.0 + 0.25), 1e-12);
}

TEST(Labels, PoolingEqualsTogether) {
  const auto a = thing(8, 8, 0.9), b = thing(8, 12, 0.3);
  LabelScore pooled = score_labels({a}, Protocol{});
  pooled.add(score_labels({b}, Protocol{}));
  EXPECT_EQ(pooled, score_labels({a, b}, Protocol{}));
}

TEST(Labels, EntitiesAreLaidOnTheTruth) {
  const SmallScan made = small_scan();
  const Protocol protocol;
  const ScanTruth truth = truth_of(made.scan, &made.scene, protocol);
  const Surfaces surfaces = true_surfaces(made.scan, truth);
  Labelling labelling;
  for (const auto& surface : surfaces.surfaces) {
    Entity entity;
    entity.id = surface.id;
    const std::int32_t class_id = truth.class_id[surface.inliers[0]];
    entity.label =
        class_id == *find_class("cabinet") ? "unknown" : std::string(class_info(class_id).name);
    entity.probability = 0.75;
    labelling.entities.push_back(entity);
    labelling.entity_of_surface.push_back(entity.id);
  }
  const auto things = labelled_things(truth, surfaces, labelling, protocol, {});
  int right = 0, unknown = 0;
  for (const auto& t : things) {
    right += t.label != unlabelled && t.label == t.truth;
    unknown += t.label == unlabelled && t.truth == *find_class("cabinet");
  }
  EXPECT_EQ(static_cast<std::size_t>(right + unknown), things.size());
  EXPECT_GE(unknown, 2);
  // Where there is no word for a cabinet, "unknown" is the right thing to say of it.
  for (const auto& t : labelled_things(truth, surfaces, labelling, protocol,
                                       {*find_class("desk"), *find_class("floor")})) {
    if (t.label == unlabelled) {
      EXPECT_EQ(t.truth, unlabelled);
    }
  }
}

}  // namespace
}  // namespace scanchor
