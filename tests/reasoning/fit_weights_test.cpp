#include "reasoning/fit_weights.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"

namespace scanchor {
namespace {

using Candidate = WeighedExample::Candidate;

WeighedExample example(std::int32_t truth, std::vector<Candidate> candidates) {
  return {std::move(candidates), truth};
}

double loss(const std::vector<WeighedExample>& examples, const FittedWeights& at,
            const FittedWeights& start, double offset_strength, double weight_strength) {
  double sum = 0.0;
  for (std::size_t i = 0; i < at.offset.size(); ++i)
    sum += 0.5 * offset_strength * std::pow(at.offset[i] - start.offset[i], 2);
  for (std::size_t i = 0; i < at.weight.size(); ++i)
    sum += 0.5 * weight_strength * std::pow(at.weight[i] - start.weight[i], 2);
  for (const auto& e : examples) {
    const auto shares = shares_of(e, at);
    std::size_t right = e.candidates.size();
    for (std::size_t k = 0; k < e.candidates.size(); ++k) {
      if (e.candidates[k].class_index == e.truth) right = k;
    }
    sum -= std::log(shares[right]);
  }
  return sum;
}

/// Two classes; parameters 0 and 1 speak for the first, 2 for the second.
std::vector<WeighedExample> random_examples(std::uint64_t seed, const FittedWeights& truth,
                                            int count) {
  SequentialRandom random(seed);
  std::vector<WeighedExample> examples;
  for (int i = 0; i < count; ++i) {
    const double a = random.uniform(-2, 2);
    const double b = random.uniform(-2, 2);
    const double c = random.uniform(-2, 2);
    auto e = example(-1, {{0, {{0, a}, {1, b}}}, {1, {{2, c}}}});
    const auto shares = shares_of(e, truth);
    const double u = random.uniform(0, 1);
    e.truth = u < shares[0] ? 0 : u < shares[0] + shares[1] ? 1 : -1;
    examples.push_back(std::move(e));
  }
  return examples;
}

TEST(FitWeights, SharesByHand) {
  const auto e = example(0, {{0, {{0, std::log(6.0)}}}, {1, {}}});
  const auto shares = shares_of(e, {{0.0, std::log(2.0)}, {0.5}});
  ASSERT_EQ(shares.size(), 3U);
  const double all = std::sqrt(6.0) + 2.0 + 1.0;
  EXPECT_NEAR(shares[0], std::sqrt(6.0) / all, 1e-12);
  EXPECT_NEAR(shares[1], 2.0 / all, 1e-12);
  EXPECT_NEAR(shares[2], 1.0 / all, 1e-12);
}

TEST(FitWeights, FindsTheWeightsThatMadeTheTruths) {
  const FittedWeights truth{{-0.5, 0.7}, {1.2, 0.4, 0.8}};
  const auto examples = random_examples(1, truth, 20000);
  const auto found = fit_weights(examples, {{0, 0}, {1, 1, 1}}, 0.1, 1.0);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(found.offset[i], truth.offset[i], 0.06);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found.weight[i], truth.weight[i], 0.06);
}

TEST(FitWeights, NothingNearbyIsBetter) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const FittedWeights start{{0, 0}, {0.5, 0.5, 0.5}};
    const auto examples = random_examples(seed, {{-1, 1}, {1.5, 0.0, 0.3}}, 60);
    const auto found = fit_weights(examples, start, 0.1, 2.0);
    const double best = loss(examples, found, start, 0.1, 2.0);
    SequentialRandom random(seed);
    for (int k = 0; k < 50; ++k) {
      FittedWeights other = found;
      for (double& o : other.offset) o += random.uniform(-0.05, 0.05);
      for (double& w : other.weight) w = std::max(0.0, w + random.uniform(-0.05, 0.05));
      EXPECT_GE(loss(examples, other, start, 0.1, 2.0), best - 1e-9);
    }
  }
}

TEST(FitWeights, AClauseThatMisleadsIsSilencedAndNeverTurnedRound) {
  // The clause speaks for the class exactly where it is not there.
  std::vector<WeighedExample> examples;
  for (int i = 0; i < 200; ++i)
    examples.push_back(example(i % 2 == 0 ? 0 : -1, {{0, {{0, i % 2 == 0 ? -1.0 : 1.0}}}}));
  const auto found = fit_weights(examples, {{0.0}, {1.0}}, 0.1, 1.0);
  EXPECT_EQ(found.weight[0], 0.0);
  EXPECT_NEAR(found.offset[0], 0.0, 1e-6);
}

TEST(FitWeights, WithoutExamplesNothingMoves) {
  const auto found = fit_weights({}, {{-1.0, 2.0}, {0.5}}, 0.1, 1.0);
  EXPECT_EQ(found.offset[0], -1.0);
  EXPECT_EQ(found.offset[1], 2.0);
  EXPECT_EQ(found.weight[0], 0.5);
}

TEST(FitWeights, TwoCopiesOfAClauseShareItsWeight) {
  // Evidence that is counted twice must not be believed twice.
  SequentialRandom random(3);
  std::vector<WeighedExample> once, twice;
  for (int i = 0; i < 4000; ++i) {
    const double a = random.uniform(-3, 3);
    const int truth = random.chance(1.0 / (1.0 + std::exp(-a))) ? 0 : -1;
    once.push_back(example(truth, {{0, {{0, a}}}}));
    twice.push_back(example(truth, {{0, {{0, a}, {1, a}}}}));
  }
  const auto one = fit_weights(once, {{0.0}, {1.0}}, 0.1, 0.1);
  const auto two = fit_weights(twice, {{0.0}, {1.0, 1.0}}, 0.1, 0.1);
  EXPECT_NEAR(two.weight[0] + two.weight[1], one.weight[0], 0.01);
}

}  // namespace
}  // namespace scanchor
