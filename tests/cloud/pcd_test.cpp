#include "cloud/pcd.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "cloud/lzf.hpp"
#include "tests/cloud/support/clouds.hpp"

namespace scanchor {
namespace {
using testing::cloud_with_all_types;
using testing::data_error;
using testing::expect_same;

constexpr PcdData kinds[] = {PcdData::ascii, PcdData::binary, PcdData::binary_compressed};

std::string header(const std::string& fields, const std::string& sizes, const std::string& types,
                   const std::string& counts, const std::string& width, const std::string& height,
                   const std::string& points, const std::string& data) {
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS " + fields + "\nSIZE " +
         sizes + "\nTYPE " + types + "\nCOUNT " + counts + "\nWIDTH " + width + "\nHEIGHT " +
         height + "\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + points + "\nDATA " + data + "\n";
}

std::string xyz_header(const std::string& points, const std::string& data) {
  return header("x y z", "4 4 4", "F F F", "1 1 1", points, "1", points, data);
}

TEST(Pcd, RoundTripOfEveryTypeInEveryKind) {
  for (const bool wide : {false, true}) {
    const PointCloud cloud = cloud_with_all_types(wide);
    for (const PcdData kind : kinds)
      expect_same(parse_pcd(format_pcd(cloud, kind, "f"), "f"), cloud);
  }
}

TEST(Pcd, RoundTripOfOrganizedManyPosesNoPoseAndNothing) {
  for (const PcdData kind : kinds) {
    PointCloud cloud = cloud_with_all_types(false);
    cloud.width = 10;
    cloud.height = 5;
    cloud.sensor_poses.push_back(Eigen::Isometry3d::Identity());
    expect_same(parse_pcd(format_pcd(cloud, kind, "f"), "f"), cloud);
    cloud.sensor_poses.clear();
    expect_same(parse_pcd(format_pcd(cloud, kind, "f"), "f"), cloud);
    expect_same(parse_pcd(format_pcd(PointCloud{}, kind, "f"), "f"), PointCloud{});
  }
}

TEST(Pcd, WritesTheseBytes) {
  PointCloud cloud;
  cloud.points = {{1.0, 2.0, -0.5}};
  cloud.set({"label", std::vector<std::uint16_t>{258}});
  EXPECT_EQ(format_pcd(cloud, PcdData::binary, "f"),
            std::string("# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z "
                        "label\nSIZE 4 4 4 2\n"
                        "TYPE F F F U\nCOUNT 1 1 1 1\nWIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA binary\n") +
                std::string("\0\0\x80\x3f\0\0\0\x40\0\0\0\xbf\x02\x01", 14));
  EXPECT_TRUE(format_pcd(cloud, PcdData::ascii, "f").ends_with("DATA ascii\n1 2 -0.5 258\n"));
}

TEST(Pcd, ReadsAllSizesOfIntegers) {
  const std::string text =
      header("x y z a b c d e f g h", "4 4 4 1 1 2 2 4 4 8 8", "F F F I U I U I U I U",
             "1 1 1 1 1 1 1 1 1 1 1", "1", "1", "1", "ascii") +
      "1 2 3 -1 255 -2 65535 -3 4294967295 -4 18446744073709551615\n";
  const PointCloud cloud = parse_pcd(text, "f");
  const double expected[] = {-1, 255, -2, 65535, -3, 4294967295, -4, 18446744073709551616.0};
  ASSERT_EQ(cloud.fields.size(), 8U);
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(cloud.fields[i].at(0), expected[i]) << i;
}

TEST(Pcd, FieldsWithACountBecomeNumberedFields) {
  const std::string text =
      header("x y z normal _", "4 4 4 4 1", "F F F F U", "1 1 1 3 4", "2", "1", "2", "binary") +
      std::string(2 * (12 + 12 + 4), '\0');
  const PointCloud cloud = parse_pcd(text, "f");
  ASSERT_EQ(cloud.fields.size(), 3U) << "padding is no field";
  EXPECT_EQ(cloud.fields[2].name, "normal_2");
}

TEST(Pcd, PaddingStandsBetweenFields) {
  std::string record("\0\0\x80\x3f", 4);                         // x = 1
  record += std::string("abcd") + std::string("\0\0\0\x40", 4);  // padding, y = 2
  record += std::string("\0\0\x40\x40", 4) + "xx";               // z = 3, padding
  const std::string text =
      header("x _ y z _", "4 1 4 4 1", "F U F F U", "1 4 1 1 2", "2", "1", "2", "binary") + record +
      record;
  EXPECT_EQ(parse_pcd(text, "f").points[1], Eigen::Vector3d(1, 2, 3));
}

TEST(Pcd, CompressedPaddingMayBeLeftOutOrNot) {
  const std::string columns = std::string("\0\0\x80\x3f", 4) + std::string("\0\0\0\x40", 4) +
                              std::string("\0\0\x40\x40", 4);
  for (const std::string& plain :
       {columns, std::string("\0\0\x80\x3f", 4) + "abcd" + columns.substr(4)}) {
    const std::string packed = lzf_compress(plain);
    std::string text =
        header("x _ y z", "4 1 4 4", "F U F F", "1 4 1 1", "1", "1", "1", "binary_compressed");
    text += std::string{static_cast<char>(packed.size()), 0, 0, 0,
                        static_cast<char>(plain.size()),  0, 0, 0};
    EXPECT_EQ(parse_pcd(text + packed, "f").points[0], Eigen::Vector3d(1, 2, 3));
  }
}

TEST(Pcd, OldAndForeignHeaders) {
  EXPECT_EQ(parse_pcd("COLUMNS x y z\nPOINTS 1\nDATA ascii\n1 2 3\n", "f").points[0],
            Eigen::Vector3d(1, 2, 3));
  const std::string windows =
      "# .PCD v.7\r\nVERSION .7\r\nFIELDS z y x\r\nSIZE 4 4 4\r\nTYPE F F F\r\nWIDTH 1\r\nHEIGHT "
      "1\r\n"
      "POINTS 1\r\nDATA ascii\r\n1 2 nan\r\n\r\n";
  const PointCloud cloud = parse_pcd(windows, "f");
  EXPECT_EQ(cloud.points[0].z(), 1.0);
  EXPECT_TRUE(std::isnan(cloud.points[0].x()));
  EXPECT_TRUE(cloud.sensor_poses.empty()) << "no VIEWPOINT: not known";
  EXPECT_TRUE(looks_like_pcd(windows));
  EXPECT_FALSE(looks_like_pcd("1 2 3\n"));
}

TEST(Pcd, ViewpointIsThePoseOfTheSensor) {
  std::string text = xyz_header("1", "ascii") + "0 0 0\n";
  text.replace(text.find("0 0 0 1 0 0 0"), 13, "1 2 3 0 0 0 1");
  const PointCloud cloud = parse_pcd(text, "f");
  ASSERT_EQ(cloud.sensor_poses.size(), 1U);
  EXPECT_LT((cloud.sensor_poses[0] * Eigen::Vector3d(1, 0, 0) - Eigen::Vector3d(0, 2, 3)).norm(),
            1e-15);
  text.replace(text.find("1 2 3 0 0 0 1"), 13, "0 0 0 0 0 0 0");
  EXPECT_TRUE(parse_pcd(text, "f").sensor_poses.empty()) << "a quaternion of zeros is no rotation";
}

TEST(Pcd, TruncationSaysWhatWasExpectedAndFound) {
  const std::string binary = xyz_header("10", "binary") + std::string(119, '\0');
  EXPECT_EQ(
      data_error([&] { (void)parse_pcd(binary, "a.pcd"); }),
      "a.pcd: expected 120 bytes of points after the header, found 119; the file is truncated");
  EXPECT_EQ(data_error([&] {
              (void)parse_pcd(xyz_header("3", "ascii") + "1 2 3\n4.00000 5.0000 6.0000\n", "a.pcd");
            }),
            "a.pcd: expected 3 points, found 2; the file is truncated");
  const std::string packed =
      format_pcd(cloud_with_all_types(false), PcdData::binary_compressed, "f");
  EXPECT_NE(data_error([&] {
              (void)parse_pcd(packed.substr(0, packed.size() - 5), "f");
            }).find("bytes of compressed data, found"),
            std::string::npos);
  EXPECT_EQ(data_error([&] { (void)parse_pcd("VERSION .7\nFIELDS x y z\n", "f"); }),
            "f: header: ends before its DATA line; the file is truncated");
}

TEST(Pcd, ContradictionsInTheHeader) {
  const auto error = [](const std::string& text) {
    return data_error([&] { (void)parse_pcd(text, "f"); });
  };
  EXPECT_EQ(error(header("x y z", "4 4", "F F F", "1 1 1", "1", "1", "1", "ascii")),
            "f: header: FIELDS names 3 fields, but SIZE has 2 entries");
  EXPECT_EQ(error(header("x y z", "4 4 4", "F F F", "1 1 1", "5", "2", "9", "ascii")),
            "f: header: WIDTH 5 x HEIGHT 2 is not POINTS 9");
  EXPECT_EQ(error(header("x y z", "4 4 2", "F F F", "1 1 1", "1", "1", "1", "ascii")),
            "f: header: field 'z' has TYPE F and SIZE 2, which do not go together");
  EXPECT_EQ(error(header("x y w", "4 4 4", "F F F", "1 1 1", "0", "1", "0", "ascii")),
            "f: header: has no field 'z'; a point needs x, y and z");
  EXPECT_EQ(error(header("x y z", "4 4 4", "F F F", "1 1 0", "1", "1", "1", "ascii")),
            "f: header: field 'z' has COUNT 0");
  EXPECT_EQ(error(header("x y z", "4 4 4", "F F F", "1 1 1", "ten", "1", "1", "ascii")),
            "f: line 7: WIDTH 'ten' is not a whole number");
  EXPECT_NE(error(xyz_header("1", "zipped")).find("line 11: DATA 'zipped' is unknown"),
            std::string::npos);
  EXPECT_NE(error(xyz_header("1", "ascii") + "1 2 x\n")
                .find("line 12: 'x' is no value for the field 'z'"),
            std::string::npos);
  EXPECT_NE(
      error(xyz_header("1", "ascii") + "1 2      \n").find("line 12: has fewer than 3 values"),
      std::string::npos);
  EXPECT_NE(error(xyz_header("1", "ascii") + "1 2 3 4\n").find("line 12: has more than 3 values"),
            std::string::npos);
  EXPECT_NE(error(xyz_header("1", "ascii") + "1 2 3\n1 2 3\n").find("more lines than the 1 points"),
            std::string::npos);
}

TEST(Pcd, AbsurdCountsAreNotBelieved) {
  for (const char* kind : {"ascii", "binary", "binary_compressed"}) {
    for (const char* count : {"1000000000000000000", "18446744073709551615", "4000000000"}) {
      (void)data_error(
          [&] { (void)parse_pcd(xyz_header(count, kind) + std::string(100, '1'), "f"); });
    }
  }
  (void)data_error([] {
    (void)parse_pcd(
        header("x y z h", "4 4 4 4", "F F F F", "1 1 1 4000000000", "1", "1", "1", "binary"), "f");
  });
  std::string bomb = xyz_header("357913941", "binary_compressed");
  bomb += std::string{8,
                      0,
                      0,
                      0,
                      static_cast<char>(0xfc),
                      static_cast<char>(0xff),
                      static_cast<char>(0xff),
                      static_cast<char>(0xff)};
  EXPECT_NE(
      data_error([&] { (void)parse_pcd(bomb + std::string(8, '\0'), "f"); }).find("cannot hold"),
      std::string::npos);
}

TEST(Pcd, MutationsNeverCrash) {
  for (const PcdData kind : kinds) {
    testing::expect_robust(format_pcd(cloud_with_all_types(false), kind, "f"), 2000,
                           [](const std::string& bytes) { (void)parse_pcd(bytes, "f"); });
  }
}

}  // namespace
}  // namespace scanchor
