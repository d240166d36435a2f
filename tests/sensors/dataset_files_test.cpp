#include "sensors/dataset_files.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "core/error.hpp"

namespace scanchor {
namespace {

Scan small_scan() {
  Scan scan;
  scan.cloud.points = {{1, 2, 3}, {4, 5, 6}};
  scan.truth.resize(2);
  scan.truth.class_id = {8, -1};
  scan.truth.instance = {300, -1};
  scan.truth.part = {2, -1};
  scan.truth.face = {70000, -1};
  scan.truth.runner_up = {-1, 65536};
  scan.truth.flags = {0, 5};
  scan.truth.true_range = {1.5F, 0.0F};
  scan.truth.incidence = {0.25F, 0.0F};
  scan.line = {7, -1};
  scan.beam = {65000, 1};
  return scan;
}

TEST(DatasetFiles, LabelsAreSemanticKittis) {
  EXPECT_EQ(label_bytes(small_scan().truth, "f"), std::string("\x08\0\x2c\x01\0\0\0\0", 8));
  PointTruth truth = small_scan().truth;
  truth.instance[0] = 65536;
  EXPECT_THROW((void)label_bytes(truth, "f"), Error);
}

TEST(DatasetFiles, TruthIsANumpyArray) {
  const std::string bytes = truth_npy(small_scan());
  EXPECT_TRUE(bytes.starts_with(std::string("\x93NUMPY\x01\0", 8)));
  const std::size_t header =
      10 + static_cast<unsigned char>(bytes[8]) + 256U * static_cast<unsigned char>(bytes[9]);
  EXPECT_EQ(header % 64, 0U);
  EXPECT_EQ(bytes[header - 1], '\n');
  EXPECT_EQ(bytes.size(), header + 2 * 23);
  const std::string record = bytes.substr(header, 23);
  EXPECT_EQ(
      record,
      std::string("\x70\x11\x01\0\x02\0\xff\xff\xff\xff\0\x07\0\xe8\xfd\0\0\xc0\x3f\0\0\x80\x3e",
                  23));
}

TEST(DatasetFiles, TruthReadsBack) {
  const Scan scan = small_scan();
  Scan back;
  back.truth.resize(2);
  read_truth_npy(truth_npy(scan), back, "f");
  EXPECT_EQ(back.truth.face, scan.truth.face);
  EXPECT_EQ(back.truth.part, scan.truth.part);
  EXPECT_EQ(back.truth.runner_up, scan.truth.runner_up);
  EXPECT_EQ(back.truth.flags, scan.truth.flags);
  EXPECT_EQ(back.truth.true_range, scan.truth.true_range);
  EXPECT_EQ(back.truth.incidence, scan.truth.incidence);
  EXPECT_EQ(back.line, scan.line);
  EXPECT_EQ(back.beam, scan.beam);
  const std::string bytes = truth_npy(scan);
  EXPECT_THROW(read_truth_npy(bytes.substr(0, bytes.size() - 1), back, "f"), Error);
  EXPECT_THROW(read_truth_npy(bytes.substr(0, 40), back, "f"), Error);
  back.truth.resize(3);
  EXPECT_THROW(read_truth_npy(bytes, back, "f"), Error) << "another number of points";
}

TEST(DatasetFiles, PosesAreInTheCameraFrame) {
  // The sensor 2 m above the origin, turned by 90 degrees to the left: in the camera's frame (x
  // right, y down, z forward) that is 2 m up (-y) and a turn about -y.
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation() = Eigen::Vector3d(0.5, 0.25, 2.0);
  T.linear() << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  EXPECT_EQ(poses_text({T}), "0 0 -1 -0.25 0 1 0 -2 1 0 0 0.5\n");
  EXPECT_EQ(calib_text().substr(calib_text().find("Tr")), "Tr: 0 -1 0 0 0 0 -1 0 1 0 0 0\n");
}

TEST(DatasetFiles, PosesReadBackToTheSameBits) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.rotate(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, -2, 3).normalized()));
  T.translation() = Eigen::Vector3d(0.1, -1.0 / 3.0, 1.7);
  const auto back =
      parse_poses(poses_text({T, Eigen::Isometry3d::Identity()}), calib_text(), "p", "c");
  ASSERT_EQ(back.size(), 2U);
  EXPECT_EQ(back[0].matrix(), T.matrix());
  EXPECT_EQ(parse_poses(poses_text({T}), "", "p", "c")[0].matrix(), T.matrix());
}

TEST(DatasetFiles, PosesOfARealDrive) {
  // Shape of KITTI's own files: exponents, a Tr that is a real calibration. velodyne pose = Tr^-1
  // pose Tr (point_labeler wiki).
  const std::string calib =
      "P0: 1 0 0 0 0 1 0 0 0 0 1 0\nTr: 4.276802385584e-04 -9.999672484946e-01 -8.084491683471e-03 "
      "-1.198459927713e-02 "
      "-7.210626507497e-03 8.081198471645e-03 -9.999413164504e-01 -5.403984729748e-02 "
      "9.999738645903e-01 4.859485810390e-04 -7.206933692422e-03 -2.921968648686e-01\n";
  const std::string poses = "1.000000e+00 0 0 0 0 1.0 0 0 0 0 1 0\r\n1 0 0 0 0 1 0 0 0 0 1 1.5\r\n";
  const auto back = parse_poses(poses, calib, "p", "c");
  ASSERT_EQ(back.size(), 2U);
  EXPECT_LT((back[0].matrix() - Eigen::Matrix4d::Identity()).norm(), 1e-9);
  EXPECT_NEAR(back[1].translation().x(), 1.5, 1e-3) << "forward is x of the sensor";
  EXPECT_NEAR(back[1].translation().norm(), 1.5, 1e-6);
}

TEST(DatasetFiles, BadPosesNameTheLine) {
  try {
    (void)parse_poses("1 0 0 0 0 1 0 0 0 0 1 0\n1 2 3\n", "", "poses.txt", "c");
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "poses.txt: line 2: a pose is not 12 numbers");
  }
  EXPECT_THROW((void)parse_poses("", "Tr: 1 2\n", "p", "c"), Error);
}

TEST(DatasetFiles, TimesAreSweepsOneAfterTheOther) {
  LidarOptions lidar;
  lidar.lines = 100;
  lidar.lines_per_second = 40.0;
  EXPECT_EQ(times_text(3, lidar), "0\n2.5\n5\n");
}

TEST(DatasetFiles, S3disHasOneFileAnInstance) {
  Scene scene;
  scene.materials = {{"wood"}};
  scene.materials[0].color = {10, 20, 30};
  for (int k = 0; k < 2; ++k) {
    Instance instance;
    instance.id = 300 + k;
    instance.class_id = *find_class("desk");
    instance.parts.push_back(box_part("top", 0, Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones()));
    scene.instances.push_back(instance);
  }
  Scan scan = small_scan();
  scan.truth.part[0] = 0;
  scan.T_world_sensor.translation() = Eigen::Vector3d(0, 0, 1);
  const auto files = s3dis_files(scene, {scan, scan}, "office_7");
  ASSERT_EQ(files.size(), 3U);
  EXPECT_EQ(files[0].first, "office_7/office_7.txt");
  EXPECT_EQ(files[0].second,
            "1.000 2.000 4.000 10 20 30\n4.000 5.000 7.000 0 0 0\n1.000 2.000 4.000 10 20 "
            "30\n4.000 5.000 7.000 0 0 0\n");
  EXPECT_EQ(files[1].first, "office_7/Annotations/clutter_0.txt");
  EXPECT_EQ(files[2].first, "office_7/Annotations/table_1.txt");
  EXPECT_EQ(files[2].second, "1.000 2.000 4.000 10 20 30\n1.000 2.000 4.000 10 20 30\n");
}

}  // namespace
}  // namespace scanchor
