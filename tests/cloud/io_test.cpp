#include "cloud/io.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "core/error.hpp"
#include "core/file.hpp"
#include "tests/cloud/support/clouds.hpp"

namespace scanchor {
namespace {
namespace fs = std::filesystem;
using testing::cloud_with_all_types;
using testing::data_error;
using testing::expect_same;

class CloudFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(::testing::TempDir()) /
              ("scanchor_io_" +
               std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path folder_;
};

PointCloud finite_cloud() {
  PointCloud cloud = cloud_with_all_types(false);
  for (auto& p : cloud.points) {
    if (!p.allFinite()) p = {1.0, 2.0, 3.0};
  }
  auto& f32 = std::get<std::vector<float>>(cloud.fields[0].values);
  f32[2] = 0.5F;  // NaN has more than one bit pattern
  auto& label = std::get<std::vector<std::int32_t>>(cloud.fields[2].values);
  for (auto& v : label) v &= 0x7fff;
  return cloud;
}

TEST_F(CloudFiles, RoundTripByEnding) {
  const PointCloud cloud = cloud_with_all_types(true);
  for (const char* name : {"a.pcd", "a.PLY", "a.xyz", "a.txt"}) {
    write_cloud(folder_ / name, cloud);
    expect_same(read_cloud(folder_ / name), cloud);
  }
  write_cloud(folder_ / "b.pcd", cloud, CloudFormat::pcd_binary_compressed);
  write_cloud(folder_ / "b.ply", cloud, CloudFormat::ply_ascii);
  write_cloud(folder_ / "c.pcd", cloud, CloudFormat::pcd_ascii);
  for (const char* name : {"b.pcd", "b.ply", "c.pcd"})
    expect_same(read_cloud(folder_ / name), cloud);
}

TEST_F(CloudFiles, ContentDecidesBeforeTheEnding) {
  const PointCloud cloud = cloud_with_all_types(false);
  write_cloud(folder_ / "ply.txt", cloud, CloudFormat::ply_binary);
  write_cloud(folder_ / "pcd.dat", cloud, CloudFormat::pcd_ascii);
  expect_same(read_cloud(folder_ / "ply.txt"), cloud);
  expect_same(read_cloud(folder_ / "pcd.dat"), cloud);
}

TEST_F(CloudFiles, KittiLabelsLieBesideOrInTheirFolder) {
  const PointCloud cloud = finite_cloud();
  fs::create_directories(folder_ / "sequences" / "00" / "velodyne");
  const fs::path bin = folder_ / "sequences" / "00" / "velodyne" / "000000.bin";
  write_cloud(bin, cloud);
  EXPECT_TRUE(fs::exists(folder_ / "sequences" / "00" / "labels" / "000000.label"));
  EXPECT_EQ(read_cloud(bin).find("label")->at(3), cloud.find("label")->at(3));
  write_cloud(folder_ / "a.bin", cloud);
  EXPECT_TRUE(fs::exists(folder_ / "a.label"));
  EXPECT_EQ(read_cloud(folder_ / "a.bin").find("instance")->at(3), cloud.find("instance")->at(3));
  fs::remove(folder_ / "a.label");
  EXPECT_EQ(read_cloud(folder_ / "a.bin").find("label"), nullptr);
  write_file(folder_ / "n.pcd.bin", std::string(40, '\0'));
  EXPECT_EQ(read_cloud(folder_ / "n.pcd.bin").size(), 2U) << "nuScenes has five columns";
}

TEST_F(CloudFiles, ErrorsNameTheFile) {
  const auto error = [&](const char* name, const std::string& content) {
    write_file(folder_ / name, content);
    const std::string line = data_error([&] { (void)read_cloud(folder_ / name); });
    EXPECT_TRUE(line.starts_with((folder_ / name).string())) << line;
    return line;
  };
  EXPECT_NE(error("a.pcd", "").find("is empty"), std::string::npos);
  EXPECT_NE(error("a.ply", "solid\n").find("begins with the line 'ply'"), std::string::npos);
  EXPECT_NE(error("a.las", "LASF\x01\x02").find("unknown format; known are: .pcd"),
            std::string::npos);
  EXPECT_NE(error("noending", std::string("\x7f"
                                          "ELF\0",
                                          5))
                .find("unknown format"),
            std::string::npos);
  EXPECT_NE(error("a.label", "1234").find("holds labels, not points"), std::string::npos);
  EXPECT_NE(data_error([&] { (void)read_cloud(folder_ / "none.pcd"); }).find("cannot be opened"),
            std::string::npos);
  EXPECT_NE(data_error([&] {
              write_cloud(folder_ / "no" / "a.pcd", cloud_with_all_types(false));
            }).find("cannot be written"),
            std::string::npos);
  EXPECT_THROW(write_cloud(folder_ / "a.las", PointCloud{}), Error);
  EXPECT_FALSE(fs::exists(folder_ / "no"));
}

// ---- Independent readers: what we write is what others read.
// ---------------------------------------------------------------

/// "name type sha256" of each column, the hash over the values as little-endian doubles; what
/// support/read_cloud.py prints.
std::string columns_line(const std::string& name, const std::string& type,
                         const std::vector<double>& values) {
  std::string bytes(8 * values.size(), '\0');
  std::memcpy(bytes.data(), values.data(), bytes.size());
  return name + " " + type + " " + sha256(bytes) + "\n";
}

std::string columns_of_cloud(const PointCloud& cloud, const std::string& position) {
  static const char* types[] = {"f4", "f8", "i4", "u4", "u2", "u1"};
  std::string text;
  for (int k = 0; k < 3; ++k) {
    std::vector<double> values;
    for (const auto& p : cloud.points) values.push_back(p[k]);
    text += columns_line(std::string(1, static_cast<char>('x' + k)), position, values);
  }
  for (const auto& field : cloud.fields) {
    std::vector<double> values;
    for (std::size_t i = 0; i < cloud.size(); ++i) values.push_back(field.at(i));
    text += columns_line(field.name, types[field.values.index()], values);
  }
  return text;
}

/// A reader of forty lines that shares no code with the project's: little-endian binary PCD and PLY
/// by a fixed list of types.
std::string read_binary(const std::string& bytes, const std::string& body_mark,
                        const std::vector<std::string>& names,
                        const std::vector<std::string>& types, std::size_t count) {
  std::size_t at = bytes.find(body_mark) + body_mark.size();
  std::vector<std::vector<double>> columns(names.size());
  const auto number = [&](const std::string& type) {
    const auto size = static_cast<std::size_t>(type[1] - '0');
    std::uint64_t raw = 0;
    for (std::size_t k = size; k-- > 0;)
      raw = raw * 256 + static_cast<unsigned char>(bytes.at(at + k));
    at += size;
    if (type == "f4")
      return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(raw)));
    if (type == "f8") return std::bit_cast<double>(raw);
    if (type == "i4") return static_cast<double>(static_cast<std::int32_t>(raw));
    return static_cast<double>(raw);
  };
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t c = 0; c < names.size(); ++c) columns[c].push_back(number(types[c]));
  }
  EXPECT_EQ(at, bytes.size());
  std::string text;
  for (std::size_t c = 0; c < names.size(); ++c)
    text += columns_line(names[c], types[c], columns[c]);
  return text;
}

TEST_F(CloudFiles, ASecondReaderInThisTestReadsTheSame) {
  const PointCloud cloud = finite_cloud();
  const std::vector<std::string> names = {"x",     "y",    "z",        "intensity", "time",
                                          "label", "rgba", "instance", "flags"};
  const std::vector<std::string> types = {"f4", "f4", "f4", "f4", "f8", "i4", "u4", "u2", "u1"};
  write_cloud(folder_ / "a.pcd", cloud);
  write_cloud(folder_ / "a.ply", cloud);
  EXPECT_EQ(read_binary(read_file(folder_ / "a.pcd"), "DATA binary\n", names, types, cloud.size()),
            columns_of_cloud(cloud, "f4"));
  EXPECT_EQ(read_binary(read_file(folder_ / "a.ply"), "end_header\n", names, types, cloud.size()),
            columns_of_cloud(cloud, "f4"));
}

/// Output of a command, or nothing if it fails.
std::optional<std::string> output_of(const std::string& command) {
  std::FILE* pipe = ::popen((command + " 2>/dev/null").c_str(), "r");
  if (pipe == nullptr) return std::nullopt;
  std::string text;
  std::array<char, 4096> buffer;
  for (std::size_t n; (n = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
    text.append(buffer.data(), n);
  if (::pclose(pipe) != 0) return std::nullopt;
  return text;
}

/// A Python that has numpy; where there is none, the reader above is the independent one.
std::string python_with_numpy() {
  for (const char* python : {"python3", "/usr/bin/python3"}) {
    if (output_of(std::string(python) + " -c 'import numpy'")) return python;
  }
  return "";
}

TEST_F(CloudFiles, NumpyReadsTheSame) {
  const std::string python = python_with_numpy();
  RecordProperty("independent_reader", python.empty() ? "C++ only" : "numpy");
  if (python.empty()) {
    std::printf(
        "no Python with numpy here: ASecondReaderInThisTestReadsTheSame is the independent "
        "reader\n");
    return;
  }
  const std::string read =
      python + " '" + SCANCHOR_SOURCE_DIR + "/tests/cloud/support/read_cloud.py' ";
  const auto quoted = [&](const char* name) { return "'" + (folder_ / name).string() + "' "; };
  const PointCloud cloud = finite_cloud();
  PointCloud wide = cloud;
  wide.points[0].x() = 0.1;
  write_cloud(folder_ / "a.pcd", cloud);
  write_cloud(folder_ / "b.pcd", wide, CloudFormat::pcd_ascii);
  write_cloud(folder_ / "a.ply", wide);
  write_cloud(folder_ / "b.ply", cloud, CloudFormat::ply_ascii);
  write_cloud(folder_ / "a.bin", cloud);
  EXPECT_EQ(output_of(read + quoted("a.pcd")), columns_of_cloud(cloud, "f4"));
  EXPECT_EQ(output_of(read + quoted("b.pcd")), columns_of_cloud(wide, "f8"));
  EXPECT_EQ(output_of(read + quoted("a.ply")), columns_of_cloud(wide, "f8"));
  EXPECT_EQ(output_of(read + quoted("b.ply")), columns_of_cloud(cloud, "f4"));
  PointCloud kitti = cloud;
  kitti.fields.clear();
  kitti.set(*cloud.find("intensity"));
  std::vector<std::uint16_t> label;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    label.push_back(static_cast<std::uint16_t>(cloud.find("label")->at(i)));
  kitti.set({"label", label});
  kitti.set(*cloud.find("instance"));
  EXPECT_EQ(output_of(read + quoted("a.bin") + quoted("a.label")), columns_of_cloud(kitti, "f4"));
}

// ---- Real files of other programs, where they are at hand.
// -------------------------------------------------------------------

struct RealFile {
  const char* path;
  std::size_t points, finite;
  int width, height;
  std::vector<std::string> fields;
};

class RealClouds : public ::testing::TestWithParam<RealFile> {};

TEST_P(RealClouds, AreRead) {
  const RealFile& expected = GetParam();
  const fs::path path = fs::path(SCANCHOR_SHARED_DATA) / expected.path;
  if (!fs::exists(path)) GTEST_SKIP() << "no " << expected.path << " here";
  const PointCloud cloud = read_cloud(path);
  EXPECT_EQ(cloud.size(), expected.points);
  EXPECT_EQ(cloud.width, expected.width);
  EXPECT_EQ(cloud.height, expected.height);
  std::vector<std::string> names;
  for (const auto& field : cloud.fields) names.push_back(field.name);
  EXPECT_EQ(names, expected.fields);
  std::size_t finite = 0;
  Eigen::AlignedBox3d box;
  for (const auto& p : cloud.points) {
    if (!p.allFinite()) continue;
    ++finite;
    box.extend(p);
  }
  if (expected.finite > 0) {
    EXPECT_EQ(finite, expected.finite);
  }
  EXPECT_GT(finite, cloud.size() / 2);
  EXPECT_LT(box.sizes().maxCoeff(), 60.0) << "rooms, in metres";
  EXPECT_GT(box.sizes().minCoeff(), 0.5);
}

INSTANTIATE_TEST_SUITE_P(
    SharedData, RealClouds,
    ::testing::Values(RealFile{"office_laser/room_scan1.pcd", 112586, 112586, 0, 0, {}},
                      RealFile{"apartment_laser/cloud_0.ply", 36674, 36674, 0, 0, {}},
                      RealFile{"office_kinect/office1.pcd", 307200, 0, 640, 480, {"rgb"}},
                      RealFile{"plane_bench/test_100.pcd", 10000, 10000, 100, 100, {"intensity"}}),
    [](const auto& test) {
      std::string name = test.param.path;
      return name.substr(0, name.find('/'));
    });

}  // namespace
}  // namespace scanchor
