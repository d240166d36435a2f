#include "scenes/scene.hpp"

#include <gtest/gtest.h>

#include "scenes/pose.hpp"
#include "scenes/truth.hpp"
#include "tests/scenes/support/scene_checks.hpp"

namespace scanchor {
namespace {

TEST(Scene, BoxHasSixMeasuredFaces) {
  const Part box = box_part("body", 3, {1, 2, 3}, {0.4, 0.6, 0.2});
  EXPECT_EQ(box.material, 3);
  EXPECT_TRUE(box.convex);
  EXPECT_EQ(testing::open_edges(box), 0);
  EXPECT_NEAR(testing::volume(box), 0.4 * 0.6 * 0.2, 1e-12);
  const Face* top = testing::find_face(box, "top");
  ASSERT_NE(top, nullptr);
  EXPECT_TRUE(top->center.isApprox(Eigen::Vector3d(1, 2, 3.1)));
  EXPECT_EQ(top->normal, Eigen::Vector3d::UnitZ());
  EXPECT_EQ(top->axis, Eigen::Vector3d::UnitY());
  EXPECT_DOUBLE_EQ(top->size.x(), 0.6);
  EXPECT_DOUBLE_EQ(top->size.y(), 0.4);
  EXPECT_DOUBLE_EQ(top->area, 0.24);
  EXPECT_EQ(testing::find_face(box, "front")->normal, -Eigen::Vector3d::UnitY());
  EXPECT_EQ(testing::find_face(box, "left")->normal, -Eigen::Vector3d::UnitX());
}

// The closed form of box_part against the measurement of its triangles.
TEST(Scene, BoxFacesEqualTheirTriangles) {
  const Part box = box_part("body", 0, {-0.3, 0.1, 0.7}, {1.6, 0.8, 0.025});
  Part again = box;
  measure_faces(again);
  for (std::size_t f = 0; f < box.faces.size(); ++f) {
    EXPECT_NEAR((again.faces[f].center - box.faces[f].center).norm(), 0, 1e-12)
        << box.faces[f].name;
    EXPECT_NEAR((again.faces[f].normal - box.faces[f].normal).norm(), 0, 1e-12);
    EXPECT_NEAR(std::abs(again.faces[f].axis.dot(box.faces[f].axis)), 1, 1e-12);
    EXPECT_NEAR((again.faces[f].size - box.faces[f].size).norm(), 0, 1e-12);
    EXPECT_NEAR(again.faces[f].area, box.faces[f].area, 1e-12);
  }
}

TEST(Scene, FacesAreNumberedByInstancePartFace) {
  Scene scene;
  scene.instances.resize(2);
  scene.instances[0].parts = {box_part("a", 0, {0, 0, 0}, {1, 1, 1}),
                              box_part("b", 0, {2, 0, 0}, {1, 1, 1})};
  scene.instances[1].parts = {box_part("c", 0, {0, 0, 0}, {1, 1, 1})};
  const auto faces = all_faces(scene);
  ASSERT_EQ(faces.size(), 18U);
  EXPECT_EQ(faces[7].instance, 0);
  EXPECT_EQ(faces[7].part, 1);
  EXPECT_EQ(faces[7].face, 1);
  EXPECT_EQ(faces[12].instance, 1);
  EXPECT_EQ(triangle_count(scene), 36U);
}

TEST(Scene, FacesMoveWithInstanceAndPart) {
  Scene scene;
  scene.instances.resize(1);
  Part part = box_part("a", 0, {0, 0, 0}, {2, 1, 0.1});
  part.T_instance_part = pose_at({1, 0, 0});
  scene.instances[0].parts = {part};
  scene.instances[0].T_world_instance = pose_at({10, 0, 5}, 0.5 * pi);
  const WorldFace top = world_face(scene, {0, 0, 0});
  EXPECT_NEAR((top.center - Eigen::Vector3d(10, 1, 5.05)).norm(), 0, 1e-12);
  EXPECT_NEAR((top.axis - Eigen::Vector3d::UnitY()).norm(), 0, 1e-12);
  const WorldFace right = world_face(scene, {0, 0, 5});
  EXPECT_NEAR((right.normal - Eigen::Vector3d::UnitY()).norm(), 0, 1e-12);
  EXPECT_NEAR((world_bounds(scene.instances[0]).max() - Eigen::Vector3d(10.5, 2, 5.05)).norm(), 0,
              1e-12);
  EXPECT_NEAR((local_bounds(scene.instances[0]).max() - Eigen::Vector3d(2, 0.5, 0.05)).norm(), 0,
              1e-12);
}

}  // namespace
}  // namespace scanchor
