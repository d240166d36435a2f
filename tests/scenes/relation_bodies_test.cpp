#include <gtest/gtest.h>

#include "core/math.hpp"
#include "core/polygons.hpp"
#include "scenes/pose.hpp"
#include "scenes/relations.hpp"
#include "tests/scenes/support/scene_checks.hpp"

namespace scanchor {
namespace {

std::int32_t face_of(const Scene& scene, const std::string& name) {
  const auto& faces = scene.instances[0].parts[0].faces;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (faces[f].name == name) return static_cast<std::int32_t>(f);
  }
  return -1;
}

TEST(RelationBodies, AFaceKeepsItsRectangleAndItsShadow) {
  const Scene scene = testing::boards({{{1.6, 0.8, 0.02}, pose_at({2, 1, 0.7}, radians(30.0))}});
  const RelationBody top = face_body(scene, {0, 0, face_of(scene, "top")});
  EXPECT_TRUE(top.has_face);
  EXPECT_NEAR(top.z_low, 0.71, 1e-12);
  EXPECT_NEAR(top.z_high, 0.71, 1e-12);
  EXPECT_NEAR(area_of(top.footprint), 1.28, 1e-9);
  ASSERT_EQ(top.boxes.size(), 1U);
  EXPECT_NEAR(top.boxes[0].half.x(), 0.8, 1e-12);
  EXPECT_EQ(top.boxes[0].half.z(), 0.0);
  ASSERT_EQ(top.level_faces.size(), 1U) << "it can carry something";
  EXPECT_EQ(face_body(scene, {0, 0, face_of(scene, "bottom")}).level_faces.size(), 1U)
      << "of a thin board a scan may see that side alone";
  EXPECT_TRUE(face_body(scene, {0, 0, face_of(scene, "front")}).level_faces.empty());
}

TEST(RelationBodies, UprightFacesGetAThickness) {
  const Scene scene = testing::boards({{{1.0, 0.4, 0.5}, pose_at({0, 0, 0})}});
  RelationTolerances tolerances;
  const RelationBody front = face_body(scene, {0, 0, face_of(scene, "front")}, tolerances);
  // A segment of 1 m grown by 3 cm to all sides.
  EXPECT_NEAR(area_of(front.footprint), 0.06 * 1.06, 0.002);
  tolerances.upright_footprint = 0.1;
  EXPECT_GT(area_of(face_body(scene, {0, 0, face_of(scene, "front")}, tolerances).footprint), 0.2);
}

TEST(RelationBodies, AThingHasAllItsBoxesAndItsLargestFace) {
  const Scene scene = testing::alone(
      {"desk", "four legs", 1, {{"width", 1.6}, {"depth", 0.8}, {"height", 0.74}}, 0.0});
  const RelationBody desk = instance_body(scene, 0);
  EXPECT_EQ(desk.boxes.size(), scene.instances[0].parts.size());
  EXPECT_NEAR(desk.z_high, 0.74, 1e-9);
  EXPECT_NEAR(desk.face.area, 1.6 * 0.8, 1e-9);
  bool top = false;
  for (const auto& face : desk.level_faces) top = top || std::abs(face.center.z() - 0.74) < 1e-9;
  EXPECT_TRUE(top);
}

TEST(RelationBodies, RoundThingsHaveNoFaceToMeasureAnglesWith) {
  const Scene scene = testing::alone({"cushion", "", 1, {}, 0.0});
  const RelationBody cushion = instance_body(scene, 0);
  EXPECT_FALSE(cushion.has_face);
  EXPECT_LT(relate(cushion, cushion, SpatialRelation::parallel, {0, 0, 0}).margin, 0.0);
}

}  // namespace
}  // namespace scanchor
