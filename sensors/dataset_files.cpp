#include "sensors/dataset_files.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <map>

#include "core/error.hpp"

namespace scanchor {
namespace {

/// KITTI's camera frame seen from the sensor: x right (-y), y down (-z), z forward (x).
Eigen::Isometry3d camera_from_sensor() {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() << 0, -1, 0, 0, 0, -1, 1, 0, 0;
  return T;
}

std::string row_major_3x4(const Eigen::Isometry3d& T) {
  std::string line;
  for (int r = 0; r < 3; ++r) {
    // Adding 0 turns the -0 of the permutation into 0.
    for (int c = 0; c < 4; ++c)
      line += fmt::format("{}{}", line.empty() ? "" : " ", T.matrix()(r, c) + 0.0);
  }
  return line;
}

bool parse_3x4(std::string_view text, Eigen::Isometry3d& T) {
  T = Eigen::Isometry3d::Identity();
  const char* at = text.data();
  const char* end = at + text.size();
  for (int i = 0; i < 12; ++i) {
    while (at != end && (*at == ' ' || *at == '\t' || *at == '+')) ++at;
    double value = 0.0;
    const auto result = std::from_chars(at, end, value);
    if (result.ec != std::errc{} || !std::isfinite(value)) return false;
    T.matrix()(i / 4, i % 4) = value;
    at = result.ptr;
  }
  while (at != end && (*at == ' ' || *at == '\t' || *at == '\r')) ++at;
  return at == end;
}

template <class T>
void put(char*& out, T value) {
  auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
  if constexpr (std::endian::native == std::endian::big) std::reverse(raw.begin(), raw.end());
  std::memcpy(out, raw.data(), sizeof(T));
  out += sizeof(T);
}

template <class T>
T get(const char*& in) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), in, sizeof(T));
  if constexpr (std::endian::native == std::endian::big) std::reverse(raw.begin(), raw.end());
  in += sizeof(T);
  return std::bit_cast<T>(raw);
}

constexpr std::size_t truth_record = 4 + 2 + 4 + 1 + 2 + 2 + 4 + 4;
constexpr std::uint16_t none16 = 65535;

/// Everything before the records, padded to a multiple of 64 bytes as numpy wants it.
std::string npy_header(std::size_t count) {
  std::string dict = fmt::format(
      "{{'descr': [('face', '<i4'), ('part', '<i2'), ('runner_up', '<i4'), ('flags', '|u1'), "
      "('line', '<u2'), "
      "('beam', '<u2'), ('true_range', '<f4'), ('incidence', '<f4')], 'fortran_order': False, "
      "'shape': ({},), }}",
      count);
  while ((10 + dict.size() + 1) % 64 != 0) dict += ' ';
  dict += '\n';
  std::string header = "\x93NUMPY";
  header += '\x01';
  header += '\0';
  header += static_cast<char>(dict.size() & 255);
  header += static_cast<char>(dict.size() >> 8);
  return header + dict;
}

std::uint16_t small_index(const std::vector<std::int32_t>& column, std::size_t i) {
  return i < column.size() && column[i] >= 0 && column[i] < none16
             ? static_cast<std::uint16_t>(column[i])
             : none16;
}

std::array<std::uint8_t, 3> color_of(const Scene& scene, std::int32_t instance_id,
                                     std::int32_t part) {
  for (const auto& instance : scene.instances) {
    if (instance.id != instance_id || part < 0 ||
        static_cast<std::size_t>(part) >= instance.parts.size())
      continue;
    const int material = instance.parts[static_cast<std::size_t>(part)].material;
    if (material >= 0 && static_cast<std::size_t>(material) < scene.materials.size()) {
      return scene.materials[static_cast<std::size_t>(material)].color;
    }
  }
  return {0, 0, 0};
}

}  // namespace

std::string label_bytes(const PointTruth& truth, const std::string& file) {
  std::string bytes(4 * truth.size(), '\0');
  char* out = bytes.data();
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (truth.class_id[i] > 65535 || truth.instance[i] > 65535) {
      fail_data(file, fmt::format("point {}", i),
                "class or instance does not fit the 16 bits of a .label file");
    }
    const auto label = static_cast<std::uint32_t>(std::max(0, truth.class_id[i]));
    const auto instance = static_cast<std::uint32_t>(std::max(0, truth.instance[i]));
    put(out, label | instance << 16);
  }
  return bytes;
}

std::string truth_npy(const Scan& scan) {
  const PointTruth& truth = scan.truth;
  std::string bytes = npy_header(truth.size());
  const std::size_t start = bytes.size();
  bytes.resize(start + truth_record * truth.size());
  char* out = bytes.data() + start;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    put(out, truth.face[i]);
    put(out, static_cast<std::int16_t>(truth.part[i]));
    put(out, truth.runner_up[i]);
    put(out, truth.flags[i]);
    put(out, small_index(scan.line, i));
    put(out, small_index(scan.beam, i));
    put(out, truth.true_range[i]);
    put(out, truth.incidence[i]);
  }
  return bytes;
}

void read_truth_npy(std::string_view bytes, Scan& scan, const std::string& file) {
  const std::size_t count = scan.truth.size();
  const std::string header = npy_header(count);
  if (!bytes.starts_with(header)) {
    fail_data(file, "header", fmt::format("is no truth of {} points", count),
              "see docs/reference/dataset-layout.md");
  }
  if (bytes.size() != header.size() + count * truth_record) {
    fail_data(file, "",
              fmt::format("expected {} bytes, found {}", header.size() + count * truth_record,
                          bytes.size()),
              "the file is truncated");
  }
  scan.line.resize(count);
  scan.beam.resize(count);
  const char* in = bytes.data() + header.size();
  for (std::size_t i = 0; i < count; ++i) {
    scan.truth.face[i] = get<std::int32_t>(in);
    scan.truth.part[i] = get<std::int16_t>(in);
    scan.truth.runner_up[i] = get<std::int32_t>(in);
    scan.truth.flags[i] = get<std::uint8_t>(in);
    const auto line = get<std::uint16_t>(in);
    const auto beam = get<std::uint16_t>(in);
    scan.line[i] = line == none16 ? -1 : line;
    scan.beam[i] = beam == none16 ? -1 : beam;
    scan.truth.true_range[i] = get<float>(in);
    scan.truth.incidence[i] = get<float>(in);
  }
}

std::string poses_text(const std::vector<Eigen::Isometry3d>& T_world_sensor) {
  const Eigen::Isometry3d Tr = camera_from_sensor();
  std::string text;
  for (const auto& T : T_world_sensor) text += row_major_3x4(Tr * T * Tr.inverse()) + "\n";
  return text;
}

std::string calib_text() {
  std::string text;
  for (int k = 0; k < 4; ++k) text += fmt::format("P{}: 1 0 0 0 0 1 0 0 0 0 1 0\n", k);
  return text + "Tr: " + row_major_3x4(camera_from_sensor()) + "\n";
}

std::vector<Eigen::Isometry3d> parse_poses(std::string_view poses, std::string_view calib,
                                           const std::string& poses_file,
                                           const std::string& calib_file) {
  Eigen::Isometry3d Tr = camera_from_sensor();
  const auto each_line = [](std::string_view text, auto&& take) {
    for (std::size_t number = 1; !text.empty(); ++number) {
      const std::size_t end = text.find('\n');
      const std::string_view line = text.substr(0, end);
      if (line.find_first_not_of(" \t\r") != std::string_view::npos) take(line, number);
      text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
  };
  each_line(calib, [&](std::string_view line, std::size_t number) {
    if (line.starts_with("Tr:") && !parse_3x4(line.substr(3), Tr)) {
      fail_data(calib_file, fmt::format("line {}", number), "Tr is not 12 numbers");
    }
    if (line.starts_with("Tr:") && !(std::abs(Tr.linear().determinant()) > 1e-6)) {
      fail_data(calib_file, fmt::format("line {}", number), "Tr cannot be inverted");
    }
  });
  std::vector<Eigen::Isometry3d> result;
  each_line(poses, [&](std::string_view line, std::size_t number) {
    Eigen::Isometry3d pose;
    if (!parse_3x4(line, pose))
      fail_data(poses_file, fmt::format("line {}", number), "a pose is not 12 numbers");
    // Calibrations in text are orthonormal only to their digits, so the transpose is not quite the
    // inverse.
    const Eigen::Matrix3d back = Tr.linear().inverse();
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    T.linear() = back * (pose.linear() * Tr.linear());
    T.translation() =
        back * (pose.linear() * Tr.translation() + pose.translation() - Tr.translation());
    result.push_back(T);
  });
  return result;
}

std::string times_text(std::size_t scans, const LidarOptions& lidar) {
  std::string text;
  for (std::size_t k = 0; k < scans; ++k) {
    text += fmt::format("{}\n", static_cast<double>(k) * lidar.lines / lidar.lines_per_second);
  }
  return text;
}

std::vector<std::pair<std::string, std::string>> s3dis_files(const Scene& scene,
                                                             const std::vector<Scan>& scans,
                                                             const std::string& room) {
  // One annotation an instance, numbered within its S3DIS class in the order of the scene; 0:
  // points of no instance.
  std::map<std::int32_t, std::string> names = {{0, "clutter_0"}};
  std::map<std::string_view, int> numbers;
  for (const auto& instance : scene.instances) {
    const std::string_view name = class_info(instance.class_id).s3dis;
    names[instance.id] = fmt::format("{}_{}", name, ++numbers[name]);
  }
  std::string all;
  std::map<std::int32_t, std::string> parts;
  for (const auto& scan : scans) {
    std::map<std::pair<std::int32_t, std::int32_t>, std::array<std::uint8_t, 3>> colors;
    for (std::size_t i = 0; i < scan.truth.size(); ++i) {
      const std::int32_t instance =
          names.contains(scan.truth.instance[i]) ? scan.truth.instance[i] : 0;
      const auto key = std::pair(instance, scan.truth.part[i]);
      auto color = colors.find(key);
      if (color == colors.end())
        color = colors.emplace(key, color_of(scene, key.first, key.second)).first;
      const Eigen::Vector3d p = scan.T_world_sensor * scan.cloud.points[i];
      const auto& [r, g, b] = color->second;
      const std::string line =
          fmt::format("{:.3f} {:.3f} {:.3f} {} {} {}\n", p.x(), p.y(), p.z(), r, g, b);
      all += line;
      parts[instance] += line;
    }
  }
  std::vector<std::pair<std::string, std::string>> files;
  files.emplace_back(fmt::format("{}/{}.txt", room, room), std::move(all));
  for (auto& [instance, text] : parts) {
    files.emplace_back(fmt::format("{}/Annotations/{}.txt", room, names[instance]),
                       std::move(text));
  }
  return files;
}

}  // namespace scanchor
