#include "eval/statistics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/math.hpp"
#include "core/random.hpp"

namespace scanchor {
namespace {

// Counts {hits, trials} of scenes; the metric is their ratio.
PairedCounts ratio_counts(std::size_t scenes, double before, double after, double spread,
                          std::uint64_t seed) {
  PairedCounts counts;
  counts.name = "ratio";
  counts.value = [](std::span<const double> s) { return s[1] > 0 ? s[0] / s[1] : 0.0; };
  const CounterRandom random(seed);
  for (std::size_t i = 0; i < scenes; ++i) {
    const double trials = 20 + std::floor(20 * random.uniform(i, 0));
    const double hard = spread * random.normal(i, 1);
    counts.before.push_back({trials * (before + hard + 0.04 * random.normal(i, 2)), trials});
    counts.after.push_back({trials * (after + hard + 0.04 * random.normal(i, 3)), trials});
  }
  return counts;
}

TEST(Statistics, PooledIsNotTheMeanOfRatios) {
  PairedCounts counts;
  counts.value = [](std::span<const double> s) { return s[0] / s[1]; };
  counts.before = {{1, 1}, {0, 99}};
  counts.after = {{1, 1}, {99, 99}};
  EXPECT_DOUBLE_EQ(pooled_value(counts, counts.before), 0.01);
  EXPECT_DOUBLE_EQ(pooled_difference(counts), 0.99);
  EXPECT_DOUBLE_EQ(scene_difference(counts, 0), 0.0);
}

TEST(Statistics, IntervalOfAMeanIsNearTheNormalOne) {
  // Equal trials: the pooled difference is the mean of n differences, whose standard error is
  // known.
  PairedCounts counts;
  counts.value = [](std::span<const double> s) { return s[0] / s[1]; };
  const CounterRandom random(5);
  const std::size_t n = 400;
  double sum = 0, square = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double d = 0.02 + 0.1 * random.normal(i);
    counts.before.push_back({0.0, 1.0});
    counts.after.push_back({d, 1.0});
    sum += d;
    square += d * d;
  }
  const double mean = sum / n;
  const double error = std::sqrt((square / n - mean * mean) / n);
  const Interval interval = bca_interval(counts, 0.9, 4000, 1);
  EXPECT_NEAR(interval.low, mean - 1.645 * error, 0.1 * error);
  EXPECT_NEAR(interval.high, mean + 1.645 * error, 0.1 * error);
}

TEST(Statistics, IntervalIsPulledTowardsTheTail) {
  // Skewed scenes: BCa reaches farther on the side of the tail than a symmetric interval would.
  PairedCounts counts;
  counts.value = [](std::span<const double> s) { return s[0] / s[1]; };
  const CounterRandom random(9);
  for (std::size_t i = 0; i < 60; ++i) {
    counts.before.push_back({0.0, 1.0});
    counts.after.push_back({-std::log(random.uniform(i)), 1.0});
  }
  const double estimate = pooled_difference(counts);
  const Interval interval = bca_interval(counts, 0.9, 4000, 1);
  EXPECT_GT(interval.high - estimate, 1.1 * (estimate - interval.low));
}

TEST(Statistics, SignFlipAgreesWithTryingAllExchanges) {
  const PairedCounts counts = ratio_counts(9, 0.6, 0.57, 0.1, 21);
  const double observed = pooled_difference(counts);
  int hits = 0;
  for (unsigned pattern = 0; pattern < 512; ++pattern) {
    PairedCounts flipped = counts;
    for (unsigned i = 0; i < 9; ++i) {
      if (pattern >> i & 1U) std::swap(flipped.before[i], flipped.after[i]);
    }
    hits += pooled_difference(flipped) <= observed + 1e-12;
  }
  EXPECT_NEAR(sign_flip_p(counts, 20000, 3), hits / 512.0, 0.012);
}

TEST(Statistics, SignFlipIsUniformWhenNothingChanged) {
  // Kolmogorov-Smirnov distance of 200 p-values from the uniform distribution; 1.63 / sqrt(200) is
  // its 1 % point.
  std::vector<double> p;
  for (std::uint64_t seed = 0; seed < 200; ++seed)
    p.push_back(sign_flip_p(ratio_counts(30, 0.6, 0.6, 0.1, 100 + seed), 400, seed));
  std::sort(p.begin(), p.end());
  double distance = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    distance = std::max(distance, std::abs(p[i] - (static_cast<double>(i) + 0.5) / 200.0));
  EXPECT_LT(distance, 0.115);
}

TEST(Statistics, IntervalCoversTheTruth) {
  int covered = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Interval interval =
        bca_interval(ratio_counts(60, 0.6, 0.58, 0.1, 500 + seed), 0.9, 500, seed);
    covered += interval.low <= -0.02 && -0.02 <= interval.high;
  }
  EXPECT_GE(covered, 166);  // 180 expected; 166 is 3.3 standard deviations below
}

TEST(Statistics, HolmByHand) {
  const std::vector<double> p = {0.01, 0.04, 0.03, 0.005};
  const auto adjusted = holm_adjust(p);
  EXPECT_NEAR(adjusted[3], 0.02, 1e-12);
  EXPECT_NEAR(adjusted[0], 0.03, 1e-12);
  EXPECT_NEAR(adjusted[2], 0.06, 1e-12);
  EXPECT_NEAR(adjusted[1], 0.06, 1e-12);
}

TEST(Statistics, StepDownLiesBetweenRawAndHolm) {
  const PairedCounts a = ratio_counts(40, 0.6, 0.585, 0.1, 31),
                     b = ratio_counts(40, 0.6, 0.59, 0.1, 32);
  const std::vector<double> raw = {sign_flip_p(a, 2000, 5), sign_flip_p(b, 2000, 5),
                                   sign_flip_p(a, 2000, 5)};
  const auto holm = holm_adjust(raw);
  const auto stepped = step_down_p({a, b, a}, 2000, 5);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_GE(stepped[k], raw[k] - 1e-12);
    EXPECT_LE(stepped[k], holm[k] + 0.02);
  }
  EXPECT_EQ(stepped[0], stepped[2]);
  // The same metric twice costs nothing, where Holm would double it.
  EXPECT_NEAR(step_down_p({a, a}, 2000, 5)[0], raw[0], 1e-12);
}

TEST(Statistics, StepDownHoldsTheErrorRateOfTheFamily) {
  int alarms = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const auto p = step_down_p({ratio_counts(25, 0.6, 0.6, 0.1, 3 * seed + 1),
                                ratio_counts(25, 0.6, 0.6, 0.1, 3 * seed + 2),
                                ratio_counts(25, 0.6, 0.6, 0.1, 3 * seed + 3)},
                               200, seed);
    alarms += *std::min_element(p.begin(), p.end()) < 0.05;
  }
  EXPECT_LE(alarms, 20);  // 10 expected, 3.2 standard deviations
}

TEST(Statistics, LooksSpendAlphaAndNoMore) {
  const std::vector<int> planned = {50, 100, 200, 400};
  double sum = 0, before = 0;
  for (std::size_t i = 0; i < planned.size(); ++i) {
    const double level = look_alpha(planned, i, 0.05);
    EXPECT_GT(level, before);  // O'Brien and Fleming: little at first
    before = level;
    sum += level;
  }
  EXPECT_NEAR(sum, 0.05, 1e-12);
  EXPECT_DOUBLE_EQ(look_alpha(std::vector<int>{100}, 0, 0.05), 0.05);
}

TEST(Statistics, SameSeedSameBits) {
  const PairedCounts counts = ratio_counts(40, 0.6, 0.59, 0.1, 4);
  const Interval a = bca_interval(counts, 0.9, 1000, 7), b = bca_interval(counts, 0.9, 1000, 7);
  EXPECT_EQ(a.low, b.low);
  EXPECT_EQ(a.high, b.high);
  EXPECT_NE(bca_interval(counts, 0.9, 1000, 8).low, a.low);
}

TEST(Statistics, OneSceneIsAPoint) {
  const PairedCounts counts = ratio_counts(1, 0.6, 0.5, 0.0, 4);
  const Interval interval = bca_interval(counts, 0.9, 1000, 7);
  EXPECT_EQ(interval.low, interval.high);
}

}  // namespace
}  // namespace scanchor
