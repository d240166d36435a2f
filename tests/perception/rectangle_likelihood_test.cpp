#include "perception/rectangle_likelihood.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"

#include <algorithm>

namespace scanchor {
namespace {

/// Rows of 20 samples 2 cm apart along x = 0.02 k; the side looks towards +x.
struct Rows {
  RectangleEvidence evidence;
  RectangleSide side;
  Rows() {
    side.position = 0.01;
    side.gap = 0.02;
    side.low = -0.25;
    side.high = 0.25;
  }
  void add(bool inside, double x, double height) {
    for (int i = 0; i < 20; ++i) {
      (inside ? evidence.inside : evidence.outside).emplace_back(x, 0.02 * (i - 9.5));
      (inside ? evidence.inside_height : evidence.outside_height).push_back(height);
    }
  }
  /// Positions from -4 to 4.4 cm: likelihood of [from, to] against that of all.
  [[nodiscard]] double weight(double from, double to) const {
    SideLikelihood likelihood(side, evidence.sigma, evidence, {0, 0}, 0.0);
    const double start = -0.04;
    const double step = 0.084 / side_bins;
    likelihood.look_at(start, step, 0.0, 0.01);
    SideHistogram h{};
    likelihood(0.0, h);
    double part = 0.0, all = 0.0;
    for (std::size_t b = 0; b < side_bins; ++b) {
      const double x = start + (static_cast<double>(b) + 0.5) * step;
      all += h[b];
      if (x > from && x < to) part += h[b];
    }
    return part / all;
  }
};

TEST(SideLikelihood, TheEdgeLiesBetweenTheRows) {
  Rows rows;
  for (const double x : {-0.04, -0.02, 0.0}) rows.add(true, x, 0.0);
  rows.add(false, 0.02, -50.0);
  EXPECT_GT(rows.weight(-0.001, 0.021), 0.99);
  EXPECT_NEAR(rows.weight(-0.001, 0.01), 0.5, 0.1) << "anywhere between";
}

TEST(SideLikelihood, ARowBehindThePlaneIsAnotherFace) {
  Rows rows;
  rows.add(true, -0.02, 0.0);
  rows.add(true, 0.0, -2.0);  // claimed, but two sigma behind
  rows.add(false, 0.02, -8.0);
  rows.evidence.foot = Eigen::Vector2d(1.0, 0.0);  // the sensor sees what turns away here
  EXPECT_GT(rows.weight(-0.021, 0.001), 0.99);
  // From the other side of the rectangle nothing that turns away could be seen.
  rows.evidence.foot = Eigen::Vector2d(-1.0, 0.0);
  EXPECT_GT(rows.weight(-0.001, 0.021), 0.99);
  // Without heights nothing is known of it.
  rows.evidence.inside_height.clear();
  rows.evidence.outside_height.clear();
  EXPECT_GT(rows.weight(-0.001, 0.021), 0.99);
}

TEST(SideLikelihood, ARowOfItsOwnIsKeptWhereFacesMeet) {
  Rows rows;
  rows.add(true, -0.02, 0.0);
  rows.add(true, 0.0, 0.1);
  rows.add(false, 0.02, -8.0);
  rows.evidence.foot = Eigen::Vector2d(1.0, 0.0);
  EXPECT_GT(rows.weight(-0.001, 0.021), 0.99);
}

TEST(SideLikelihood, InACornerTheOtherFaceComesForward) {
  Rows rows;
  rows.add(true, -0.02, 0.0);
  rows.add(true, 0.0, 2.0);
  rows.add(false, 0.02, 8.0);
  rows.evidence.foot = Eigen::Vector2d(-1.0, 0.0);
  EXPECT_GT(rows.weight(-0.021, 0.001), 0.99);
}

TEST(SideLikelihood, PointsInThePlaneThatAnotherClaimedDoNotCutIt) {
  Rows rows;
  rows.add(true, -0.02, 0.0);
  rows.add(false, 0.0, 0.0);   // in the plane: either's
  rows.add(false, 0.02, 9.0);  // certainly not
  EXPECT_GT(rows.weight(-0.021, 0.001), 0.1);
  EXPECT_GT(rows.weight(-0.021, 0.021), 0.99);
}

TEST(SideLikelihood, NeedsBothSides) {
  Rows rows;
  rows.add(true, 0.0, 0.0);
  EXPECT_FALSE(SideLikelihood(rows.side, 0.0, rows.evidence, {0, 0}, 0.0).informed());
  rows.add(false, 0.02, -9.0);
  EXPECT_TRUE(SideLikelihood(rows.side, 0.0, rows.evidence, {0, 0}, 0.0).informed());
}

TEST(SideLikelihood, WhatIsFarFromThePlacesTriedCountsAsIfItWereSorted) {
  SequentialRandom random(4);
  RectangleEvidence evidence;
  for (int i = 0; i < 400; ++i) {
    const bool inside = i % 2 == 0;
    auto& samples = inside ? evidence.inside : evidence.outside;
    samples.emplace_back(inside ? random.uniform(-0.1, 0.02) : random.uniform(-0.02, 0.1),
                         random.uniform(-0.3, 0.3));
    (inside ? evidence.inside_height : evidence.outside_height).push_back(random.normal());
  }
  RectangleSide side;
  side.gap = 0.04;
  side.low = -0.35;
  side.high = 0.35;
  SideLikelihood narrowed(side, 0.0, evidence, {0, 0}, 0.0);
  SideLikelihood whole = narrowed;
  narrowed.look_at(-0.012, 0.024 / side_bins, 0.01, 0.005);
  whole.look_at(-0.012, 0.024 / side_bins, 0.01, 100.0);
  for (const double turn : {0.005, 0.012, 0.015}) {
    SideHistogram some{}, all{};
    EXPECT_NEAR(narrowed(turn, some), whole(turn, all), 1e-9);
    for (std::size_t b = 0; b < side_bins; ++b) EXPECT_NEAR(some[b], all[b], 1e-9);
  }
}

}  // namespace
}  // namespace scanchor
