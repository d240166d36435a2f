#include "cloud/xyz.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/cloud/support/clouds.hpp"

namespace scanchor {
namespace {
using testing::cloud_with_all_types;
using testing::data_error;
using testing::expect_same;

std::vector<std::string> names(const PointCloud& cloud) {
  std::vector<std::string> list;
  for (const auto& field : cloud.fields) list.push_back(field.name);
  return list;
}

TEST(Xyz, RoundTripKeepsTypesPosesAndOrganization) {
  for (const bool wide : {false, true}) {
    PointCloud cloud = cloud_with_all_types(wide);
    expect_same(parse_xyz(format_xyz(cloud, "f"), "f"), cloud);
    cloud.width = 25;
    cloud.height = 2;
    cloud.sensor_poses.push_back(Eigen::Isometry3d::Identity());
    expect_same(parse_xyz(format_xyz(cloud, "f"), "f"), cloud);
  }
  expect_same(parse_xyz(format_xyz(PointCloud{}, "f"), "f"), PointCloud{});
}

TEST(Xyz, WritesThisText) {
  PointCloud cloud;
  cloud.points = {{1.0, 2.0, -0.5}, {0.1, 0.0, 1e300}};
  cloud.set({"label", std::vector<std::uint8_t>{2, 3}});
  EXPECT_EQ(format_xyz(cloud, "f"),
            "# x y z label\n# types float64 float64 float64 uint8\n1 2 -0.5 2\n0.1 0 1e+300 3\n");
}

TEST(Xyz, OtherProgramsText) {
  const PointCloud s3dis = parse_xyz("-15.609 39.505 2.867 71 73 52\n1 2 3 255 0 0\n", "f");
  EXPECT_EQ(names(s3dis), (std::vector<std::string>{"red", "green", "blue"}));
  EXPECT_TRUE(std::holds_alternative<std::vector<std::uint8_t>>(s3dis.fields[0].values));
  const PointCloud csv = parse_xyz(
      "X,Y,Z,Classification,Gps\r\n1,2,3,7,1403715273.262\r\n4,5,6,8,1403715274.5\r\n", "f");
  EXPECT_EQ(names(csv), (std::vector<std::string>{"Classification", "Gps"}));
  EXPECT_TRUE(std::holds_alternative<std::vector<std::int32_t>>(csv.fields[0].values));
  EXPECT_EQ(csv.fields[1].at(0), 1403715273.262);
  const PointCloud compare = parse_xyz("//X Y Z Intensity\n1 2 3 0.5\n", "f");
  EXPECT_EQ(names(compare), (std::vector<std::string>{"Intensity"}));
  const PointCloud pts = parse_xyz("2\n1 2 3 -100 1 2 3\n1 2 3 -101 4 5 6\n", "f");
  EXPECT_EQ(names(pts), (std::vector<std::string>{"intensity", "red", "green", "blue"}));
  EXPECT_EQ(names(parse_xyz("1;2;3;4;5\n", "f")),
            (std::vector<std::string>{"column_4", "column_5"}));
  EXPECT_EQ(parse_xyz("\xEF\xBB\xBF# hello\n\n  1\t2\t3 # a remark\n", "f").points[0],
            Eigen::Vector3d(1, 2, 3));
  const PointCloud nan = parse_xyz("nan nan nan\n1 2 3", "f");
  EXPECT_TRUE(std::isnan(nan.points[0].x()));
  EXPECT_EQ(nan.size(), 2U);
}

TEST(Xyz, ColumnsWithNanStayReal) {
  const PointCloud cloud = parse_xyz("1 2 3 4\n1 2 3 nan\n", "f");
  EXPECT_TRUE(std::holds_alternative<std::vector<double>>(cloud.fields[0].values));
}

TEST(Xyz, ErrorsNameTheLine) {
  const auto error = [](const std::string& text) {
    return data_error([&] { (void)parse_xyz(text, "a.xyz"); });
  };
  EXPECT_EQ(error("# c\n1 2 3\n1 2\n"),
            "a.xyz: line 3: has fewer than the 3 columns of the lines before");
  EXPECT_EQ(error("1 2 3\n1 2 3 4\n"),
            "a.xyz: line 2: has more than the 3 columns of the lines before");
  EXPECT_EQ(error("1 2 3\n1 2 abc\n"), "a.xyz: line 2: 'abc' is no value for the column 'z'");
  EXPECT_EQ(error("1 2\n"), "a.xyz: line 1: has 2 columns, a point needs x, y and z");
  EXPECT_EQ(error("# nothing\n"), "a.xyz: holds no points");
  EXPECT_EQ(error("5\n1 2 3\n"), "a.xyz: expected 5 points, found 1; the file is truncated");
  EXPECT_EQ(error("hello world again\n"), "a.xyz: line 1: 'hello' is no value for the column 'x'");
}

TEST(Xyz, MutationsNeverCrash) {
  testing::expect_robust(format_xyz(cloud_with_all_types(false), "f"), 2000,
                         [](const std::string& bytes) { (void)parse_xyz(bytes, "f"); });
}

}  // namespace
}  // namespace scanchor
