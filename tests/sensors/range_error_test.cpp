#include "sensors/range_error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/math.hpp"
#include "tests/sensors/support/targets.hpp"

namespace scanchor {
namespace {

LineReturns returns_at(double range, double reflected, double cosine, std::size_t count) {
  LineReturns r;
  r.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    r.range[k] = r.true_range[k] = range;
    r.reflected[k] = reflected;
    r.cosine[k] = cosine;
    r.triangle[k] = 0;
    r.flags[k] = 0;
  }
  return r;
}

std::vector<double> measure(const LidarOptions& o, double range, double reflected, double cosine,
                            std::uint64_t seed = 5) {
  std::vector<double> measured;
  RangeError(o, seed).apply(3, returns_at(range, reflected, cosine, 20000), measured);
  return measured;
}

TEST(RangeError, SigmaAgainstRangeWithinTwoPercent) {
  LidarOptions o;
  o.range_sigma = 0.012, o.range_slope = 0.0068, o.range_offset = 0.0008;  // LMS-1xx
  for (const double range : {0.5, 1.0, 1.7, 2.0, 4.0, 8.0, 15.0, 20.0}) {
    const double formula = std::max(0.012, 0.0068 * range + 0.0008);
    const auto measured = measure(o, range, 0.5, 1.0, static_cast<std::uint64_t>(10 * range));
    EXPECT_NEAR(testing::deviation(measured), formula, 0.02 * formula) << range << " m";
    EXPECT_NEAR(testing::mean(measured), range, 4.0 * formula / std::sqrt(20000.0));
  }
}

TEST(RangeError, SigmaAgainstIncidenceWithinThreePercentTo80Degrees) {
  for (const double exponent : {0.5, 1.0, 0.8}) {
    LidarOptions o;
    o.range_sigma = 0.0;
    o.snr_sigma = 0.004, o.snr_range = 5.0, o.snr_reflectance = 0.8, o.snr_exponent = exponent;
    for (int degrees = 0; degrees <= 80; degrees += 10) {
      const double c = std::cos(radians(degrees));
      const double formula = 0.004 * std::pow(std::pow(3.0 / 5.0, 2) * 0.8 / (0.4 * c), exponent);
      EXPECT_NEAR(testing::deviation(measure(o, 3.0, 0.4 * c, c)), formula, 0.03 * formula)
          << degrees << " degrees, exponent " << exponent;
    }
  }
}

TEST(RangeError, SpreadOfTheFootprintAddsInQuadrature) {
  LidarOptions o;
  o.range_sigma = 0.012, o.aperture = 0.008, o.divergence = 0.015, o.spread_noise = 1.0;
  // Sensors.md 1.2 formula 1: LMS-1xx at 4 m has 68 mm; at 60 degrees 29 mm.
  const double spread = 0.068 / 4.0 * std::tan(radians(60.0));
  EXPECT_NEAR(spread, 0.029, 0.0005);
  EXPECT_NEAR(range_noise_sigma(o, 4.0, 0.25, 0.5), std::hypot(0.012, spread), 1e-9);
}

TEST(RangeError, NormalDraws) {
  // Kolmogorov-Smirnov against the standard normal; 1.63 / sqrt(n) is the 1 % point.
  LidarOptions o;
  o.range_sigma = 1.0;
  auto measured = measure(o, 100.0, 0.5, 1.0);
  std::sort(measured.begin(), measured.end());
  double distance = 0.0;
  const auto n = static_cast<double>(measured.size());
  for (std::size_t i = 0; i < measured.size(); ++i) {
    const double p = normal_cdf(measured[i] - 100.0);
    distance = std::max({distance, std::fabs(p - static_cast<double>(i) / n),
                         std::fabs(p - static_cast<double>(i + 1) / n)});
  }
  EXPECT_LT(distance, 1.63 / std::sqrt(n));
}

TEST(RangeError, QuantisationHasQOverRootTwelve) {
  EXPECT_EQ(quantise(1.2345, 0.0), 1.2345);
  EXPECT_DOUBLE_EQ(quantise(1.2345, 0.01), 1.23);
  LidarOptions o;
  o.range_sigma = 0.03, o.range_quantum = 0.01;  // the LMS-200's centimetre mode
  const auto measured = measure(o, 5.0, 0.5, 1.0);
  for (const double r : measured) EXPECT_NEAR(r / 0.01, std::round(r / 0.01), 1e-6);
  const double formula = std::sqrt(0.03 * 0.03 + 0.01 * 0.01 / 12.0);
  EXPECT_NEAR(testing::deviation(measured), formula, 0.02 * formula);
}

TEST(RangeError, DriftIsOneOffsetAScan) {
  LidarOptions o;
  o.range_sigma = 0.0, o.drift_sigma = 0.005;
  EXPECT_LT(testing::deviation(measure(o, 5.0, 0.5, 1.0, 77)), 1e-12);
  double squares = 0.0;
  for (std::uint64_t seed = 0; seed < 10000; ++seed) {
    squares += std::pow(RangeError(o, seed).drift(), 2);
  }
  EXPECT_NEAR(std::sqrt(squares / 10000), 0.005, 0.02 * 0.005);
}

TEST(RangeError, WigglingRepeatsFourTimesInTheAmbiguityRange) {
  LidarOptions o;
  o.wiggle = 0.02, o.modulation_frequency = 20e6;
  const double period = 299792458.0 / (2 * 20e6) / 4.0;
  for (double r = 0.3; r < 7.0; r += 0.37) {
    EXPECT_NEAR(wiggling(o, r), 0.02 * std::sin(2 * pi * r / period), 1e-9);
  }
}

TEST(RangeError, BeamsWithoutReturnAreLeftAlone) {
  LineReturns r = returns_at(2.0, 0.5, 1.0, 3);
  r.triangle[1] = no_hit;
  std::vector<double> measured(3, -7.0);
  RangeError(LidarOptions(), 1).apply(0, r, measured);
  EXPECT_EQ(measured[1], -7.0);
  EXPECT_NE(measured[0], -7.0);
}

}  // namespace
}  // namespace scanchor
