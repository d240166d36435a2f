#include "core/math.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"

namespace scanchor {
namespace {

double relative_error(double value, long double exact) {
  return static_cast<double>(std::fabs((static_cast<long double>(value) - exact) / exact));
}

TEST(Math, DegreesAndRadiansAreInverse) {
  EXPECT_DOUBLE_EQ(radians(180.0), pi);
  EXPECT_DOUBLE_EQ(degrees(radians(37.5)), 37.5);
}

TEST(Math, LogAgainstLongDouble) {
  const CounterRandom random(1);
  for (std::uint32_t i = 0; i < 20000; ++i) {
    const double x = std::exp2(2000.0 * random.uniform(i) - 1000.0);
    EXPECT_LT(relative_error(portable_log(x), std::log(static_cast<long double>(x))), 1e-15) << x;
  }
  EXPECT_EQ(portable_log(1.0), 0.0);
  EXPECT_LT(relative_error(portable_log(5e-324), std::log(static_cast<long double>(5e-324))),
            1e-15);
}

TEST(Math, LogNearOneKeepsItsRelativeError) {
  for (int i = 1; i < 2000; ++i) {
    for (const double x : {1.0 + i * 1e-7, 1.0 - i * 1e-7}) {
      EXPECT_LT(relative_error(portable_log(x), std::log(static_cast<long double>(x))), 1e-15) << x;
    }
  }
}

TEST(Math, ExpAgainstLongDouble) {
  const CounterRandom random(2);
  for (std::uint32_t i = 0; i < 20000; ++i) {
    const double x = 1400.0 * random.uniform(i) - 700.0;
    EXPECT_LT(relative_error(portable_exp(x), std::exp(static_cast<long double>(x))), 1e-15) << x;
  }
  EXPECT_EQ(portable_exp(0.0), 1.0);
}

TEST(Math, SinCosAgainstLongDouble) {
  const CounterRandom random(3);
  for (std::uint32_t i = 0; i < 20000; ++i) {
    const double scale = i % 2 == 0 ? 7.0 : 1e5;
    const double x = scale * (2.0 * random.uniform(i) - 1.0);
    const SinCos sc = portable_sincos(x);
    EXPECT_NEAR(sc.sin, static_cast<double>(std::sin(static_cast<long double>(x))), 1e-15) << x;
    EXPECT_NEAR(sc.cos, static_cast<double>(std::cos(static_cast<long double>(x))), 1e-15) << x;
  }
  EXPECT_EQ(portable_sincos(0.0).sin, 0.0);
  EXPECT_EQ(portable_sincos(0.0).cos, 1.0);
}

TEST(Math, QuantileInvertsTheDistribution) {
  EXPECT_EQ(normal_quantile(0.5), 0.0);
  EXPECT_NEAR(normal_quantile(0.975), 1.959963984540054, 1e-15);
  EXPECT_NEAR(normal_quantile(1e-20), -9.262340089798408, 1e-13);
  const CounterRandom random(4);
  for (std::uint32_t i = 0; i < 20000; ++i) {
    const double u = random.uniform(i);
    const double p = i % 2 == 0 ? u : std::exp2(-60.0 * u) * 0.5;
    const long double x = normal_quantile(p);
    const long double back = 0.5L * std::erfc(-x / std::sqrt(2.0L));
    // dp = phi(x) dx; phi(x) |x| / p bounds how an error of 1e-15 in x shows in p.
    const double magnify = 1.0 + static_cast<double>(x * x);
    EXPECT_LT(relative_error(p, back), 2e-15 * magnify) << p;
    EXPECT_NEAR(normal_cdf(static_cast<double>(x)), p, 1e-14);
  }
}

}  // namespace
}  // namespace scanchor
