#include "sensors/scan.hpp"

#include <gtest/gtest.h>

namespace scanchor {
namespace {

Scan labelled_scan() {
  Scan scan;
  scan.cloud.points = {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  scan.cloud.set({"intensity", std::vector<float>{0.1F, 0.2F, 0.3F}});
  scan.truth.resize(3);
  scan.truth.class_id = {4, 5, 6};
  scan.truth.instance = {7, 8, -1};
  scan.truth.flags = {0, point_mixed, point_ghost | point_mixed};
  scan.truth.true_range = {1.01F, 2.02F, 3.03F};
  scan.line = {0, 0, 1};
  scan.beam = {5, 6, 5};
  return scan;
}

TEST(Scan, TruthTravelsAsFieldsAndComesBack) {
  const Scan scan = labelled_scan();
  const PointCloud cloud = cloud_with_truth(scan);
  ASSERT_NE(cloud.find("label"), nullptr);
  EXPECT_TRUE(std::holds_alternative<std::vector<std::uint32_t>>(cloud.find("label")->values))
      << "PCL's readers take the field for a label only as uint32";
  EXPECT_EQ(cloud.find("label")->at(1), 5.0);
  EXPECT_EQ(cloud.fields.size(), 11U);
  const Scan back = scan_from_cloud(cloud);
  EXPECT_EQ(back.truth.class_id, scan.truth.class_id);
  EXPECT_EQ(back.truth.instance, scan.truth.instance);
  EXPECT_EQ(back.truth.flags, scan.truth.flags);
  EXPECT_EQ(back.truth.true_range, scan.truth.true_range);
  EXPECT_EQ(back.line, scan.line);
  EXPECT_EQ(back.beam, scan.beam);
  ASSERT_EQ(back.cloud.fields.size(), 1U) << "the truth is not left in the cloud";
  EXPECT_EQ(back.cloud.fields[0].name, "intensity");
}

TEST(Scan, ACloudWithoutTruthHasNone) {
  PointCloud cloud;
  cloud.points = {{1, 0, 0}};
  const Scan scan = scan_from_cloud(cloud);
  EXPECT_EQ(scan.truth.class_id[0], 0);
  EXPECT_EQ(scan.truth.instance[0], -1);
  EXPECT_EQ(scan.line[0], -1);
}

}  // namespace
}  // namespace scanchor
