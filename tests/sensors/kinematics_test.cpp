#include "sensors/kinematics.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/math.hpp"

namespace scanchor {
namespace {

/// A UTM-30LX that sweeps 90 degrees with 139 lines: the example of sensors.md 1.2 formula 10.
LidarOptions utm() {
  LidarOptions o = lidar_preset("utm-30lx");
  o.encoder_step_deg = 0.0;
  return o;
}

Eigen::Vector3d point(const BeamColumns& beams, std::size_t k, double range) {
  return beams.origin(k) + range * beams.direction(k);
}

TEST(Kinematics, PerfectDriverBelievesTheTruth) {
  const Kinematics kinematics(utm(), 1);
  EXPECT_TRUE(kinematics.believes_truth());
  BeamColumns a, b;
  kinematics.true_beams(70, a);
  kinematics.believed_beams(70, b);
  for (std::size_t k = 0; k < 1081; k += 90) {
    EXPECT_EQ(a.direction(k), b.direction(k));
    EXPECT_NEAR(a.direction(k).norm(), 1.0, 1e-15);
  }
}

TEST(Kinematics, TimeSkewIsTheAnalyticScrew) {
  LidarOptions o = utm();
  o.deskew = false;
  const Kinematics kinematics(o, 1);
  const double omega = radians(90.0 / 138.0) * 40.0;  // 26 degrees a second
  EXPECT_NEAR(degrees(kinematics.tilt_speed()), 26.0, 0.1);
  BeamColumns truth, believed;
  kinematics.true_beams(20, truth);
  kinematics.believed_beams(20, believed);
  for (std::size_t k = 0; k < 1081; ++k) {
    const double turn = omega * static_cast<double>(k) * 0.025 / 1440.0;
    // About -y: the tilt looks up where it grows.
    const Eigen::Vector3d expected =
        Eigen::AngleAxisd(-turn, Eigen::Vector3d::UnitY()) * point(believed, k, 5.0);
    EXPECT_LT((point(truth, k, 5.0) - expected).norm(), 1e-4);
  }
  // Straight ahead, half a turn of the mirror later: 0.33 degrees, 28 mm at 5 m (formula 10).
  const double half_turn = omega * 0.0125;
  EXPECT_NEAR(degrees(half_turn), 0.33, 0.005);
  EXPECT_NEAR(5.0 * half_turn, 0.028, 0.001);
}

TEST(Kinematics, ClockOffsetTurnsEverythingByOmegaDt) {
  LidarOptions o = utm();
  o.clock_offset = 0.005;
  const Kinematics kinematics(o, 1);
  EXPECT_FALSE(kinematics.believes_truth());
  const double error = kinematics.read_tilt(3) - kinematics.true_tilt(3);
  EXPECT_NEAR(5.0 * error, 0.0114, 0.0002) << "formula 10: 11 mm at 5 m";
}

TEST(Kinematics, StoppedSweepHasNoSkew) {
  LidarOptions o = utm();
  o.sweep_moves = false;
  o.deskew = false;
  EXPECT_TRUE(Kinematics(o, 1).believes_truth());
}

TEST(Kinematics, MountFollowsFormula11) {
  LidarOptions o = utm();
  o.mount_x = 0.05, o.mount_z = 0.08;
  o.sweep_moves = false;
  const Kinematics kinematics(o, 1);
  BeamColumns beams;
  kinematics.true_beams(100, beams);
  const double phi = kinematics.true_tilt(100);
  for (std::size_t k = 0; k < 1081; k += 108) {
    const double beta = kinematics.beam_angle(static_cast<int>(k));
    const Eigen::Vector3d scanned(3 * std::cos(beta), 3 * std::sin(beta), 0);
    const Eigen::Vector3d expected = Eigen::AngleAxisd(-phi, Eigen::Vector3d::UnitY()) *
                                     (Eigen::Vector3d(0.05, 0, 0.08) + scanned);
    EXPECT_LT((point(beams, k, 3.0) - expected).norm(), 1e-12);
  }
}

TEST(Kinematics, MountErrorIsUnknownToTheDriver) {
  LidarOptions o = utm();
  o.mount_error_y = 0.01;
  o.mount_error_yaw_deg = 1.0;
  const Kinematics kinematics(o, 1);
  BeamColumns truth, believed;
  kinematics.true_beams(69, truth);
  kinematics.believed_beams(69, believed);
  const std::size_t middle = 540;
  EXPECT_NEAR(point(truth, middle, 5.0).y() - point(believed, middle, 5.0).y(),
              0.01 + 5.0 * std::sin(radians(1.0)), 1e-4);
}

TEST(Kinematics, MountErrorDrawnOnceAScanHasItsSigma) {
  LidarOptions o = utm();
  o.lines = 1, o.beams_per_line = 2;
  o.mount_sigma = 0.01;
  double sum = 0.0;
  for (std::uint64_t seed = 0; seed < 4000; ++seed) {
    sum += Kinematics(o, seed).mount_offset().squaredNorm();
  }
  EXPECT_NEAR(std::sqrt(sum / 12000), 0.01, 0.0002);
}

TEST(Kinematics, EncoderRoundsAndErrs) {
  LidarOptions o = utm();
  o.lines = 20000;
  o.encoder_step_deg = 0.088;  // Dynamixel MX-64
  double squares = 0.0, worst = 0.0;
  const Kinematics rounded(o, 1);
  for (int line = 0; line < o.lines; ++line) {
    const double error = rounded.read_tilt(line) - rounded.true_tilt(line);
    squares += error * error;
    worst = std::max(worst, std::fabs(error));
  }
  EXPECT_LE(worst, radians(0.044) + 1e-12);
  EXPECT_NEAR(std::sqrt(squares / o.lines), radians(0.088) / std::sqrt(12.0), radians(0.0005));

  o.encoder_step_deg = 0.0;
  o.encoder_sigma_deg = 0.05;
  o.backlash_deg = 0.2;
  const Kinematics noisy(o, 2);
  double sum = 0.0;
  squares = 0.0;
  for (int line = 0; line < o.lines; ++line) {
    const double error = noisy.read_tilt(line) - noisy.true_tilt(line);
    sum += error;
    squares += error * error;
  }
  const double mean = sum / o.lines;
  EXPECT_NEAR(degrees(mean), 0.1, 0.002) << "half the backlash, in the direction of motion";
  EXPECT_NEAR(degrees(std::sqrt(squares / o.lines - mean * mean)), 0.05, 0.001);
}

TEST(Kinematics, MovingRobotIntegratesItsTwist) {
  LidarOptions o = utm();
  o.robot_speed = 0.7, o.robot_speed_left = -0.2, o.robot_turn_deg = 40.0;
  const Kinematics kinematics(o, 1);
  // Small steps of the same twist, as an odometer adds them.
  Eigen::Isometry3d sum = Eigen::Isometry3d::Identity();
  const int steps = 200000;
  const double dt = 2.0 / steps;
  for (int i = 0; i < steps; ++i) {
    sum.translate(Eigen::Vector3d(0.7 * dt, -0.2 * dt, 0));
    sum.rotate(Eigen::AngleAxisd(radians(40.0) * dt, Eigen::Vector3d::UnitZ()));
  }
  EXPECT_LT((kinematics.motion(2.0).matrix() - sum.matrix()).norm(), 1e-4);
  // Near no turn the series must meet the closed form.
  o.robot_turn_deg = 0.002;
  EXPECT_NEAR(Kinematics(o, 1).motion(2.0).translation().x(), 1.4, 1e-4);
}

TEST(Kinematics, UncompensatedMotionSmears) {
  LidarOptions o = utm();
  o.robot_speed = 1.0;
  o.motion_compensated = false;
  const Kinematics kinematics(o, 1);
  BeamColumns truth, believed;
  kinematics.true_beams(138, truth);
  kinematics.believed_beams(138, believed);
  EXPECT_NEAR(truth.origin(0).x() - believed.origin(0).x(), 138 / 40.0, 1e-12);
}

TEST(Kinematics, CellsFillTheFieldOfView) {
  LidarOptions o;
  o.beams_per_line = 721, o.lines = 361;
  const Kinematics kinematics(o, 1);
  double sum = 0.0;
  for (int n = 0; n < o.lines; ++n) {
    for (int k = 0; k < o.beams_per_line; ++k) sum += kinematics.solid_angle(n, k);
  }
  // Integral of cos(beta) over 180 x 90 degrees; the outer cells stick out by half a step.
  EXPECT_NEAR(sum, 2.0 * 0.5 * pi, 0.02);

  const Kinematics camera(lidar_preset("pmd-camcube"), 1);
  sum = 0.0;
  for (int n = 0; n < 200; ++n) {
    for (int k = 0; k < 200; ++k) sum += camera.solid_angle(n, k);
  }
  const double s =
      std::sin(radians(20.0));  // of a square pyramid: 4 asin(tan^2 / (1 + tan^2)) = 4 asin(sin^2)
  EXPECT_NEAR(sum, 4.0 * std::asin(s * s), 1e-4);
}

TEST(Kinematics, SpinningChannelsAndCameraPixels) {
  const Kinematics vlp(lidar_preset("vlp-16"), 1);
  BeamColumns beams;
  vlp.true_beams(0, beams);
  EXPECT_NEAR(std::asin(beams.direction_z[77]), radians(-15.0), 1e-12);
  EXPECT_NEAR(beams.direction(0).dot(beams.direction(1799)),
              1.0 - std::pow(std::cos(radians(15.0)), 2) * (1.0 - std::cos(radians(0.2))), 1e-12)
      << "the last direction is one step before the first";

  LidarOptions o = lidar_preset("pmd-camcube");
  o.tilt_center_deg = 0.0;
  const Kinematics camera(o, 1);
  camera.true_beams(0, beams);
  EXPECT_GT(beams.direction_z[0], 0.0) << "first row is the upper one";
  EXPECT_GT(beams.direction_y[0], 0.0) << "first column is the left one";
  EXPECT_NEAR(beams.direction_y[0] / beams.direction_x[0], std::tan(radians(20.0)) * 199 / 200,
              1e-12);
}

}  // namespace
}  // namespace scanchor
