#include "sim/inside.hpp"

#include <gtest/gtest.h>

#include "scenes/mesh.hpp"
#include "tests/sim/support/boxes.hpp"

namespace scanchor {
namespace {

/// An L of two legs, 0.5 m wide, 2 cm thick.
Part angle_plate() {
  Part part = prism_part("top", 0, {{0, 0}, {1.5, 0}, {1.5, 0.5}, {0.5, 0.5}, {0.5, 1.5}, {0, 1.5}},
                         0.70, 0.72);
  part.convex = false;
  return part;
}

TEST(Inside, APointInTheBoardAndNotInTheCrook) {
  const Part plate = angle_plate();
  EXPECT_TRUE(inside_mesh(plate, {0.25, 1.0, 0.71}, 0.001));
  EXPECT_TRUE(inside_mesh(plate, {1.0, 0.25, 0.71}, 0.001));
  EXPECT_FALSE(inside_mesh(plate, {1.0, 1.0, 0.71}, 0.001)) << "the crook is empty";
  EXPECT_FALSE(inside_mesh(plate, {0.25, 1.0, 0.73}, 0.001));
  EXPECT_FALSE(inside_mesh(plate, {0.25, 1.0, 0.69}, 0.001));
  EXPECT_FALSE(inside_mesh(plate, {0.25, 1.0, 0.7195}, 0.001)) << "half a millimetre is contact";
}

TEST(Inside, WhatStandsOnTheBoardHasNotSunk) {
  Instance desk;
  desk.parts.push_back(angle_plate());
  desk.T_world_instance = testing::at(2, 2, 0);
  const auto standing = [](double z) {
    return testing::box_instance(5, {0.1, 0.1, 0.3}, testing::at(2.25, 3.0, z + 0.15), true);
  };
  EXPECT_FALSE(sunk_into(standing(0.72), desk, 0.001));
  EXPECT_FALSE(sunk_into(standing(0.7195), desk, 0.001));
  EXPECT_TRUE(sunk_into(standing(0.71), desk, 0.001));
  Instance hull = desk;
  hull.parts[0].convex = true;  // Bullet itself reports overlaps of hulls
  EXPECT_FALSE(sunk_into(standing(0.71), hull, 0.001));
}

}  // namespace
}  // namespace scanchor
