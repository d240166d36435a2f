#include "cloud/pcd.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstring>
#include <optional>

#include "cloud/columns.hpp"
#include "cloud/lzf.hpp"
#include "cloud/text_lines.hpp"
#include "core/error.hpp"

namespace scanchor {
namespace {

constexpr std::string_view keywords[] = {"VERSION",   "FIELDS", "COLUMNS", "SIZE",
                                         "TYPE",      "COUNT",  "WIDTH",   "HEIGHT",
                                         "VIEWPOINT", "POINTS", "DATA"};
/// The longest descriptors that PCL keeps in clouds (SHOTColor, 1344 values) fit three times.
constexpr std::size_t greatest_values = 4096;

struct PcdHeader {
  std::vector<std::string> names;
  std::vector<std::uint64_t> sizes, counts;
  std::vector<std::string> types;
  std::optional<std::uint64_t> width, height, points;
  std::vector<Eigen::Isometry3d> viewpoint, poses;
  std::string data;
  std::size_t lines = 0;
  std::string_view body;
};

std::uint64_t whole(std::string_view token, std::string_view keyword, const std::string& file,
                    std::size_t line) {
  std::uint64_t value = 0;
  const auto result = std::from_chars(token.data(), token.data() + token.size(), value);
  if (token.empty() || result.ec != std::errc{} || result.ptr != token.data() + token.size()) {
    fail_data(file, line_place(line), fmt::format("{} '{}' is not a whole number", keyword, token));
  }
  return value;
}

PcdHeader read_header(std::string_view content, const std::string& file) {
  PcdHeader header;
  LineReader lines(content);
  std::string_view line;
  while (header.data.empty()) {
    if (!lines.next(line))
      fail_data(file, "header", "ends before its DATA line", "the file is truncated");
    std::string_view rest = line;
    std::string_view key = next_token(rest);
    if (key.empty()) continue;
    if (key.front() == '#') {
      if (next_token(rest) == pose_comment) {
        Eigen::Isometry3d pose;
        if (parse_pose(rest, pose)) header.poses.push_back(pose);
      }
      continue;
    }
    const auto each = [&](auto&& take) {
      for (auto token = next_token(rest); !token.empty(); token = next_token(rest)) take(token);
    };
    const auto one = [&] { return whole(next_token(rest), key, file, lines.number()); };
    if (key == "FIELDS" || key == "COLUMNS")
      each([&](auto t) { header.names.emplace_back(t); });
    else if (key == "SIZE")
      each([&](auto t) { header.sizes.push_back(whole(t, key, file, lines.number())); });
    else if (key == "COUNT")
      each([&](auto t) { header.counts.push_back(whole(t, key, file, lines.number())); });
    else if (key == "TYPE")
      each([&](auto t) { header.types.emplace_back(t); });
    else if (key == "WIDTH")
      header.width = one();
    else if (key == "HEIGHT")
      header.height = one();
    else if (key == "POINTS")
      header.points = one();
    else if (key == "DATA")
      header.data = std::string(next_token(rest));
    else if (key == "VIEWPOINT") {
      Eigen::Isometry3d pose;
      if (parse_pose(rest, pose)) header.viewpoint = {pose};
    } else if (key != "VERSION") {
      fail_data(file, line_place(lines.number()),
                fmt::format("unknown keyword '{}' in the header", key.substr(0, 40)));
    }
    if (key == "DATA" && header.data.empty()) {
      fail_data(file, line_place(lines.number()),
                "DATA must be ascii, binary or binary_compressed");
    }
  }
  header.lines = lines.number();
  header.body = lines.rest();
  return header;
}

ScalarType scalar_type(const std::string& type, std::uint64_t size, const std::string& name,
                       const std::string& file) {
  if (type == "F" && size == 4) return ScalarType::f32;
  if (type == "F" && size == 8) return ScalarType::f64;
  static constexpr ScalarType whole_types[2][4] = {
      {ScalarType::i8, ScalarType::i16, ScalarType::i32, ScalarType::i64},
      {ScalarType::u8, ScalarType::u16, ScalarType::u32, ScalarType::u64}};
  if ((type == "I" || type == "U") && (size == 1 || size == 2 || size == 4 || size == 8)) {
    return whole_types[type == "U" ? 1 : 0][std::countr_zero(size)];
  }
  fail_data(file, "header",
            fmt::format("field '{}' has TYPE {} and SIZE {}, which do not go together", name,
                        type.substr(0, 20), size));
}

/// The header's fields as the file lays them out; padding keeps its name "_" until the offsets are
/// known.
struct FileField {
  std::string name;
  ScalarType type;
  std::size_t count;
  [[nodiscard]] std::size_t bytes() const { return scalar_size(type) * count; }
};

std::vector<FileField> fields_of(PcdHeader& header, const std::string& file) {
  const std::size_t n = header.names.size();
  if (n == 0) fail_data(file, "header", "has no FIELDS line");
  if (header.sizes.empty() && header.types.empty()) {  // version .5 knew floats only
    header.sizes.assign(n, 4);
    header.types.assign(n, "F");
  }
  if (header.counts.empty()) header.counts.assign(n, 1);
  const auto check = [&](std::size_t found, const char* keyword) {
    if (found != n) {
      fail_data(file, "header",
                fmt::format("FIELDS names {} fields, but {} has {} entries", n, keyword, found));
    }
  };
  check(header.sizes.size(), "SIZE");
  check(header.types.size(), "TYPE");
  check(header.counts.size(), "COUNT");
  std::vector<FileField> fields;
  std::size_t values = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (header.counts[i] < 1 || header.counts[i] > greatest_values) {
      fail_data(file, "header",
                fmt::format("field '{}' has COUNT {}", header.names[i], header.counts[i]));
    }
    fields.push_back({header.names[i],
                      scalar_type(header.types[i], header.sizes[i], header.names[i], file),
                      static_cast<std::size_t>(header.counts[i])});
    // Padding is bytes, not columns.
    values += header.names[i] == "_" ? 1 : fields.back().count;
  }
  if (values > greatest_values) {
    fail_data(file, "header",
              fmt::format("has {} values a point, more than {}", values, greatest_values));
  }
  return fields;
}

std::uint64_t count_of(const PcdHeader& header, const std::string& file) {
  if (!header.points && !header.width) fail_data(file, "header", "has neither POINTS nor WIDTH");
  if (!header.width) return *header.points;
  const std::uint64_t height = header.height.value_or(1);
  if (height != 0 && *header.width > UINT64_MAX / height)
    fail_data(file, "header", "WIDTH x HEIGHT is too large");
  const std::uint64_t count = *header.width * height;
  if (header.points && *header.points != count) {
    fail_data(file, "header",
              fmt::format("WIDTH {} x HEIGHT {} is not POINTS {}", *header.width, height,
                          *header.points));
  }
  return count;
}

/// Columns of all fields but the padding; "normal" with COUNT 3 becomes normal_0, normal_1,
/// normal_2. `by_column`: one whole field behind the other (binary_compressed), `count` points
/// long.
std::vector<Column> lay_out(const std::vector<FileField>& fields, bool by_column, std::size_t count,
                            bool padding) {
  std::size_t record = 0;
  for (const auto& field : fields) record += field.bytes();
  std::vector<Column> columns;
  std::size_t offset = 0;
  for (const auto& field : fields) {
    if (field.name != "_") {
      for (std::size_t k = 0; k < field.count; ++k) {
        columns.push_back({field.count == 1 ? field.name : fmt::format("{}_{}", field.name, k),
                           field.type, offset + k * scalar_size(field.type),
                           by_column ? field.bytes() : record});
      }
    } else if (!padding) {
      continue;
    }
    offset += by_column ? field.bytes() * count : field.bytes();
  }
  return columns;
}

/// Text to records in the machine's own byte order.
std::string records_from_text(const PcdHeader& header, const std::vector<FileField>& fields,
                              std::size_t count, std::size_t record, const std::string& file) {
  std::size_t values = 0;
  for (const auto& field : fields) values += field.count;
  // A value is at least one digit and one blank or line end: no header makes us reserve more than
  // the file can hold.
  if (count > 0 && (header.body.size() + 1) / 2 / values < count) {
    fail_data(
        file, "",
        fmt::format("expected {} points of {} values after the header, found {} bytes of text",
                    count, values, header.body.size()),
        "the file is truncated");
  }
  std::string bytes(count * record, '\0');
  char* out = bytes.data();
  LineReader lines(header.body, header.lines + 1);
  std::string_view line;
  std::size_t found = 0;
  while (lines.next(line)) {
    std::string_view rest = line;
    std::string_view token = next_token(rest);
    if (token.empty()) continue;
    if (found == count) {
      fail_data(file, line_place(lines.number()),
                fmt::format("more lines than the {} points of the header", count));
    }
    for (const auto& field : fields) {
      for (std::size_t k = 0; k < field.count; ++k) {
        if (token.empty()) {
          fail_data(file, line_place(lines.number()),
                    fmt::format("has fewer than {} values", values));
        }
        if (!parse_scalar(token, field.type, out)) {
          fail_data(
              file, line_place(lines.number()),
              fmt::format("'{}' is no value for the field '{}'", token.substr(0, 40), field.name));
        }
        out += scalar_size(field.type);
        token = next_token(rest);
      }
    }
    if (!token.empty())
      fail_data(file, line_place(lines.number()), fmt::format("has more than {} values", values));
    ++found;
  }
  if (found != count) {
    fail_data(file, "", fmt::format("expected {} points, found {}", count, found),
              "the file is truncated");
  }
  return bytes;
}

std::uint32_t little32(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t k = 4; k-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
  return value;
}

std::string unpack(std::string_view body, const std::string& file) {
  if (body.size() < 8) {
    fail_data(file, "",
              fmt::format("expected 8 bytes of sizes after the header, found {}", body.size()),
              "the file is truncated");
  }
  const std::size_t packed = little32(body, 0);
  const std::size_t unpacked = little32(body, 4);
  if (body.size() - 8 < packed) {
    fail_data(
        file, "",
        fmt::format("expected {} bytes of compressed data, found {}", packed, body.size() - 8),
        "the file is truncated");
  }
  if (unpacked / lzf_greatest_expansion > packed) {
    fail_data(file, "", fmt::format("{} compressed bytes cannot hold {}", packed, unpacked),
              "the file is damaged");
  }
  auto bytes = lzf_decompress(body.substr(8, packed), unpacked);
  if (!bytes) fail_data(file, "", "the compressed data is damaged");
  return *std::move(bytes);
}

}  // namespace

bool looks_like_pcd(std::string_view content) {
  LineReader lines(content.substr(0, 4096));
  std::string_view line;
  while (lines.next(line)) {
    const std::string_view key = next_token(line);
    if (key.empty() || key.front() == '#') {
      if (line.find(".PCD") != std::string_view::npos) return true;
      continue;
    }
    return std::find(std::begin(keywords), std::end(keywords), key) != std::end(keywords);
  }
  return false;
}

PointCloud parse_pcd(std::string_view content, const std::string& file) {
  PcdHeader header = read_header(content, file);
  const std::vector<FileField> fields = fields_of(header, file);
  const std::uint64_t points = count_of(header, file);
  std::size_t record = 0, record_without_padding = 0;
  for (const auto& field : fields) {
    record += field.bytes();
    if (field.name != "_") record_without_padding += field.bytes();
  }
  if (points > UINT64_MAX / 8 / record)
    fail_data(file, "header", fmt::format("POINTS {} is too large", points));
  const auto count = static_cast<std::size_t>(points);

  std::string unpacked;
  std::string_view bytes = header.body;
  bool by_column = false, padding = true;
  bool swap = std::endian::native == std::endian::big;
  if (header.data == "ascii") {
    unpacked = records_from_text(header, fields, count, record, file);
    bytes = unpacked;
    swap = false;
  } else if (header.data == "binary") {
    if (bytes.size() / record < count) {
      fail_data(file, "",
                fmt::format("expected {} bytes of points after the header, found {}",
                            count * record, bytes.size()),
                "the file is truncated");
    }
  } else if (header.data == "binary_compressed") {
    if (count > 0 || !bytes.empty()) unpacked = unpack(bytes, file);
    bytes = unpacked;
    by_column = true;
    // PCL leaves padding out when it compresses, but other writers do not.
    padding = bytes.size() == record * count;
    if (!padding && bytes.size() != record_without_padding * count) {
      fail_data(file, "",
                fmt::format("expected {} bytes of points, the compressed data holds {}",
                            record * count, bytes.size()));
    }
  } else {
    fail_data(file, line_place(header.lines),
              fmt::format("DATA '{}' is unknown", header.data.substr(0, 40)),
              "known are: ascii, binary, binary_compressed");
  }

  PointCloud cloud =
      cloud_from_columns(lay_out(fields, by_column, count, padding), bytes, count, swap, file);
  if (header.width && header.height.value_or(1) > 1 && *header.width <= INT32_MAX &&
      *header.height <= INT32_MAX) {
    cloud.width = static_cast<int>(*header.width);
    cloud.height = static_cast<int>(*header.height);
  }
  cloud.sensor_poses = header.poses.empty() ? header.viewpoint : header.poses;
  return cloud;
}

std::string format_pcd(const PointCloud& cloud, PcdData data, const std::string& file) {
  const std::vector<OutColumn> columns = columns_of(cloud, file);
  std::string names, sizes, types, counts;
  for (const auto& column : columns) {
    names += " " + column.name;
    sizes += fmt::format(" {}", scalar_size(column.type));
    const bool real = column.type == ScalarType::f32 || column.type == ScalarType::f64;
    types += real ? " F" : column.type == ScalarType::i32 ? " I" : " U";
    counts += " 1";
  }
  std::string text = "# .PCD v0.7 - Point Cloud Data file format\n";
  if (cloud.sensor_poses.size() > 1) {  // VIEWPOINT holds one only
    for (const auto& pose : cloud.sensor_poses)
      text += fmt::format("# {} {}\n", pose_comment, pose_text(pose));
  }
  const bool organized = cloud.height > 1;
  text += fmt::format("VERSION 0.7\nFIELDS{}\nSIZE{}\nTYPE{}\nCOUNT{}\nWIDTH {}\nHEIGHT {}\n",
                      names, sizes, types, counts,
                      organized ? static_cast<std::size_t>(cloud.width) : cloud.size(),
                      organized ? cloud.height : 1);
  if (!cloud.sensor_poses.empty())
    text += fmt::format("VIEWPOINT {}\n", pose_text(cloud.sensor_poses.front()));
  text += fmt::format("POINTS {}\nDATA ", cloud.size());
  if (data == PcdData::ascii) return text + "ascii\n" + text_records(cloud, columns);
  if (data == PcdData::binary) return text + "binary\n" + pack_records(cloud, columns);
  const std::string plain = pack_columns(cloud, columns);
  const std::string packed = lzf_compress(plain);
  if (plain.size() > UINT32_MAX || packed.size() > UINT32_MAX) {
    fail_data(file, "", "binary_compressed PCD ends at 4 GiB", "write it as binary");
  }
  text += "binary_compressed\n";
  for (const std::size_t size : {packed.size(), plain.size()}) {
    for (int k = 0; k < 4; ++k) text += static_cast<char>(size >> (8 * k) & 255);
  }
  return text + packed;
}

}  // namespace scanchor
