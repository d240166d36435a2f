#include "scenes/mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/math.hpp"
#include "scenes/pose.hpp"
#include "tests/scenes/support/scene_checks.hpp"

namespace scanchor {
namespace {

using testing::find_face;
using testing::open_edges;
using testing::volume;

TEST(Mesh, PrismOfAnLShape) {
  const Part part = prism_part("l", 0, {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}, 0.5, 1.5);
  EXPECT_EQ(open_edges(part), 0);
  EXPECT_NEAR(volume(part), 4.0, 1e-12);
  EXPECT_EQ(part.faces.size(), 8U);
  EXPECT_FALSE(part.convex);
}

TEST(Mesh, CylinderBetweenPoints) {
  const int n = 16;
  const double r = 0.1;
  const Eigen::Vector3d p0(1, 2, 3);
  const Eigen::Vector3d p1(1.3, 2.4, 3.0);
  const Part part = cylinder_part("c", 0, p0, p1, r, n);
  EXPECT_EQ(open_edges(part), 0);
  const double polygon = 0.5 * n * r * r * std::sin(2 * pi / n);
  EXPECT_NEAR(volume(part), polygon * 0.5, 1e-12);
  EXPECT_TRUE(part.convex);
  const Face* bottom = find_face(part, "bottom");
  ASSERT_NE(bottom, nullptr);
  EXPECT_NEAR((part.T_instance_part * bottom->center - p0).norm(), 0, 1e-12);
  EXPECT_NEAR((part.T_instance_part.linear() * bottom->normal - (p0 - p1).normalized()).norm(), 0,
              1e-12);
  EXPECT_NEAR(bottom->area, polygon, 1e-12);
  EXPECT_FALSE(find_face(part, "wall")->planar);
}

TEST(Mesh, LatheOfAVesselIsClosedAndHollow) {
  const Part part =
      lathe_part("v", 0, {{0.1, 0}, {0.12, 0.3}, {0.11, 0.3}, {0.09, 0.02}, {0, 0.02}}, 20);
  EXPECT_EQ(open_edges(part), 0);
  EXPECT_FALSE(part.convex);
  EXPECT_GT(volume(part), 0.0);
  EXPECT_LT(volume(part), 0.3 * pi * 0.12 * 0.12 * 0.4);
  const Face* rim = find_face(part, "ring 1");
  ASSERT_NE(rim, nullptr);
  EXPECT_TRUE(rim->planar);
  EXPECT_NEAR(rim->normal.z(), 1.0, 1e-9);
}

TEST(Mesh, CapsuleReachesItsEnds) {
  const Part part = capsule_part("c", 0, {0, 0, 0}, {0, 0, 1}, 0.2, 0.1, 16);
  EXPECT_EQ(open_edges(part), 0);
  double low = 0;
  double high = 0;
  for (const auto& v : part.vertices) {
    low = std::min(low, v.z());
    high = std::max(high, v.z());
  }
  EXPECT_NEAR(low, -0.2, 1e-12);
  EXPECT_NEAR(high, 1.1, 1e-12);
}

TEST(Mesh, CushionFillsItsBox) {
  for (const double exponent : {1.0, 0.5, 0.25}) {
    const Part part = cushion_part("c", 0, {1, 1, 1}, {0.6, 0.4, 0.2}, exponent, 16);
    EXPECT_EQ(open_edges(part), 0);
    const double box = 0.6 * 0.4 * 0.2;
    EXPECT_GT(volume(part), 0.4 * box);
    EXPECT_LT(volume(part), box);
    for (const auto& v : part.vertices) EXPECT_LE(std::abs(v.x()), 0.3 + 1e-12);
  }
  // A smaller exponent is nearer to a box.
  EXPECT_GT(volume(cushion_part("c", 0, {0, 0, 0}, {1, 1, 1}, 0.3, 24)),
            volume(cushion_part("c", 0, {0, 0, 0}, {1, 1, 1}, 1.0, 24)));
}

TEST(Mesh, PanelWithOpenings) {
  const std::vector<Opening> openings = {{{0.5, 0.0}, {1.4, 2.0}}, {{2.0, 0.9}, {3.0, 2.1}}};
  const Part wall = panel_part("wall", 0, 4.0, 2.5, 0.2, openings, false);
  const Face* front = find_face(wall, "front");
  ASSERT_NE(front, nullptr);
  EXPECT_NEAR(front->area, 10.0 - 1.8 - 1.2, 1e-12);
  EXPECT_NEAR(front->size.x(), 4.0, 1e-12);
  EXPECT_NEAR(front->size.y(), 2.5, 1e-12);
  EXPECT_NEAR((front->normal + Eigen::Vector3d::UnitY()).norm(), 0, 1e-12);
  // Reveals look into the opening; a door has no sill.
  EXPECT_NEAR(find_face(wall, "opening 1 left")->normal.x(), 1.0, 1e-12);
  EXPECT_NEAR(find_face(wall, "opening 1 right")->normal.x(), -1.0, 1e-12);
  EXPECT_NEAR(find_face(wall, "opening 1 lintel")->normal.z(), -1.0, 1e-12);
  EXPECT_EQ(find_face(wall, "opening 1 sill"), nullptr);
  EXPECT_NEAR(find_face(wall, "opening 2 sill")->normal.z(), 1.0, 1e-12);
  EXPECT_NEAR(find_face(wall, "opening 2 sill")->area, 0.2, 1e-12);
}

TEST(Mesh, ClosedPanelIsWatertight) {
  const Part panel = panel_part("p", 0, 2.0, 1.0, 0.05, {{{0.5, 0.2}, {1.5, 0.8}}}, true);
  EXPECT_EQ(open_edges(panel), 0);
  EXPECT_NEAR(volume(panel), (2.0 - 0.6) * 0.05, 1e-12);
  EXPECT_FALSE(panel.convex);
}

TEST(Mesh, TurnedBoxTurnsAboutItsCentre) {
  const Part part =
      turned_box_part("b", 0, {1, 2, 3}, {0.2, 0.4, 0.6}, rotation_about(2, 0.5 * pi));
  const Face* front = find_face(part, "front");
  EXPECT_NEAR((part.T_instance_part * front->center - Eigen::Vector3d(1.2, 2, 3)).norm(), 0, 1e-12);
}

}  // namespace
}  // namespace scanchor
