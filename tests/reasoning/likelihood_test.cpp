#include "reasoning/likelihood.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/math.hpp"
#include "core/random.hpp"

namespace scanchor {
namespace {

TEST(Likelihood, CrispWithoutUncertainty) {
  EXPECT_EQ(upper_likelihood(1.0, 2.0, 0.0), 1.0);
  EXPECT_EQ(upper_likelihood(3.0, 2.0, 0.0), 0.0);
  EXPECT_EQ(between_likelihood(1.5, 1.0, 2.0, 0.0), 1.0);
  EXPECT_EQ(between_likelihood(2.5, 1.0, 2.0, 0.0), 0.0);
  EXPECT_EQ(cone_likelihood(0.1, 0.2, 0.0), 1.0);
  EXPECT_EQ(cone_likelihood(0.3, 0.2, 0.0), 0.0);
}

TEST(Likelihood, HalfAtTheLimit) {
  EXPECT_NEAR(upper_likelihood(2.0, 2.0, 0.1), 0.5, 1e-12);
  EXPECT_NEAR(lower_likelihood(2.0, 2.0, 0.1), 0.5, 1e-12);
  EXPECT_EQ(upper_likelihood(5.0, INFINITY, 0.1), 1.0);
}

TEST(Likelihood, ConeIsTheRiceDistribution) {
  // Oracle: the share of 2D normal tilts around theta that fall in the disc, by integration over
  // rings of the disc.
  for (const double theta : {0.0, 1.0, 3.0, 5.0, 8.0, 15.0}) {
    for (const double s : {0.3, 1.0, 4.0}) {
      const double tolerance = 5.0;
      double sum = 0.0;
      const int rings = 400;
      const int turns = 720;
      for (int i = 0; i < rings; ++i) {
        const double r = tolerance * (i + 0.5) / rings;
        for (int j = 0; j < turns; ++j) {
          const double phi = 2.0 * pi * j / turns;
          const double d2 = r * r + theta * theta - 2.0 * r * theta * std::cos(phi);
          sum += r * std::exp(-0.5 * d2 / (s * s));
        }
      }
      sum *= (tolerance / rings) * (2.0 * pi / turns) / (2.0 * pi * s * s);
      EXPECT_NEAR(cone_likelihood(theta, tolerance, s), sum, 2e-3) << theta << " " << s;
    }
  }
}

TEST(Likelihood, ConeIsCalibratedWherePlainPhiIsNot) {
  // Tilts uniform in a disc of 15 degrees as in reasoning.md 2.3, measured with 4 degrees in each
  // component.
  const CounterRandom random(7);
  const double s = 4.0;
  double said_rice[10] = {}, true_rice[10] = {}, said_phi[10] = {}, true_phi[10] = {};
  int n_rice[10] = {}, n_phi[10] = {};
  const int draws = 60000;
  for (int i = 0; i < draws; ++i) {
    const double r = 15.0 * std::sqrt(random.uniform(i, 0));
    const double measured = std::hypot(r + s * random.normal(i, 1), s * random.normal(i, 2));
    const double truth = r <= 5.0 ? 1.0 : 0.0;
    const auto put = [&](double p, double* said, double* was, int* n) {
      const int bin = std::min(9, static_cast<int>(p * 10));
      said[bin] += p;
      was[bin] += truth;
      ++n[bin];
    };
    put(cone_likelihood(measured, 5.0, s), said_rice, true_rice, n_rice);
    put(between_likelihood(measured, -5.0, 5.0, s), said_phi, true_phi, n_phi);
  }
  const auto error = [&](const double* said, const double* was, const int* n) {
    double sum = 0.0;
    for (int b = 0; b < 10; ++b) {
      if (n[b] > 0) sum += std::abs(said[b] - was[b]);
    }
    return sum / draws;
  };
  EXPECT_LT(error(said_rice, true_rice, n_rice), 0.02);
  EXPECT_GT(error(said_phi, true_phi, n_phi),
            0.04);  // the plain form is what the test must tell apart
}

TEST(Likelihood, HiddenSharesKeepLargerSizesPossible) {
  EXPECT_EQ(censored_likelihood(0.5, 1.0, 2.0, 0.05, 0.0), between_likelihood(0.5, 1.0, 2.0, 0.05));
  double last = 0.0;
  for (const double hidden : {0.1, 0.3, 0.6, 0.9}) {
    const double value = censored_likelihood(0.5, 1.0, 2.0, 0.05, hidden);
    EXPECT_GT(value, last);
    last = value;
  }
  // Half hidden is Beta(1, 1): half the size is possible with one half.
  EXPECT_NEAR(censored_likelihood(0.5, 1.0, 2.0, 1e-6, 0.5), 0.5, 1e-9);
  // A shadow never makes a thing smaller.
  EXPECT_LT(censored_likelihood(2.5, 1.0, 2.0, 0.05, 0.9), 1e-6);
}

}  // namespace
}  // namespace scanchor
