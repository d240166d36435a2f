#include "core/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "core/math.hpp"

namespace scanchor {
namespace {

TEST(Random, PhiloxKnownAnswers) {  // kat_vectors of Random123, philox4x32 10
  using Words = std::array<std::uint32_t, 4>;
  EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}), (Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(philox({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, {0xffffffff, 0xffffffff}),
            (Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(Random, StreamsDifferByEachArgument) {
  std::set<std::uint64_t> seeds;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    for (const char* name : {"scene", "scan", "", "scene "}) {
      for (std::uint64_t index = 0; index < 20; ++index)
        seeds.insert(stream_seed(seed, name, index));
    }
  }
  EXPECT_EQ(seeds.size(), 20U * 4U * 20U);
  EXPECT_EQ(stream_seed(42, "scene", 17), stream_seed(42, "scene", 17));
}

TEST(Random, CountersDifferByEachArgument) {
  const CounterRandom random(7);
  std::set<double> draws;
  for (std::uint64_t a = 0; a < 10; ++a) {
    for (std::uint32_t b = 0; b < 10; ++b) {
      for (std::uint32_t draw = 0; draw < 10; ++draw) {
        draws.insert(random.uniform(a + (a << 33), b, draw));
      }
    }
  }
  EXPECT_EQ(draws.size(), 1000U);
}

/// Kolmogorov-Smirnov: sqrt(n) D stays below 1.95 with probability 0.999.
double kolmogorov_smirnov(std::vector<double> probabilities) {
  std::sort(probabilities.begin(), probabilities.end());
  const auto n = static_cast<double>(probabilities.size());
  double distance = 0.0;
  for (std::size_t i = 0; i < probabilities.size(); ++i) {
    const auto rank = static_cast<double>(i);
    distance =
        std::max({distance, probabilities[i] - rank / n, (rank + 1.0) / n - probabilities[i]});
  }
  return std::sqrt(n) * distance;
}

TEST(Random, UniformAndNormalHaveTheirDistributions) {
  const CounterRandom random(11);
  std::vector<double> uniform, normal, wrong;
  for (std::uint32_t i = 0; i < 50000; ++i) {
    uniform.push_back(random.uniform(i));
    normal.push_back(normal_cdf(random.normal(i, 1)));
    wrong.push_back(normal_cdf(1.03 * random.normal(i, 2)));
    EXPECT_GT(uniform.back(), 0.0);
    EXPECT_LT(uniform.back(), 1.0);
  }
  EXPECT_LT(kolmogorov_smirnov(uniform), 1.95);
  EXPECT_LT(kolmogorov_smirnov(normal), 1.95);
  EXPECT_GT(kolmogorov_smirnov(wrong), 1.95) << "the test must see a sigma that is 3 % off";
}

TEST(Random, NeighbouringCountersAreUncorrelated) {
  const CounterRandom random(12);
  const int n = 50000;
  double by_a = 0.0, by_b = 0.0;
  for (std::uint32_t i = 0; i < n; ++i) {
    by_a += random.normal(i) * random.normal(i + 1);
    by_b += random.normal(i, 0) * random.normal(i, 1);
  }
  EXPECT_LT(std::fabs(by_a) / std::sqrt(n), 3.3);
  EXPECT_LT(std::fabs(by_b) / std::sqrt(n), 3.3);
}

TEST(Random, SequentialDrawsStayInTheirBounds) {
  SequentialRandom random(5);
  std::vector<int> counts(7);
  for (int i = 0; i < 14000; ++i) {
    ++counts[random.below(7)];
    const double x = random.truncated_normal(0.0, 1.0, -0.5, 2.0);
    EXPECT_TRUE(x >= -0.5 && x <= 2.0);
    const double far = i < 20 ? random.truncated_normal(0.0, 1.0, 50.0, 51.0) : 50.5;
    EXPECT_TRUE(far >= 50.0 && far <= 51.0);
    const double y = random.uniform(3.0, 4.0);
    EXPECT_TRUE(y >= 3.0 && y < 4.0);
  }
  double chi2 = 0.0;
  for (const int count : counts) chi2 += (count - 2000.0) * (count - 2000.0) / 2000.0;
  EXPECT_LT(chi2, 22.5);  // 99.9 % of chi-square with 6 degrees of freedom
}

TEST(Random, ChanceHitsItsProbability) {
  SequentialRandom random(6);
  int hits = 0;
  for (int i = 0; i < 20000; ++i) hits += random.chance(0.3) ? 1 : 0;
  EXPECT_NEAR(hits, 6000, 3.3 * std::sqrt(20000 * 0.3 * 0.7));
}

}  // namespace
}  // namespace scanchor
