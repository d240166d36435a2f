#include "sensors/tilting_lidar.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "sensors/detection.hpp"
#include "tests/sensors/support/targets.hpp"

namespace scanchor {
namespace {

using testing::at;
using testing::box_instance;

const Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();

Eigen::Isometry3d standing_lidar() {
  Eigen::Isometry3d T = at(2.5, 2.2, 1.3);
  T.linear() = Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return T;
}

TEST(TiltingLidar, NoiseFreePointsLieWhereTheRaysMeetTheBoxes) {
  const Scene scene = testing::random_boxes(30, 41);
  const World world(scene);
  LidarOptions o;
  o.range_sigma = 0.0;
  o.beams_per_line = 200, o.lines = 80;
  o.minimum_range = 0.001;  // some of the boxes are next to the scanner
  const Scan scan = scan_room(world, standing_lidar(), o, 1);
  ASSERT_EQ(scan.cloud.size(), 16000U);
  int other = 0;
  for (std::size_t i = 0; i < scan.cloud.size(); ++i) {
    const Ray ray{standing_lidar().translation(),
                  standing_lidar().linear() * scan.cloud.points[i].normalized()};
    const auto truth = testing::trace_boxes(scene, ray);
    if (truth.edge_distance < 1e-4) continue;
    if (std::fabs(truth.range - scan.cloud.points[i].norm()) > 1e-9) ++other;
    EXPECT_NEAR(scan.truth.true_range[i], scan.cloud.points[i].norm(), 1e-6);
    EXPECT_EQ(scan.truth.instance[i], scene.instances[static_cast<std::size_t>(truth.instance)].id);
    EXPECT_EQ(scan.truth.class_id[i], 1);
  }
  EXPECT_LE(other, 1);
}

TEST(TiltingLidar, SameBytesForThreadsPacketsAndInstructionSets) {
  const Scene scene = testing::random_boxes(30, 42);
  LidarOptions all = lidar_preset("lms-1xx");  // footprint, mixed pixels, quantum
  all.lines = 40, all.beams_per_line = 181;
  all.detection_range = 15.0, all.encoder_sigma_deg = 0.05, all.clock_offset = 0.002;
  all.mount_sigma = 0.005, all.snr_sigma = 0.004, all.drift_sigma = 0.005;
  all.subrays = 9;
  std::string first;
  for (const char* isa : {"", "sse2", "avx2"}) {
    for (const int width : {1, 8, 16}) {
      for (const int threads : {1, 2}) {
        const ThreadLimit limit(threads);
        WorldOptions w;
        w.embree_isa = isa;
        w.packet_width = width;
        const World world(scene, w);
        // A plain scan and one with all effects, 20 scans in the whole set of runs.
        LidarOptions plain;
        plain.lines = 40;
        const std::string digest = testing::digest(scan_room(world, standing_lidar(), plain, 9)) +
                                   testing::digest(scan_room(world, standing_lidar(), all, 9));
        if (first.empty()) first = digest;
        EXPECT_EQ(digest, first) << isa << " width " << width << " threads " << threads;
      }
    }
  }
}

TEST(TiltingLidar, AnotherSeedIsAnotherScan) {
  const World world(testing::random_boxes(5, 44));
  LidarOptions o;
  o.lines = 10;
  EXPECT_NE(testing::digest(scan_room(world, standing_lidar(), o, 1)),
            testing::digest(scan_room(world, standing_lidar(), o, 2)));
}

TEST(TiltingLidar, MemoryIsUsedAgainWithTheSameResult) {
  const World world(testing::random_boxes(5, 45));
  LidarOptions big, small;
  small.lines = 20;
  small.loss = 0.3;
  Scan scan;
  scan_room_into(world, standing_lidar(), big, 1, scan);
  scan_room_into(world, standing_lidar(), small, 2, scan);
  EXPECT_EQ(testing::digest(scan), testing::digest(scan_room(world, standing_lidar(), small, 2)));
  scan_room_into(world, standing_lidar(), big, 1, scan);
  EXPECT_EQ(testing::digest(scan), testing::digest(scan_room(world, standing_lidar(), big, 1)));
}

TEST(TiltingLidar, NoiseThroughTheWholeSensor) {
  LidarOptions o = testing::straight_beams(100, 200);
  o.range_sigma = 0.012, o.range_slope = 0.0068, o.range_offset = 0.0008;
  for (const double range : {1.0, 5.0, 12.0}) {
    const auto r = testing::ranges(scan_room(World(testing::plate(range)), origin, o, 3));
    const double formula = std::max(0.012, 0.0068 * range + 0.0008);
    EXPECT_NEAR(testing::deviation(r), formula, 0.02 * formula);
  }
}

TEST(TiltingLidar, IncidenceThroughTheWholeSensor) {
  LidarOptions o = testing::straight_beams(100, 200);
  o.snr_sigma = 0.003, o.snr_range = 4.0, o.snr_reflectance = 0.8;
  for (const double a : {0.0, 40.0, 70.0, 80.0}) {
    const Scan scan = scan_room(World(testing::plate(4.0, radians(a), 0.4)), origin, o, 4);
    const double formula = 0.003 * 0.8 / (0.4 * std::cos(radians(a)));
    EXPECT_NEAR(testing::deviation(testing::ranges(scan)), formula, 0.03 * formula);
    EXPECT_NEAR(scan.truth.incidence[0], radians(a), 1e-6);
  }
}

TEST(TiltingLidar, DropoutThroughTheWholeSensor) {
  LidarOptions o = testing::straight_beams(200, 200);
  o.detection_range = 10.0, o.detection_reflectance = 0.1;
  for (const double range : {8.0, 10.0, 11.0}) {
    const Scan scan = scan_room(World(testing::plate(range, 0.0, 0.1)), origin, o, 5);
    EXPECT_EQ(scan.beams_fired, 40000U);
    EXPECT_NEAR(static_cast<double>(scan.cloud.size()) / 40000.0,
                detection_probability(o, range, 0.1), 0.01);
  }
}

TEST(TiltingLidar, RangeLimitsDropOrReport) {
  LidarOptions o = testing::straight_beams(2, 3);
  o.minimum_range = 1.0, o.maximum_range = 10.0;
  EXPECT_EQ(scan_room(World(testing::plate(0.5)), origin, o, 1).cloud.size(), 0U);
  EXPECT_EQ(scan_room(World(testing::plate(5.0)), origin, o, 1).cloud.size(), 6U);
  EXPECT_EQ(scan_room(World(testing::plate(15.0)), origin, o, 1).cloud.size(), 0U);
  o.report_maximum = true;
  const Scan scan = scan_room(World(testing::plate(15.0)), origin, o, 1);
  ASSERT_EQ(scan.cloud.size(), 6U);
  EXPECT_NEAR(scan.cloud.points[0].norm(), 10.0, 1e-12);
  EXPECT_EQ(scan.truth.flags[0], point_out_of_range);
  EXPECT_EQ(scan.truth.instance[0], -1);
  EXPECT_TRUE(scan.visibility.empty());
  EXPECT_EQ(scan_room(World(testing::plate(0.5)), origin, o, 1).cloud.size(), 0U)
      << "too near is lost";
}

TEST(TiltingLidar, PointsComeInTheOrderOfMeasurement) {
  LidarOptions o;
  o.loss = 0.2;
  const Scan scan = scan_room(World(testing::random_boxes(10, 46)), standing_lidar(), o, 1);
  EXPECT_LT(scan.cloud.size(), scan.beams_fired);
  for (std::size_t i = 1; i < scan.cloud.size(); ++i) {
    EXPECT_LT(scan.line[i - 1] * 500 + scan.beam[i - 1], scan.line[i] * 500 + scan.beam[i]);
  }
}

TEST(TiltingLidar, VisibleFractionIsTheFreeShareOfAFace) {
  // A plate of 2 x 2 m at 3 m, whose left half a nearer plate hides.
  Scene scene = testing::empty_scene();
  scene.instances.push_back(box_instance(1, {0.1, 2, 2}, at(3.05, 0, 0)));
  LidarOptions o;
  o.tilt_center_deg = 0.0;
  o.range_sigma = 0.0;
  o.lines = 361, o.beams_per_line = 721;
  const auto fraction = [&] {
    const World world(scene);
    const Scan scan = scan_room(world, origin, o, 1);
    double best = 0.0;
    for (const auto& v : scan.visibility) {
      if (world.faces()[static_cast<std::size_t>(v.face)].instance == 0) {
        best = std::max(best, v.visible_fraction);
      }
    }
    return best;
  };
  EXPECT_NEAR(fraction(), 1.0, 0.02);
  scene.instances.push_back(box_instance(2, {0.02, 4, 4}, at(1.51, 2.0, 0)));
  EXPECT_NEAR(fraction(), 0.5, 0.02);
}

TEST(TiltingLidar, CompensatedDriveLeavesPointsOnTheWalls) {
  Scene scene = testing::empty_scene();
  testing::add_room(scene, {6, 5, 3});
  LidarOptions o;
  o.range_sigma = 0.0;
  o.robot_speed = 0.1, o.robot_turn_deg = 5.0;
  const auto worst = [&] {
    const Scan scan = scan_room(World(scene), standing_lidar(), o, 1);
    double far = 0.0;
    for (const auto& p : scan.cloud.points) {
      const Eigen::Vector3d w = scan.T_world_sensor * p;
      const Eigen::Vector3d gap = w.cwiseAbs().cwiseMin((Eigen::Vector3d(6, 5, 3) - w).cwiseAbs());
      far = std::max(far, gap.minCoeff());
    }
    return far;
  };
  EXPECT_LT(worst(), 1e-9);
  o.motion_compensated = false;
  EXPECT_GT(worst(), 0.1);
}

TEST(TiltingLidar, EveryPresetSeesTheRoom) {
  const World world(testing::random_boxes(10, 47));
  for (const std::string& name : lidar_presets()) {
    LidarOptions o = lidar_preset(name);
    o.lines = std::min(o.lines, 24);
    const Scan scan = scan_room(world, standing_lidar(), o, 1);
    EXPECT_GT(scan.cloud.size(), scan.beams_fired * 9 / 10) << name;
    double squares = 0.0;
    int plain = 0;
    for (std::size_t i = 0; i < scan.cloud.size(); ++i) {
      EXPECT_GT(scan.truth.class_id[i], 0);
      if (scan.truth.flags[i] != 0) continue;
      squares += std::pow(scan.cloud.points[i].norm() - scan.truth.true_range[i], 2);
      ++plain;
    }
    EXPECT_LT(std::sqrt(squares / plain), 0.06) << name;
  }
}

TEST(TiltingLidar, ContradictionIsWrongUsage) {
  LidarOptions o;
  o.minimum_range = 50;
  EXPECT_THROW(scan_room(World(testing::plate(3)), origin, o, 1), Error);
}

}  // namespace
}  // namespace scanchor
