#include "cloud/io.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "cloud/kitti.hpp"
#include "cloud/pcd.hpp"
#include "cloud/ply.hpp"
#include "cloud/xyz.hpp"
#include "core/error.hpp"
#include "core/file.hpp"

namespace scanchor {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view known_endings =
    "known are: .pcd, .ply, .xyz, .txt, .csv, .asc, .pts, .bin";

std::string ending(const fs::path& path) {
  std::string text = path.extension().string();
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

bool is_text_ending(const std::string& end) {
  return end == ".xyz" || end == ".txt" || end == ".csv" || end == ".asc" || end == ".pts" ||
         end == ".xyzrgb" || end == ".xyzn";
}

bool looks_like_text(std::string_view content) {
  const std::string_view head = content.substr(0, 1024);
  return std::all_of(head.begin(), head.end(), [](char c) {
    return (c >= ' ' && c <= '~') || c == '\n' || c == '\r' || c == '\t';
  });
}

/// Where the labels of velodyne/NAME.bin are: ../labels/NAME.label, else NAME.label beside it.
fs::path label_path(const fs::path& bin, bool for_writing) {
  const fs::path name = fs::path(bin.stem()).concat(".label");
  const fs::path below = bin.parent_path().parent_path() / "labels" / name;
  const fs::path beside = bin.parent_path() / name;
  if (for_writing) return bin.parent_path().filename() == "velodyne" ? below : beside;
  std::error_code ignored;
  return fs::exists(below, ignored) && bin.parent_path().filename() == "velodyne" ? below : beside;
}

PointCloud read_kitti(const fs::path& path, const std::string& content) {
  const bool nuscenes = ending(path.stem()) == ".pcd";
  PointCloud cloud = parse_kitti(content, path.string(), nuscenes ? 5 : 4);
  const fs::path labels = label_path(path, false);
  std::error_code ignored;
  if (fs::exists(labels, ignored)) add_kitti_labels(cloud, read_file(labels), labels.string());
  return cloud;
}

void write_kitti(const fs::path& path, const PointCloud& cloud) {
  if (cloud.find("label") != nullptr || cloud.find("instance") != nullptr) {
    const fs::path labels = label_path(path, true);
    const std::string bytes = format_kitti_labels(cloud, labels.string());
    if (labels.parent_path() != path.parent_path()) make_folder(labels.parent_path());
    write_file(labels, bytes);
  }
  write_file(path, format_kitti(cloud));
}

}  // namespace

PointCloud read_cloud(const fs::path& path) {
  const std::string content = read_file(path);
  const std::string file = path.string();
  const std::string end = ending(path);
  if (content.empty()) fail_data(file, "", "is empty, a point cloud was expected");
  if (content.starts_with("ply\n") || content.starts_with("ply\r\n"))
    return parse_ply(content, file);
  if (end == ".bin") return read_kitti(path, content);
  if (end == ".pcd" || looks_like_pcd(content)) return parse_pcd(content, file);
  if (end == ".ply") fail_data(file, "line 1", "a PLY file begins with the line 'ply'");
  if (end == ".label") {
    fail_data(file, "", "holds labels, not points",
              "give the .bin file, its labels are found beside it");
  }
  if (is_text_ending(end) || (end.empty() && looks_like_text(content)))
    return parse_xyz(content, file);
  fail_data(file, "", "is of an unknown format", known_endings);
}

void write_cloud(const fs::path& path, const PointCloud& cloud) {
  const std::string end = ending(path);
  if (end == ".pcd") return write_cloud(path, cloud, CloudFormat::pcd_binary);
  if (end == ".ply") return write_cloud(path, cloud, CloudFormat::ply_binary);
  if (end == ".bin") return write_cloud(path, cloud, CloudFormat::kitti_bin);
  if (is_text_ending(end)) return write_cloud(path, cloud, CloudFormat::xyz);
  fail_usage(fmt::format("{}: no cloud format ends in '{}'", path.string(), end),
             "use .pcd, .ply, .xyz or .bin");
}

void write_cloud(const fs::path& path, const PointCloud& cloud, CloudFormat format) {
  const std::string file = path.string();
  switch (format) {
    case CloudFormat::pcd_ascii:
      return write_file(path, format_pcd(cloud, PcdData::ascii, file));
    case CloudFormat::pcd_binary:
      return write_file(path, format_pcd(cloud, PcdData::binary, file));
    case CloudFormat::pcd_binary_compressed:
      return write_file(path, format_pcd(cloud, PcdData::binary_compressed, file));
    case CloudFormat::ply_ascii:
      return write_file(path, format_ply(cloud, PlyData::ascii, file));
    case CloudFormat::ply_binary:
      return write_file(path, format_ply(cloud, PlyData::little_endian, file));
    case CloudFormat::xyz:
      return write_file(path, format_xyz(cloud, file));
    case CloudFormat::kitti_bin:
      return write_kitti(path, cloud);
  }
}

}  // namespace scanchor
