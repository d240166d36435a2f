#include "cloud/ply.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/cloud/support/clouds.hpp"

namespace scanchor {
namespace {
using testing::cloud_with_all_types;
using testing::data_error;
using testing::expect_same;

constexpr PlyData ply_kinds[] = {PlyData::ascii, PlyData::little_endian, PlyData::big_endian};

std::string header(const std::string& format, const std::string& rest) {
  return "ply\nformat " + format + " 1.0\n" + rest + "end_header\n";
}
const std::string xyz = "property float x\nproperty float y\nproperty float z\n";

TEST(Ply, RoundTripOfEveryTypeInEveryKind) {
  for (const bool wide : {false, true}) {
    PointCloud cloud = cloud_with_all_types(wide);
    for (const PlyData kind : ply_kinds) {
      expect_same(parse_ply(format_ply(cloud, kind, "f"), "f"), cloud);
      PointCloud grid = cloud;
      grid.width = 5;
      grid.height = 10;
      grid.sensor_poses.push_back(grid.sensor_poses.front());
      expect_same(parse_ply(format_ply(grid, kind, "f"), "f"), grid);
      expect_same(parse_ply(format_ply(PointCloud{}, kind, "f"), "f"), PointCloud{});
    }
  }
}

TEST(Ply, WritesTheseBytes) {
  PointCloud cloud;
  cloud.points = {{1.0, 2.0, -0.5}};
  cloud.set({"label", std::vector<std::int32_t>{258}});
  const std::string properties = "element vertex 1\n" + xyz + "property int label\n";
  EXPECT_EQ(format_ply(cloud, PlyData::little_endian, "f"),
            header("binary_little_endian", properties) +
                std::string("\0\0\x80\x3f\0\0\0\x40\0\0\0\xbf\x02\x01\0\0", 16));
  EXPECT_EQ(format_ply(cloud, PlyData::big_endian, "f"),
            header("binary_big_endian", properties) +
                std::string("\x3f\x80\0\0\x40\0\0\0\xbf\0\0\0\0\0\x01\x02", 16));
  EXPECT_EQ(format_ply(cloud, PlyData::ascii, "f"), header("ascii", properties) + "1 2 -0.5 258\n");
}

TEST(Ply, AllNamesOfTypes) {
  for (const char* type :
       {"char", "int8", "uchar", "uint8", "short", "int16", "ushort", "uint16", "int", "int32",
        "uint", "uint32", "int64", "uint64", "float", "float32", "double", "float64"}) {
    const std::string text =
        header("ascii", "element vertex 1\n" + xyz + "property " + type + " a\n") + "1 2 3 101\n";
    EXPECT_EQ(parse_ply(text, "f").fields.at(0).at(0), 101.0) << type;
  }
}

TEST(Ply, FacesAfterAndListsBeforeOrWithinAreSkipped) {
  const std::string list = "property list uchar int vertex_indices\n";
  const std::string elements =
      "comment made by hand\nelement face 2\n" + list + "property uchar flags\nelement vertex 2\n" +
      xyz +
      "property list ushort float weights\nproperty uchar red\nelement edge 1\nproperty int a\n";
  const PointCloud text = parse_ply(
      header("ascii", elements) + "3 0 1 2 9\n0 9\n1 2 3 2 0.5 0.5 200\n4 5 6 0 100\n7\n", "f");
  ASSERT_EQ(text.size(), 2U);
  EXPECT_EQ(text.points[1], Eigen::Vector3d(4, 5, 6));
  ASSERT_EQ(text.fields.size(), 1U);
  EXPECT_EQ(text.find("red")->at(0), 200.0);

  const std::string one("\x3f\x80\0\0", 4), two("\x40\0\0\0", 4), three("\x40\x40\0\0", 4);
  std::string body = std::string("\x01", 1) + std::string(4, '\0') + "\x09" +
                     std::string("\0\x09", 2);  // two faces
  body += one + two + three + std::string("\0\x02", 2) + one + two +
          "\xc8";  // vertex with a list of two
  body += three + two + one + std::string("\0\0", 2) + "\x64";
  const PointCloud binary = parse_ply(header("binary_big_endian", elements) + body, "f");
  ASSERT_EQ(binary.size(), 2U);
  EXPECT_EQ(binary.points[1], Eigen::Vector3d(3, 2, 1));
  EXPECT_EQ(binary.find("red")->at(0), 200.0);
  EXPECT_EQ(binary.find("red")->at(1), 100.0);
}

TEST(Ply, WindowsLineEndsInABinaryFile) {
  std::string text = header("binary_little_endian", "element vertex 1\n" + xyz);
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2)
    text.insert(at, "\r");
  EXPECT_EQ(parse_ply(text + std::string("\0\0\x80\x3f\0\0\0\x40\0\0\x40\x40", 12), "f").points[0],
            Eigen::Vector3d(1, 2, 3));
}

TEST(Ply, TruncationSaysWhatWasExpectedAndFound) {
  EXPECT_EQ(data_error([] {
              (void)parse_ply(header("binary_little_endian", "element vertex 3\n" + xyz) +
                                  std::string(35, '\0'),
                              "a.ply");
            }),
            "a.ply: expected 36 bytes of the element 'vertex', found 35; the file is truncated");
  EXPECT_EQ(data_error([] {
              (void)parse_ply(
                  header("ascii", "element vertex 3\n" + xyz) + "1 2 3\n4.00000 5.000000 6\n",
                  "a.ply");
            }),
            "a.ply: expected 3 lines of the element 'vertex', found 2; the file is truncated");
  EXPECT_EQ(data_error([] { (void)parse_ply("ply\nformat ascii 1.0\nelement vertex 3\n", "f"); }),
            "f: header: ends before end_header; the file is truncated");
  const std::string lists = "element face 1\nproperty list uint double a\nelement vertex 0\n" + xyz;
  EXPECT_NE(data_error([&] {
              (void)parse_ply(header("binary_little_endian", lists) + std::string(4, '\xff'), "f");
            }).find("ends within the element 'face'"),
            std::string::npos);
}

TEST(Ply, ErrorsInTheHeader) {
  const auto error = [](const std::string& text) {
    return data_error([&] { (void)parse_ply(text, "f"); });
  };
  EXPECT_NE(error("plyx\n").find("f: line 1: "), std::string::npos);
  EXPECT_NE(error(header("binary_middle_endian", "element vertex 1\n" + xyz))
                .find("line 2: format 'binary_middle_endian'"),
            std::string::npos);
  EXPECT_NE(error("ply\nelement vertex 1\n" + xyz + "end_header\n1 2 3\n").find("no format line"),
            std::string::npos);
  EXPECT_NE(error(header("ascii", "element vertex many\n" + xyz))
                .find("line 3: 'many' is not a number of elements"),
            std::string::npos);
  EXPECT_NE(
      error(header("ascii", "property float x\n")).find("line 3: a property before any element"),
      std::string::npos);
  EXPECT_NE(error(header("ascii", "element vertex 1\nproperty real x\n"))
                .find("line 4: 'real' is not a type"),
            std::string::npos);
  EXPECT_NE(error(header("ascii", "element vertex 1\nproperty float\n")).find("without a name"),
            std::string::npos);
  EXPECT_NE(error(header("ascii", "element point 1\n" + xyz)).find("has no element 'vertex'"),
            std::string::npos);
  EXPECT_NE(error(header("ascii", "element vertex 0\nproperty float x\n")).find("has no field 'y'"),
            std::string::npos);
  EXPECT_NE(error(header("ascii", "elment vertex 0\n")).find("unknown keyword 'elment'"),
            std::string::npos);
  EXPECT_NE(error(header("ascii", "element vertex 1\n" + xyz) + "1 2 abc\n")
                .find("line 8: 'abc' is no value for the property 'z'"),
            std::string::npos);
  EXPECT_NE(error(header("ascii", "element vertex 1\n" + xyz) + "1 2     \n")
                .find("line 8: has fewer values"),
            std::string::npos);
  EXPECT_NE(error(header("ascii", "element vertex 1\n" + xyz) + "1 2 3 4\n")
                .find("line 8: has more values"),
            std::string::npos);
}

TEST(Ply, AbsurdCountsAreNotBelieved) {
  for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    for (const char* count : {"1000000000000000000", "18446744073709551615", "4000000000"}) {
      const std::string number = count;
      (void)data_error([&] {
        (void)parse_ply(header(format, "element vertex " + number + "\n" + xyz) + "1 2 3\n", "f");
      });
      (void)data_error([&] {
        (void)parse_ply(header(format, "element face " + number +
                                           "\nproperty list int int a\nelement vertex 1\n" + xyz) +
                            "1 2 3\n",
                        "f");
      });
    }
  }
}

TEST(Ply, MutationsNeverCrash) {
  for (const PlyData kind : ply_kinds) {
    testing::expect_robust(format_ply(cloud_with_all_types(false), kind, "f"), 2000,
                           [](const std::string& bytes) { (void)parse_ply(bytes, "f"); });
  }
}

}  // namespace
}  // namespace scanchor
