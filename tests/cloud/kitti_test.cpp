#include "cloud/kitti.hpp"

#include <gtest/gtest.h>

#include "tests/cloud/support/clouds.hpp"

namespace scanchor {
namespace {
using testing::data_error;

TEST(Kitti, WritesTheseBytes) {
  PointCloud cloud;
  cloud.points = {{1.0, 2.0, -0.5}};
  EXPECT_EQ(format_kitti(cloud), std::string("\0\0\x80\x3f\0\0\0\x40\0\0\0\xbf\0\0\0\0", 16));
  cloud.set({"intensity", std::vector<double>{1.0}});
  cloud.set({"label", std::vector<std::int32_t>{258}});
  cloud.set({"instance", std::vector<std::uint16_t>{65535}});
  EXPECT_EQ(format_kitti(cloud).substr(12), std::string("\0\0\x80\x3f", 4));
  EXPECT_EQ(format_kitti_labels(cloud, "f"), std::string("\x02\x01\xff\xff", 4));
}

TEST(Kitti, RoundTripOfPositionsIntensityAndLabels) {
  PointCloud cloud = testing::cloud_with_all_types(false);
  for (auto& value : std::get<std::vector<std::int32_t>>(cloud.fields[2].values)) value &= 0xffff;
  PointCloud back = parse_kitti(format_kitti(cloud), "f");
  add_kitti_labels(back, format_kitti_labels(cloud, "f"), "f");
  ASSERT_EQ(back.size(), cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (i == 7) {
      EXPECT_TRUE(back.points[i].hasNaN());
    } else {
      EXPECT_EQ(back.points[i], cloud.points[i]);
    }
    for (const char* name : {"label", "instance"})
      EXPECT_EQ(back.find(name)->at(i), cloud.find(name)->at(i));
  }
  EXPECT_EQ(back.find("intensity")->at(1), cloud.find("intensity")->at(1));
}

TEST(Kitti, NegativeLabelsAreNoneAndLargeOnesAnError) {
  PointCloud cloud;
  cloud.points.resize(2);
  cloud.set({"label", std::vector<std::int32_t>{-1, 65536}});
  EXPECT_EQ(data_error([&] { (void)format_kitti_labels(cloud, "f"); }),
            "f: point 1: the label 65536 does not fit the 16 bits of a .label file");
  cloud.set({"label", std::vector<std::int32_t>{-1, 3}});
  EXPECT_EQ(format_kitti_labels(cloud, "f"), std::string("\0\0\0\0\x03\0\0\0", 8));
}

TEST(Kitti, FiveColumnsHaveARing) {
  const PointCloud cloud =
      parse_kitti(std::string(16, '\0') + std::string("\0\0\xe0\x40", 4), "f", 5);
  EXPECT_EQ(cloud.find("ring")->at(0), 7.0);
}

TEST(Kitti, SizesMustFit) {
  EXPECT_EQ(data_error([] { (void)parse_kitti(std::string(17, '\0'), "f"); }),
            "f: has 17 bytes, which is no multiple of the 16 of a point; the file is truncated or "
            "of another format");
  PointCloud cloud;
  cloud.points.resize(3);
  EXPECT_EQ(data_error([&] { add_kitti_labels(cloud, std::string(8, '\0'), "f"); }),
            "f: expected 12 bytes for the labels of 3 points, found 8");
}

}  // namespace
}  // namespace scanchor
