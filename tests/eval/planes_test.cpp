#include "eval/planes.hpp"

#include <gtest/gtest.h>

#include <map>

#include "core/random.hpp"

namespace scanchor {
namespace {

struct PlaneRows {
  std::vector<std::int32_t> truth, said;
  void add(int count, int t, int s) {
    truth.insert(truth.end(), static_cast<std::size_t>(count), t);
    said.insert(said.end(), static_cast<std::size_t>(count), s);
  }
};

Protocol one_tolerance(double tolerance) {
  Protocol protocol;
  protocol.plane_tolerances = {tolerance};
  protocol.geometry_tolerance = tolerance;
  protocol.plane_min_points = 1;
  return protocol;
}

HooverCounts at(const PlaneRows& rows, double tolerance, std::size_t planes,
                PlaneMatch* match = nullptr) {
  const std::vector<char> ignored(planes, 0);
  return score_planes(rows.truth, ignored, rows.said, one_tolerance(tolerance), match).hoover[0];
}

TEST(Planes, FiveClassesByHand) {
  PlaneRows rows;
  rows.add(90, 0, 0);  // correct: 90 of 100 in a region of 95
  rows.add(5, 1, 0);
  rows.add(10, 0, -1);
  rows.add(50, 1, 1);  // in two pieces: 50 and 45 of 100
  rows.add(45, 1, 2);
  rows.add(100, 2, 3);  // two truths run together
  rows.add(80, 3, 3);
  rows.add(40, 4, -1);  // missed
  rows.add(30, 5, 4);   // half found: missed, and the region is noise
  rows.add(30, 5, -1);
  PlaneMatch match;
  const HooverCounts counts = at(rows, 0.8, 6, &match);
  EXPECT_EQ(counts.correct, 1);
  EXPECT_EQ(counts.truth_over, 1);
  EXPECT_EQ(counts.regions_over, 2);
  EXPECT_EQ(counts.truth_under, 2);
  EXPECT_EQ(counts.regions_under, 1);
  EXPECT_EQ(counts.missed, 2);
  EXPECT_EQ(counts.noise, 1);
  EXPECT_EQ(match.region_of_truth[0], 0);
  EXPECT_EQ(match.truth[1], HooverClass::over);
  EXPECT_EQ(match.region[3], HooverClass::under);
  EXPECT_EQ(match.region[4], HooverClass::missed_or_noise);
}

TEST(Planes, StricterToleranceFindsLess) {
  PlaneRows rows;
  rows.add(85, 0, 0);
  rows.add(15, 0, -1);
  EXPECT_EQ(at(rows, 0.8, 1).correct, 1);
  EXPECT_EQ(at(rows, 0.9, 1).correct, 0);
  EXPECT_EQ(at(rows, 0.85, 1).correct, 1);  // "at least", as Hoover has it
}

TEST(Planes, OfTwoReadingsTheLargerAverageHolds) {
  // 80 % of the truth is one region, 18 % a second one: correct measures (0.8 + 1) / 2,
  // over-segmentation (0.98 + 1) / 2.
  PlaneRows rows;
  rows.add(80, 0, 0);
  rows.add(18, 0, 1);
  rows.add(2, 0, -1);
  const HooverCounts counts = at(rows, 0.75, 1);
  EXPECT_EQ(counts.correct, 0);
  EXPECT_EQ(counts.truth_over, 1);
}

TEST(Planes, EveryTruthAndRegionIsInExactlyOneClass) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SequentialRandom random(seed);
    PlaneRows rows;
    for (int i = 0; i < 40; ++i) {
      const int t = static_cast<int>(random.below(12));
      rows.add(1 + static_cast<int>(random.below(60)), t,
               random.chance(0.6) ? t : static_cast<int>(random.below(14)) - 1);
    }
    const std::vector<char> ignored(12, 0);
    for (const double tolerance : {0.51, 0.7, 0.95}) {
      const PlaneScore score =
          score_planes(rows.truth, ignored, rows.said, one_tolerance(tolerance));
      const auto& h = score.hoover[0];
      EXPECT_EQ(h.correct + h.truth_over + h.truth_under + h.missed, score.truths);
      EXPECT_EQ(h.correct + h.regions_over + h.regions_under + h.noise, score.regions);
    }
  }
}

TEST(Planes, IgnoredTruthCountsOnNeitherSide) {
  PlaneRows rows;
  rows.add(100, 0, 0);
  rows.add(40, 1, 1);   // ignored, found
  rows.add(30, -1, 2);  // no plane at all
  const std::vector<char> ignored = {0, 1};
  const PlaneScore score = score_planes(rows.truth, ignored, rows.said, one_tolerance(0.8));
  EXPECT_EQ(score.truths, 1);
  EXPECT_EQ(score.regions, 1);
  EXPECT_EQ(score.hoover[0].noise, 0);
  EXPECT_EQ(plane_precision(score, 0), 1.0);
}

TEST(Planes, AdjustedNumbersPairOneToOne) {
  // One region over two planes: each keeps at most one partner, so a segmenter that joins
  // everything does not win.
  PlaneRows rows;
  rows.add(60, 0, 0);
  rows.add(40, 1, 0);
  const std::vector<char> ignored = {0, 0};
  const PlaneScore score = score_planes(rows.truth, ignored, rows.said, one_tolerance(0.8));
  EXPECT_NEAR(adjusted_precision(score), 0.6, 1e-12);
  EXPECT_NEAR(adjusted_recall(score), 0.6, 1e-12);
}

TEST(Planes, SmallPlanesHaveARecallOfTheirOwn) {
  PlaneRows rows;
  rows.add(9900, 0, 0);
  rows.add(60, 1, 1);
  rows.add(20, 1, 0);
  rows.add(20, 1, -1);
  const std::vector<char> ignored = {0, 0};
  Protocol protocol = one_tolerance(0.8);
  protocol.small_plane_share = 0.02;
  EXPECT_NEAR(small_plane_recall(score_planes(rows.truth, ignored, rows.said, protocol)), 0.6,
              1e-9);
}

TEST(Planes, RandIndicesAgreeWithLookingAtEveryPair) {
  SequentialRandom random(11);
  for (int trial = 0; trial < 20; ++trial) {
    PlaneRows rows;
    for (int i = 0; i < 60; ++i) {
      const int t = static_cast<int>(random.below(4));
      rows.add(1, t, random.chance(0.7) ? t : static_cast<int>(random.below(5)) - 1);
    }
    double agree = 0, pairs = 0, both = 0, in_truth = 0, in_said = 0;
    for (std::size_t i = 0; i < 60; ++i) {
      for (std::size_t j = i + 1; j < 60; ++j) {
        const bool t = rows.truth[i] == rows.truth[j];
        const bool s = rows.said[i] == rows.said[j] && rows.said[i] >= 0;
        pairs += 1;
        agree += t == s;
        both += t && s;
        in_truth += t;
        in_said += s;
      }
    }
    const std::vector<char> ignored(4, 0);
    const PlaneScore score = score_planes(rows.truth, ignored, rows.said, one_tolerance(0.8));
    EXPECT_NEAR(rand_index(score), agree / pairs, 1e-12);
    const double expected = in_truth * in_said / pairs;
    EXPECT_NEAR(adjusted_rand_index(score),
                (both - expected) / (0.5 * (in_truth + in_said) - expected), 1e-9);
  }
}

TEST(Planes, RandIndexOfTheSamePartitionIsOneWhateverTheNames) {
  PlaneRows rows;
  rows.add(30, 0, 7);
  rows.add(20, 1, 3);
  const std::vector<char> ignored = {0, 0};
  const PlaneScore score = score_planes(rows.truth, ignored, rows.said, one_tolerance(0.8));
  EXPECT_EQ(rand_index(score), 1.0);
  EXPECT_NEAR(adjusted_rand_index(score), 1.0, 1e-9);
}

TEST(Planes, NothingIsNoScoreAndNoError) {
  const PlaneScore score = score_planes({}, {}, {}, Protocol{});
  EXPECT_EQ(score.truths, 0);
  EXPECT_EQ(plane_recall(score, 0), 0.0);
  EXPECT_EQ(rand_index(score), 0.0);
}

}  // namespace
}  // namespace scanchor
