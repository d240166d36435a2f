#include "eval/truth.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "tests/eval/support/small_scan.hpp"

namespace scanchor {
namespace {

const PlaneTruth* plane_of(const ScanTruth& truth, const char* name, double area) {
  for (const auto& plane : truth.planes) {
    if (plane.class_id == *find_class(name) && std::abs(plane.area - area) < 1e-9) return &plane;
  }
  return nullptr;
}

TEST(Truth, KnowsThePlanesInTheFrameOfTheCloud) {
  const SmallScan made = small_scan();
  const ScanTruth truth = truth_of(made.scan, &made.scene, Protocol{});
  const PlaneTruth* top = plane_of(truth, "desk", 1.6 * 0.8);
  ASSERT_NE(top, nullptr);
  EXPECT_NEAR(top->length, 1.6, 1e-12);
  EXPECT_NEAR(top->width, 0.8, 1e-12);
  EXPECT_NEAR(top->normal.z(), 1.0, 1e-12);
  EXPECT_NEAR(top->offset, 0.72 - 1.5, 1e-12);
  EXPECT_FALSE(top->ignored);
  const PlaneTruth* front = plane_of(truth, "cabinet", 0.8 * 1.0);
  ASSERT_NE(front, nullptr);
  EXPECT_NEAR(front->offset, -(0.3 + 2.0),
              1e-9);  // 2.3 m in front of the sensor, normal towards it
}

TEST(Truth, WhatHasFewPointsIsIgnored) {
  const SmallScan made = small_scan();
  const ScanTruth truth = truth_of(made.scan, &made.scene, Protocol{});
  int ignored = 0;
  for (const auto& thing : truth.things) {
    EXPECT_EQ(thing.ignored, thing.instance == 4) << thing.name;
    ignored += thing.ignored;
  }
  EXPECT_EQ(ignored, 1);
}

// A jamb that is seen whole shows no door: the face must be large, and have points of its own.
TEST(Truth, PlainlyInViewIsALargeFaceWithPoints) {
  SmallScan made = small_scan();
  const auto addresses = all_faces(made.scene);
  const auto face_of = [&](const FaceVisibility& entry) -> const Face& {
    const auto& address = addresses[static_cast<std::size_t>(entry.face)];
    return made.scene.instances[static_cast<std::size_t>(address.instance)]
        .parts[static_cast<std::size_t>(address.part)]
        .faces[static_cast<std::size_t>(address.face)];
  };
  const auto is_cabinet = [&](const FaceVisibility& entry) {
    const auto& address = addresses[static_cast<std::size_t>(entry.face)];
    return made.scene.instances[static_cast<std::size_t>(address.instance)].id == 3;
  };
  const auto ignored = [&](double large_face, int min_face_points) {
    Protocol protocol;
    protocol.large_face = large_face;
    protocol.min_face_points = min_face_points;
    const auto& list = truth_of(made.scan, &made.scene, protocol).ignored_instances;
    return std::find(list.begin(), list.end(), 3) != list.end();
  };
  double largest = 0.0;
  std::int32_t most = 0;
  for (const auto& entry : made.scan.visibility) {
    if (!is_cabinet(entry)) continue;
    largest = std::max(largest, face_of(entry).area);
    most = std::max(most, entry.points);
  }
  ASSERT_GT(most, 50);
  EXPECT_FALSE(ignored(0.1, most));
  EXPECT_TRUE(ignored(0.1, most + 1));
  // Only the smallest face in view stays visible.
  double smallest = largest;
  for (auto& entry : made.scan.visibility) {
    if (!is_cabinet(entry)) continue;
    if (face_of(entry).area < smallest && entry.points > 0) smallest = face_of(entry).area;
  }
  ASSERT_LT(smallest, largest);
  for (auto& entry : made.scan.visibility) {
    if (is_cabinet(entry)) entry.visible_fraction = face_of(entry).area == smallest ? 1.0 : 0.0;
  }
  EXPECT_FALSE(ignored(0.99 * smallest / largest, 0));
  EXPECT_TRUE(ignored(1.01 * smallest / largest, 0));
}

TEST(Truth, WhatIsHardlyVisibleIsIgnored) {
  SmallScan made = small_scan();
  for (auto& entry : made.scan.visibility) {
    if (made.scene
            .instances[static_cast<std::size_t>(
                all_faces(made.scene)[static_cast<std::size_t>(entry.face)].instance)]
            .id == 3) {
      entry.visible_fraction = 0.05;
    }
  }
  const ScanTruth truth = truth_of(made.scan, &made.scene, Protocol{});
  EXPECT_EQ(truth.ignored_instances, std::vector<std::int32_t>{3});
  EXPECT_TRUE(plane_of(truth, "cabinet", 0.8)->ignored);
}

TEST(Truth, FacesThatNoScanCanTellApartAreOnePlane) {
  SmallScan made = small_scan();
  const auto planes = [&] { return truth_of(made.scan, &made.scene, Protocol{}).planes.size(); };
  const std::size_t apart = planes();
  // A second desk as high as the first, side by side: their tops become one plane, and so do their
  // fronts.
  made.scene.instances[2].parts = {box_part("body", 0, Eigen::Vector3d::Zero(), {1.6, 0.8, 0.72})};
  made.scene.instances[2].T_world_instance.translation() = Eigen::Vector3d(0.61, 0, 0.36);
  EXPECT_EQ(planes(), apart - 2);
  made.scene.instances[2].T_world_instance.translation().z() = 0.38;  // a step of 2 cm can be told
  EXPECT_EQ(planes(), apart - 1);
  made.scene.instances[2].T_world_instance.translation() =
      Eigen::Vector3d(0.9, 0, 0.36);  // a gap of 30 cm too
  EXPECT_EQ(planes(), apart);
}

TEST(Truth, FlaggedPointsHaveNone) {
  SmallScan made = small_scan();
  made.scan.truth.flags[5] = point_ghost;
  made.scan.truth.flags[6] = point_behind_glass;
  const ScanTruth truth = truth_of(made.scan, &made.scene, Protocol{});
  EXPECT_EQ(truth.class_id[5], unlabelled);
  EXPECT_EQ(truth.plane[5], -1);
  EXPECT_NE(truth.class_id[6], unlabelled);
}

TEST(Truth, WithoutASceneFacesArePlanes) {
  const SmallScan made = small_scan();
  const ScanTruth with = truth_of(made.scan, &made.scene, Protocol{}),
                  without = truth_of(made.scan, nullptr, Protocol{});
  EXPECT_EQ(with.plane, without.plane);
  EXPECT_FALSE(without.planes[0].has_geometry);
}

TEST(Truth, ScanAndSceneMustBelongTogether) {
  SmallScan made = small_scan();
  made.scan.truth.face[0] = 5000;
  EXPECT_THROW(truth_of(made.scan, &made.scene, Protocol{}), Error);
  made.scan.truth.class_id.pop_back();
  EXPECT_THROW(truth_of(made.scan, nullptr, Protocol{}), Error);
}

}  // namespace
}  // namespace scanchor
