#include "sensors/merge.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/error.hpp"
#include "tests/sensors/support/targets.hpp"

namespace scanchor {
namespace {

std::vector<Scan> two_scans() {
  Scene scene = testing::empty_scene();
  testing::add_room(scene, {6, 5, 3});
  const World world(scene);
  LidarOptions o;
  o.range_sigma = 0.0;
  o.lines = 30, o.beams_per_line = 61;
  Eigen::Isometry3d second = testing::at(4.5, 3.5, 1.2);
  second.linear() = Eigen::AngleAxisd(2.5, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return {scan_room(world, testing::at(1.5, 1.5, 1.3), o, 1), scan_room(world, second, o, 2)};
}

double gap_to_room(const Eigen::Vector3d& w) {
  return w.cwiseAbs().cwiseMin((Eigen::Vector3d(6, 5, 3) - w).cwiseAbs()).minCoeff();
}

TEST(Merge, WithoutErrorAllPointsLieOnTheWalls) {
  const auto scans = two_scans();
  const MergedScan merged = merge_scans(scans, {}, 5);
  ASSERT_EQ(merged.scan.cloud.size(), scans[0].cloud.size() + scans[1].cloud.size());
  for (const auto& p : merged.scan.cloud.points) {
    EXPECT_LT(gap_to_room(merged.scan.T_world_sensor * p), 1e-9);
  }
  EXPECT_EQ(merged.scan.cloud.sensor_poses.size(), 2U);
  EXPECT_EQ(merged.scan.cloud.find("scan")->at(0), 0.0);
  EXPECT_EQ(merged.scan.cloud.find("scan")->at(merged.scan.cloud.size() - 1), 1.0);
  EXPECT_EQ(merged.scan.beams_fired, 2U * 30U * 61U);
  for (const auto& v : merged.scan.visibility) EXPECT_LE(v.visible_fraction, 1.0);
}

TEST(Merge, ErrorHasTheChosenSize) {
  MergeOptions o;
  o.position_sigma = 0.02;
  o.angle_sigma_deg = 0.5;
  double moved = 0.0, turned = 0.0;
  const int count = 5000;
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Isometry3d error = pose_error(o, 3, i);
    moved += error.translation().squaredNorm() / 3.0;
    turned += std::pow(Eigen::AngleAxisd(error.linear()).angle(), 2) / 3.0;
    EXPECT_NEAR(error.linear().determinant(), 1.0, 1e-12);
  }
  EXPECT_NEAR(std::sqrt(moved / count), 0.02, 0.02 * 0.02);
  EXPECT_NEAR(std::sqrt(turned / count), radians(0.5), 0.02 * radians(0.5));
}

TEST(Merge, FirstScanStaysAndTheErrorIsReported) {
  MergeOptions o;
  o.position_sigma = 0.05;
  const auto scans = two_scans();
  const MergedScan merged = merge_scans(scans, o, 5);
  EXPECT_EQ(merged.T_first_placed[0].matrix(), Eigen::Matrix4d::Identity());
  EXPECT_EQ(merged.scan.cloud.points[7], scans[0].cloud.points[7]);
  EXPECT_GT((merged.T_first_placed[1].translation() - merged.T_first_scan[1].translation()).norm(),
            0.005);
  const Eigen::Vector3d expected = merged.T_first_placed[1] * scans[1].cloud.points[0];
  EXPECT_EQ(merged.scan.cloud.points[scans[0].cloud.size()], expected);
}

TEST(Merge, ShufflingMovesWholeRows) {
  MergeOptions o;
  const auto scans = two_scans();
  const MergedScan plain = merge_scans(scans, o, 5);
  o.shuffle = true;
  const MergedScan mixed = merge_scans(scans, o, 5);
  ASSERT_EQ(mixed.scan.cloud.size(), plain.scan.cloud.size());
  EXPECT_NE(mixed.scan.cloud.points[0], plain.scan.cloud.points[0]);
  using Row = std::tuple<double, double, double, int, int, int, float>;
  const auto rows = [](const Scan& s) {
    std::vector<Row> all;
    for (std::size_t i = 0; i < s.cloud.size(); ++i) {
      const auto& p = s.cloud.points[i];
      all.emplace_back(p.x(), p.y(), p.z(), s.truth.face[i], s.line[i], s.beam[i],
                       s.truth.true_range[i]);
    }
    std::sort(all.begin(), all.end());
    return all;
  };
  EXPECT_EQ(rows(mixed.scan), rows(plain.scan));
}

TEST(Merge, NoScansIsWrongUsage) { EXPECT_THROW(merge_scans({}, {}, 1), Error); }

TEST(Merge, OptionsAreDescribed) {
  MergeOptions o;
  OptionList list;
  o.describe(list);
  list.set("position_sigma", "0.03");
  EXPECT_EQ(o.position_sigma, 0.03);
}

}  // namespace
}  // namespace scanchor
