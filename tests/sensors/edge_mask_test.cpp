#include "sensors/edge_mask.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "scenes/generator.hpp"
#include "sensors/beam_tracer.hpp"

#include "tests/sensors/support/targets.hpp"

namespace scanchor {
namespace {

Eigen::Isometry3d standing() {
  Eigen::Isometry3d T = testing::at(3.1, 2.3, 1.4);
  T.linear() = Eigen::AngleAxisd(0.6, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return T;
}

LidarOptions wide_beam(const char* geometry) {
  LidarOptions o;
  o.geometry = geometry;
  o.beams_per_line = 120, o.lines = 60;
  if (o.geometry == "camera") o.horizontal_deg = 60, o.vertical_deg = 45;
  if (o.geometry == "spinning") o.horizontal_deg = 360, o.vertical_deg = 30, o.tilt_center_deg = 0;
  o.divergence = 0.015, o.aperture = 0.008;
  o.subrays = 19;
  return o;
}

TEST(EdgeMask, SameBytesAsSubraysEverywhere) {
  // Turned boxes go through each other and through the walls: edges and creases of all kinds.
  const World world(testing::random_boxes(40, 31));
  for (const char* geometry : {"tilting", "spinning", "camera"}) {
    LidarOptions o = wide_beam(geometry);
    const Scan masked = scan_room(world, standing(), o, 5);
    o.subrays_everywhere = true;
    const Scan everywhere = scan_room(world, standing(), o, 5);
    EXPECT_EQ(testing::digest(masked), testing::digest(everywhere)) << geometry;
  }
}

TEST(EdgeMask, HoldsBehindTheBackAndWithAnOffsetMount) {
  const World world(testing::random_boxes(25, 33));
  LidarOptions o = wide_beam("tilting");
  o.horizontal_deg = 270.0;
  o.mount_x = 0.1, o.mount_z = 0.05;
  o.mount_error_yaw_deg = 0.5;
  o.profile = "gaussian";
  const Scan masked = scan_room(world, standing(), o, 6);
  o.subrays_everywhere = true;
  EXPECT_EQ(testing::digest(masked), testing::digest(scan_room(world, standing(), o, 6)));
}

TEST(EdgeMask, LeavesThePlainMiddleOfWallsOut) {
  Scene scene = testing::empty_scene();
  testing::add_room(scene, {6, 5, 3});
  const World world(scene);
  LidarOptions o = wide_beam("tilting");
  o.beams_per_line = 500, o.lines = 200;
  o.divergence = 0.005;
  const Kinematics kinematics(o, 1);
  std::vector<LineReturns> lines(static_cast<std::size_t>(o.lines));
  const BeamTracer tracer(world, o, 1);
  for (int n = 0; n < o.lines; ++n) {
    BeamColumns beams;
    kinematics.true_beams(n, beams);
    const Eigen::Isometry3d T = standing();
    for (std::size_t k = 0; k < 500; ++k) {
      const Eigen::Vector3d origin = T * beams.origin(k), d = T.linear() * beams.direction(k);
      beams.origin_x[k] = origin.x(), beams.origin_y[k] = origin.y(),
      beams.origin_z[k] = origin.z();
      beams.direction_x[k] = d.x(), beams.direction_y[k] = d.y(), beams.direction_z[k] = d.z();
    }
    tracer.trace_middles(beams, lines[static_cast<std::size_t>(n)]);
  }
  const auto mask = straddling_beams(world, standing(), o, kinematics, 1.0, lines);
  const double share =
      std::accumulate(mask.begin(), mask.end(), 0.0) / static_cast<double>(mask.size());
  EXPECT_LT(share, 0.25) << "an empty room is mostly wall";
  EXPECT_GT(share, 0.01);
}

// Whole rooms with the devices that have a footprint, at a third of their lines.
TEST(EdgeMask, SameBytesInFurnishedRooms) {
  for (const char* preset : {"lms-1xx", "lms-5xx", "lms-200", "vlp-16"}) {
    for (const char* family : {"office", "storage aisle"}) {
      RoomOptions room;
      room.family = family;
      const Scene scene = generate_room(room, 60);
      const World world(scene);
      LidarOptions o = lidar_preset(preset);
      if (o.geometry == "tilting") o.lines /= 4;
      if (o.geometry == "spinning") o.beams_per_line /= 4;
      const Scan masked = scan_room(world, scene.sensor_poses[0], o, 7);
      o.subrays_everywhere = true;
      const Scan everywhere = scan_room(world, scene.sensor_poses[0], o, 7);
      EXPECT_EQ(testing::digest(masked), testing::digest(everywhere)) << preset << ", " << family;
    }
  }
}

// Marking is only worth it where it leaves much out.
TEST(EdgeMask, FewBeamsInAFullRoomAreAllTraced) {
  const Scene scene = generate_room({}, 60);
  const World world(scene);
  const auto marked = [&](const LidarOptions& o) {
    const Kinematics kinematics(o, 1);
    std::vector<LineReturns> lines(static_cast<std::size_t>(o.lines));
    for (auto& line : lines) {
      line.resize(static_cast<std::size_t>(o.beams_per_line));
      std::fill(line.triangle.begin(), line.triangle.end(), no_hit);
    }
    const auto mask = straddling_beams(world, scene.sensor_poses[0], o, kinematics, 1.0, lines);
    return std::accumulate(mask.begin(), mask.end(), 0.0) / static_cast<double>(mask.size());
  };
  EXPECT_EQ(marked(lidar_preset("vlp-16")), 1.0);
  EXPECT_LT(marked(lidar_preset("lms-1xx")), 0.9);
}

TEST(EdgeMask, AMovingRobotTracesAll) {
  const World world(testing::random_boxes(3, 1));
  LidarOptions o = wide_beam("tilting");
  o.robot_speed = 0.5;
  const Kinematics kinematics(o, 1);
  const std::vector<LineReturns> lines(60);
  const auto mask = straddling_beams(world, standing(), o, kinematics, 1.0, lines);
  EXPECT_EQ(std::accumulate(mask.begin(), mask.end(), 0U), 120U * 60U);
}

}  // namespace
}  // namespace scanchor
