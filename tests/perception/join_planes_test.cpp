#include "perception/join_planes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"

namespace scanchor {
namespace {

// A patch of z = height + slope x about (x0, 0).
GrownPlane patch(SequentialRandom& random, double x0, double height, double slope, double sigma) {
  Moments moments;
  for (int i = 0; i < 400; ++i) {
    const double x = x0 + random.uniform(-0.3, 0.3);
    moments.add(x, random.uniform(-0.3, 0.3), height + slope * x + sigma * random.normal());
  }
  return grown_plane(moments, sigma);
}

TEST(JoinPlanes, PiecesOfOnePlaneJoinAndOthersDoNot) {
  SequentialRandom random(1);
  const double sigma = 0.01;
  std::vector<GrownPlane> planes = {
      patch(random, 0.0, 0.0, 0.0, sigma), patch(random, 0.6, 0.0, 0.0, sigma),
      patch(random, 1.2, 0.03, 0.0, sigma), patch(random, 1.8, 0.0, 0.0, sigma),
      patch(random, 0.0, 0.0, 0.2, sigma)};
  const auto into =
      join_planes({{0, 1}, {0, 2}, {0, 4}, {1, 2}, {1, 3}, {2, 3}}, sigma, same_plane, planes);
  EXPECT_EQ(into, (std::vector<std::int32_t>{0, 0, 2, 0, 4}));
  EXPECT_EQ(planes[0].moments.n, 1200.0);
}

// The false-alarm rate of same_plane on true pairs, and its power against a step of one sigma.
TEST(JoinPlanes, TestHasTheRatesItClaims) {
  SequentialRandom random(2);
  int joined = 0, stepped = 0;
  for (int k = 0; k < 300; ++k) {
    const auto a = patch(random, 0.0, 0.0, 0.0, 0.01);
    joined += same_plane(a, patch(random, 0.6, 0.0, 0.0, 0.01), 0.01);
    stepped += same_plane(a, patch(random, 0.6, 0.02, 0.0, 0.01), 0.01);
  }
  EXPECT_GE(joined, 298);
  EXPECT_LE(stepped, 15);
}

TEST(JoinPlanes, SureOnlyWhereThePlaneIsKnown) {
  SequentialRandom random(3);
  const auto a = patch(random, 0.0, 0.0, 0.0, 0.01);
  EXPECT_TRUE(surely_same_plane(a, patch(random, 0.8, 0.0, 0.0, 0.01), 0.01));
  EXPECT_FALSE(
      surely_same_plane(a, patch(random, 30.0, 0.0, 0.0, 0.01), 0.01));  // too far to be known
}

// An even rectangle of z = 0 from (x0, 0) to (x1, y1).
GrownPlane top(SequentialRandom& random, double x0, double x1, double y1, double sigma) {
  Moments moments;
  for (int i = 0; i < 2000; ++i)
    moments.add(random.uniform(x0, x1), random.uniform(0.0, y1), sigma * random.normal());
  return grown_plane(moments, sigma);
}

TEST(JoinPlanes, DesksOfOneHeightStayTwoAndAShadowedFloorIsOne) {
  SequentialRandom random(4);
  const double sigma = 0.01;
  const auto desk = top(random, 0.0, 1.6, 0.8, sigma),
             other = top(random, 3.1, 4.7, 0.8, sigma);  // 1.5 m apart
  EXPECT_TRUE(same_plane(desk, other, sigma));
  EXPECT_FALSE(surely_same_plane(desk, other, sigma));
  const auto floor = top(random, 0.0, 2.0, 4.0, sigma),
             beyond = top(random, 2.3, 5.0, 4.0, sigma);  // a shadow of 0.3 m
  EXPECT_TRUE(surely_same_plane(floor, beyond, sigma));
}

// Planes drawn from the box that log_chance_agreement speaks of: as many pass the test of 16.3 as
// it says, of which it counts a ball of three dimensions.
TEST(JoinPlanes, ChanceOfAgreementIsThatOfPlanesDrawn) {
  SequentialRandom random(12);
  const double sigma = 0.02;
  const auto sheet = [&](double from, double height, double du, double dv) {
    Moments moments;
    for (int i = 0; i < 40; ++i) {
      const double u = random.uniform(0.0, 0.3), v = random.uniform(0.0, 0.3);
      moments.add(from + u, v, height + du * u + dv * v + sigma * random.normal());
    }
    return grown_plane(moments, BeamNoise(sigma));
  };
  const GrownPlane first = sheet(0.0, 0.0, 0.0, 0.0);
  double passed = 0.0, said = 0.0;
  constexpr int draws = 4000;
  for (int k = 0; k < draws; ++k) {
    const GrownPlane second = sheet(0.4, random.uniform(-0.125, 0.125),
                                    random.uniform(-0.125, 0.125), random.uniform(-0.125, 0.125));
    passed += same_plane(first, second, BeamNoise(sigma)) ? 1.0 / draws : 0.0;
    said += std::exp(log_chance_agreement(first, second)) / draws;
  }
  EXPECT_GT(said,
            0.3 * passed);  // the test allows a tenth of the noise more, and the box has sides
  EXPECT_LT(said, 3.0 * passed);
  EXPECT_GT(passed, 0.01);
}

TEST(JoinPlanes, MorePointsAgreeLessByChance) {
  SequentialRandom random(13);
  double last = 0.0;
  for (const int count : {30, 300, 3000}) {
    std::vector<GrownPlane> planes;
    for (const double from : {0.0, 0.4}) {
      Moments moments;
      for (int i = 0; i < count; ++i)
        moments.add(from + random.uniform(0.0, 0.3), random.uniform(0.0, 0.3),
                    0.01 * random.normal());
      planes.push_back(grown_plane(moments, BeamNoise(0.01)));
    }
    const double chance = log_chance_agreement(planes[0], planes[1]);
    EXPECT_NEAR(chance, log_chance_agreement(planes[1], planes[0]), 1.0);
    EXPECT_LT(chance, last - 2.0);  // ten times the points: a factor of 10^1.5
    last = chance;
  }
}

}  // namespace
}  // namespace scanchor
