#include "sensors/echo.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "core/math.hpp"
#include "core/random.hpp"
#include "sensors/portable_angle.hpp"

namespace scanchor {
namespace {

Sample sample(double range, double weight, std::int32_t face, std::uint8_t flags = 0) {
  return {range, weight, 1.0, static_cast<std::uint32_t>(2 * face), face, flags};
}

Echo resolve(const LidarOptions& o, std::vector<Sample> samples) {
  return resolve_echo(o, samples);
}

TEST(Echo, NothingComesBackFromNothing) { EXPECT_EQ(resolve({}, {}).triangle, no_hit); }

TEST(Echo, OneSurfaceIsTheMeanByEnergy) {
  const Echo echo = resolve({}, {sample(2.0, 0.3, 4), sample(2.1, 0.1, 4)});
  const double e1 = 0.3 / 4.0, e2 = 0.1 / (2.1 * 2.1);
  EXPECT_DOUBLE_EQ(echo.range, (e1 * 2.0 + e2 * 2.1) / (e1 + e2));
  EXPECT_DOUBLE_EQ(echo.true_range, echo.range);
  EXPECT_EQ(echo.triangle, 8U);
  EXPECT_EQ(echo.runner_up, no_hit);
  EXPECT_EQ(echo.flags, 0);
  EXPECT_NEAR(echo.reflected, (e1 + e2) * echo.range * echo.range, 1e-15);
}

TEST(Echo, SurfacesWithinTheGapRunTogether) {
  LidarOptions o;
  EXPECT_NEAR(echo_gap(o), 0.75, 0.001) << "5 ns";
  const Echo echo = resolve(o, {sample(2.0, 0.3, 4), sample(2.5, 0.5, 6)});
  const double e1 = 0.3 / 4.0, e2 = 0.5 / 6.25;
  EXPECT_DOUBLE_EQ(echo.range, (e1 * 2.0 + e2 * 2.5) / (e1 + e2));
  EXPECT_EQ(echo.flags, point_mixed);
  EXPECT_EQ(echo.triangle, 12U) << "the label of the surface with most energy";
  EXPECT_EQ(echo.runner_up, 8U);
  EXPECT_EQ(echo.true_range, 2.5);
}

TEST(Echo, SurfacesBeyondTheGapAreEchoesOfTheirOwn) {
  LidarOptions o;
  const std::vector<Sample> samples = {sample(6.0, 4.0, 3), sample(2.0, 0.1, 1),
                                       sample(4.0, 0.9, 2)};
  o.echo = "first";
  EXPECT_EQ(resolve(o, samples).range, 2.0);
  o.echo = "last";
  EXPECT_EQ(resolve(o, samples).range, 6.0);
  o.echo = "strongest";  // energies 0.025, 0.056, 0.111
  EXPECT_EQ(resolve(o, samples).range, 6.0);
  EXPECT_EQ(resolve(o, samples).flags, 0) << "not mixed: the echoes are apart";
  o.echo = "first";
  o.echo_share = 0.3;  // the nearest is too weak now
  EXPECT_EQ(resolve(o, samples).range, 4.0);
}

TEST(Echo, OrderOfSamplesDoesNotMatter) {
  const LidarOptions o;
  SequentialRandom random(3);
  for (int round = 0; round < 200; ++round) {
    std::vector<Sample> samples;
    for (int i = 0; i < 12; ++i) {
      samples.push_back(sample(random.uniform(1, 4), random.uniform(0.01, 1),
                               static_cast<int>(random.below(4)) + 1));
    }
    const Echo a = resolve(o, samples);
    for (std::size_t i = samples.size() - 1; i > 0; --i) {
      std::swap(samples[i], samples[random.below(static_cast<std::uint32_t>(i + 1))]);
    }
    const Echo b = resolve(o, samples);
    EXPECT_EQ(a.range, b.range);
    EXPECT_EQ(a.triangle, b.triangle);
    EXPECT_EQ(a.runner_up, b.runner_up);
    EXPECT_EQ(a.flags, b.flags);
  }
}

TEST(Echo, PhaseIsTheArgumentOfTheSumOfPhasors) {
  LidarOptions o;
  o.echo = "phase";
  o.modulation_frequency = 20e6;
  const double k = 4 * pi * 20e6 / 299792458.0;
  for (const double weight : {0.1, 0.5, 0.9}) {
    const double near = 2.0, far = 3.1;
    const Echo echo = resolve(o, {sample(near, weight, 1), sample(far, 1 - weight, 2)});
    const std::complex<double> z = weight / (near * near) * std::polar(1.0, k * near) +
                                   (1 - weight) / (far * far) * std::polar(1.0, k * far);
    EXPECT_NEAR(echo.range, std::arg(z) / k, 1e-12);
  }
  EXPECT_NEAR(ambiguity_range(o), 7.4948, 1e-3);
  EXPECT_NEAR(resolve(o, {sample(9.0, 1, 1)}).range, 9.0 - ambiguity_range(o), 1e-9);
  EXPECT_NEAR(resolve(o, {sample(7.0, 1, 1)}).range, 7.0, 1e-9) << "more than half a turn";
}

TEST(Echo, GhostsAndWhatLiesBehindGlassKeepTheirFlags) {
  const LidarOptions o;
  EXPECT_EQ(resolve(o, {sample(5, 1, 1, point_ghost), sample(2, 0.01, 2)}).flags, point_ghost);
  EXPECT_EQ(resolve(o, {sample(2.2, 1, 1, point_behind_glass), sample(2, 0.2, 2)}).flags,
            point_behind_glass | point_mixed);
}

TEST(PortableAngle, AgreesWithLibm) {
  for (double a = -3.14; a < 3.14; a += 0.0007) {
    EXPECT_NEAR(portable_atan2(std::sin(a), std::cos(a)), a, 1e-14);
  }
  EXPECT_EQ(portable_atan2(0.0, 0.0), 0.0);
  EXPECT_NEAR(portable_atan2(0.0, -1.0), pi, 1e-15);
  for (double c = 0.0; c <= 1.0; c += 0.0003) EXPECT_NEAR(angle_of_cosine(c), std::acos(c), 3e-8);
}

}  // namespace
}  // namespace scanchor
