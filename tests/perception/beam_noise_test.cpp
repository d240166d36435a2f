#include "perception/beam_noise.hpp"

#include <gtest/gtest.h>

#include "perception/cell_planes.hpp"

namespace scanchor {
namespace {

MomentPlane level(double height) {
  MomentPlane plane;
  plane.normal = Eigen::Vector3d::UnitZ();
  plane.offset = height;
  return plane;
}

TEST(BeamNoise, LiesAlongTheBeam) {
  const BeamNoise nowhere = 0.01;
  EXPECT_DOUBLE_EQ(nowhere.across(level(0.0), {3, 0, 0}), 0.01);
  const BeamNoise noise(0.01, {0, 0, 1});
  EXPECT_DOUBLE_EQ(noise.across(level(0.0), {0, 0, 0}), 0.01);                  // straight down
  EXPECT_NEAR(noise.across(level(0.0), {std::sqrt(3.0), 0, 0}), 0.005, 1e-12);  // 60 degrees
  EXPECT_DOUBLE_EQ(noise.across(level(0.0), {100, 0, 0}), 0.01 * BeamNoise::grazing);
  EXPECT_FALSE(noise.is_edge_on(level(0.0), {10, 0, 0}));
  EXPECT_TRUE(noise.is_edge_on(level(0.99), {10, 0, 0}));
  EXPECT_FALSE(nowhere.is_edge_on(level(0.0), {10, 0, 0}));
}

TEST(BeamNoise, AReachIsThreeSigmaAtThePointsOwnIncidence) {
  const BeamNoise noise(0.01, {0, 0, 1});
  Moments moments;
  for (int i = -5; i <= 5; ++i) {
    for (int j = -5; j <= 5; ++j) moments.add(0.1 * i, 0.1 * j, 0.0);
  }
  const PlaneReach reach(grown_plane(moments, noise));
  EXPECT_TRUE(reach.holds(0, 0, 0.029F, 1.0F));
  EXPECT_FALSE(reach.holds(0, 0, 0.031F, 1.0F));
  EXPECT_TRUE(reach.holds(2, 0, 0.014F, 0.5F));  // 2 m away: half of it
  EXPECT_FALSE(reach.holds(2, 0, 0.016F, 0.5F));
  EXPECT_FALSE(reach.holds(50, 0, 0.005F, 0.02F));
  EXPECT_TRUE(reach.holds(50, 0, 0.004F, 0.02F));
}

}  // namespace
}  // namespace scanchor
