#include "cloud/ply.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>
#include <optional>

#include "cloud/columns.hpp"
#include "cloud/text_lines.hpp"
#include "core/error.hpp"

namespace scanchor {
namespace {

struct Property {
  std::string name;
  ScalarType type = ScalarType::f32;
  std::optional<ScalarType> list_count;  ///< type of the length, for a list
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
  [[nodiscard]] bool has_lists() const {
    return std::any_of(properties.begin(), properties.end(),
                       [](const auto& p) { return p.list_count.has_value(); });
  }
  /// Bytes of a record, lists counted by their lengths alone: the least a record can take.
  [[nodiscard]] std::size_t least_bytes() const {
    std::size_t sum = 0;
    for (const auto& p : properties) sum += scalar_size(p.list_count.value_or(p.type));
    return sum;
  }
};

struct PlyHeader {
  PlyData data = PlyData::ascii;
  std::vector<Element> elements;
  std::vector<Eigen::Isometry3d> poses;
  std::uint64_t columns = 0, rows = 0;  ///< obj_info num_cols, num_rows of a range grid
  std::size_t lines = 0;
  std::string_view body;
};

std::optional<std::uint64_t> whole(std::string_view token) {
  std::uint64_t value = 0;
  const auto result = std::from_chars(token.data(), token.data() + token.size(), value);
  if (token.empty() || result.ec != std::errc{} || result.ptr != token.data() + token.size())
    return std::nullopt;
  return value;
}

std::optional<ScalarType> type_named(std::string_view name) {
  static constexpr std::pair<std::string_view, ScalarType> names[] = {
      {"char", ScalarType::i8},     {"int8", ScalarType::i8},    {"uchar", ScalarType::u8},
      {"uint8", ScalarType::u8},    {"short", ScalarType::i16},  {"int16", ScalarType::i16},
      {"ushort", ScalarType::u16},  {"uint16", ScalarType::u16}, {"int", ScalarType::i32},
      {"int32", ScalarType::i32},   {"uint", ScalarType::u32},   {"uint32", ScalarType::u32},
      {"int64", ScalarType::i64},   {"uint64", ScalarType::u64}, {"float", ScalarType::f32},
      {"float32", ScalarType::f32}, {"double", ScalarType::f64}, {"float64", ScalarType::f64}};
  for (const auto& [text, type] : names) {
    if (text == name) return type;
  }
  return std::nullopt;
}

class HeaderReader {
 public:
  HeaderReader(std::string_view content, const std::string& file) : lines_(content), file_(file) {}

  PlyHeader read() {
    PlyHeader header;
    std::string_view line;
    if (!lines_.next(line) || line != "ply") fail("a PLY file begins with the line 'ply'");
    bool format = false;
    while (true) {
      if (!lines_.next(line))
        fail_data(file_, "header", "ends before end_header", "the file is truncated");
      std::string_view rest = line;
      const std::string_view key = next_token(rest);
      if (key == "end_header") break;
      if (key == "format") {
        format = true;
        header.data = data_named(next_token(rest));
      } else if (key == "element") {
        header.elements.push_back(element(rest));
      } else if (key == "property") {
        if (header.elements.empty()) fail("a property before any element");
        header.elements.back().properties.push_back(property(rest));
      } else if (key == "comment" || key == "obj_info") {
        remark(rest, header);
      } else if (!key.empty()) {
        fail(fmt::format("unknown keyword '{}' in the header", key.substr(0, 40)));
      }
    }
    if (!format) fail("the header has no format line");
    header.lines = lines_.number();
    header.body = lines_.rest();
    return header;
  }

 private:
  [[noreturn]] void fail(const std::string& cause) const {
    fail_data(file_, line_place(std::max<std::size_t>(lines_.number(), 1)), cause);
  }

  PlyData data_named(std::string_view name) const {
    if (name == "ascii") return PlyData::ascii;
    if (name == "binary_little_endian") return PlyData::little_endian;
    if (name == "binary_big_endian") return PlyData::big_endian;
    fail(fmt::format(
        "format '{}' is unknown; known are: ascii, binary_little_endian, binary_big_endian",
        name.substr(0, 40)));
  }

  Element element(std::string_view rest) const {
    Element element;
    element.name = std::string(next_token(rest));
    const std::string_view token = next_token(rest);
    const auto count = whole(token);
    if (!count) fail(fmt::format("'{}' is not a number of elements", token.substr(0, 40)));
    element.count = *count;
    return element;
  }

  Property property(std::string_view rest) const {
    Property property;
    const auto type = [&](std::string_view token) {
      const auto known = type_named(token);
      if (!known) fail(fmt::format("'{}' is not a type of a property", token.substr(0, 40)));
      return *known;
    };
    std::string_view token = next_token(rest);
    if (token == "list") {
      property.list_count = type(next_token(rest));
      if (*property.list_count == ScalarType::f32 || *property.list_count == ScalarType::f64) {
        fail("the length of a list must be a whole number");
      }
      token = next_token(rest);
    }
    property.type = type(token);
    property.name = std::string(next_token(rest));
    if (property.name.empty()) fail("a property without a name");
    return property;
  }

  static void remark(std::string_view rest, PlyHeader& header) {
    const std::string_view key = next_token(rest);
    Eigen::Isometry3d pose;
    if (key == pose_comment && parse_pose(rest, pose))
      header.poses.push_back(pose);
    else if (key == "num_cols")
      header.columns = whole(next_token(rest)).value_or(0);
    else if (key == "num_rows")
      header.rows = whole(next_token(rest)).value_or(0);
  }

  LineReader lines_;
  const std::string& file_;
};

/// Reads through the body of a binary file.
class BinaryBody {
 public:
  BinaryBody(std::string_view body, bool swap, const std::string& file)
      : rest_(body), swap_(swap), file_(file) {}

  void skip(const Element& element) {
    if (!element.has_lists()) {
      const std::size_t record = element.least_bytes();
      if (record != 0) require(element, element.count, record);
      rest_.remove_prefix(static_cast<std::size_t>(element.count) * record);
      return;
    }
    for (std::uint64_t i = 0; i < element.count; ++i) record(element, nullptr);
  }

  /// The records of an element without its lists, one behind the other.
  std::string_view take(const Element& element, std::string& storage) {
    require(element, element.count, std::max<std::size_t>(element.least_bytes(), 1));
    if (!element.has_lists()) {
      const std::string_view bytes =
          rest_.substr(0, static_cast<std::size_t>(element.count) * element.least_bytes());
      rest_.remove_prefix(bytes.size());
      return bytes;
    }
    for (std::uint64_t i = 0; i < element.count; ++i) record(element, &storage);
    return storage;
  }

 private:
  void require(const Element& element, std::uint64_t count, std::size_t record) const {
    if (rest_.size() / record < count) {
      const auto bytes = count > UINT64_MAX / record ? fmt::format("{} x {}", count, record)
                                                     : fmt::format("{}", count * record);
      fail_data(file_, "",
                fmt::format("expected {} bytes of the element '{}', found {}", bytes, element.name,
                            rest_.size()),
                "the file is truncated");
    }
  }

  std::string_view bytes(const Element& element, std::uint64_t count) {
    if (rest_.size() < count) {
      fail_data(file_, "",
                fmt::format("ends within the element '{}': expected {} more bytes, found {}",
                            element.name, count, rest_.size()),
                "the file is truncated");
    }
    const std::string_view taken = rest_.substr(0, static_cast<std::size_t>(count));
    rest_.remove_prefix(taken.size());
    return taken;
  }

  void record(const Element& element, std::string* keep) {
    for (const auto& property : element.properties) {
      const std::string_view value =
          bytes(element, scalar_size(property.list_count.value_or(property.type)));
      if (!property.list_count) {
        if (keep != nullptr) keep->append(value);
        continue;
      }
      bytes(element, length(value, *property.list_count) * scalar_size(property.type));
    }
  }

  /// Length of a list: at most 32 bits are believed, so that it cannot overflow.
  [[nodiscard]] std::uint64_t length(std::string_view value, ScalarType type) const {
    std::uint64_t n = 0;
    for (std::size_t k = 0; k < value.size(); ++k) {
      const bool backwards =
          swap_ == (std::endian::native == std::endian::big);  // the file is little endian
      n = n << 8 | static_cast<unsigned char>(value[backwards ? value.size() - 1 - k : k]);
    }
    const bool is_signed = type == ScalarType::i8 || type == ScalarType::i16 ||
                           type == ScalarType::i32 || type == ScalarType::i64;
    const bool negative = is_signed && (n >> (8 * value.size() - 1) & 1) != 0;
    if (negative || n > UINT32_MAX) fail_data(file_, "", "has a list of negative or absurd length");
    return n;
  }

  std::string_view rest_;
  bool swap_;
  const std::string& file_;
};

/// Takes the records of one ascii element; one record a line.
class TextBody {
 public:
  TextBody(const PlyHeader& header, const std::string& file)
      : lines_(header.body, header.lines + 1), file_(file) {}

  void read(const Element& element, std::string* keep) {
    // A record is at least one digit and one line end.
    const std::size_t least = std::max<std::size_t>(1, element.properties.size());
    if (element.count > 0 && (lines_.rest().size() + 1) / 2 / least < element.count) {
      fail_data(file_, "",
                fmt::format("expected {} lines of the element '{}', found {} bytes of text",
                            element.count, element.name, lines_.rest().size()),
                "the file is truncated");
    }
    if (keep != nullptr)
      keep->reserve(static_cast<std::size_t>(element.count) * element.least_bytes());
    std::string_view line;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      do {
        if (!lines_.next(line)) {
          fail_data(file_, "",
                    fmt::format("expected {} lines of the element '{}', found {}", element.count,
                                element.name, i),
                    "the file is truncated");
        }
      } while (line.find_first_not_of(" \t\r") == std::string_view::npos);
      record(element, line, keep);
    }
  }

 private:
  void record(const Element& element, std::string_view line, std::string* keep) {
    char value[8];
    for (const auto& property : element.properties) {
      const std::string_view token = take(element, line);
      if (property.list_count) {
        const auto length = whole(token);
        if (!length) fail(fmt::format("'{}' is not the length of a list", token.substr(0, 40)));
        for (std::uint64_t k = 0; k < *length; ++k) take(element, line);
        continue;
      }
      if (keep == nullptr) continue;
      if (!parse_scalar(token, property.type, value)) {
        fail(fmt::format("'{}' is no value for the property '{}'", token.substr(0, 40),
                         property.name));
      }
      keep->append(value, scalar_size(property.type));
    }
    if (!next_token(line).empty())
      fail(fmt::format("has more values than the element '{}'", element.name));
  }

  std::string_view take(const Element& element, std::string_view& line) const {
    const std::string_view token = next_token(line);
    if (token.empty()) fail(fmt::format("has fewer values than the element '{}'", element.name));
    return token;
  }

  [[noreturn]] void fail(const std::string& cause) const {
    fail_data(file_, line_place(lines_.number()), cause);
  }

  LineReader lines_;
  const std::string& file_;
};

std::string_view type_name(ScalarType type) {
  switch (type) {
    case ScalarType::u8:
      return "uchar";
    case ScalarType::u16:
      return "ushort";
    case ScalarType::i32:
      return "int";
    case ScalarType::u32:
      return "uint";
    case ScalarType::f64:
      return "double";
    default:
      return "float";
  }
}

/// Turns each value of packed records round.
void swap_records(std::string& bytes, const std::vector<OutColumn>& columns) {
  auto at = bytes.begin();
  while (at != bytes.end()) {
    for (const auto& column : columns) {
      const auto end = at + static_cast<std::ptrdiff_t>(scalar_size(column.type));
      std::reverse(at, end);
      at = end;
    }
  }
}

}  // namespace

PointCloud parse_ply(std::string_view content, const std::string& file) {
  const PlyHeader header = HeaderReader(content, file).read();
  const auto vertex = std::find_if(header.elements.begin(), header.elements.end(),
                                   [](const Element& e) { return e.name == "vertex"; });
  if (vertex == header.elements.end()) fail_data(file, "header", "has no element 'vertex'");

  std::string storage;
  std::string_view bytes;
  bool swap = false;
  if (header.data == PlyData::ascii) {
    TextBody body(header, file);
    for (auto element = header.elements.begin(); element != vertex; ++element)
      body.read(*element, nullptr);
    body.read(*vertex, &storage);
    bytes = storage;
  } else {
    swap = (header.data == PlyData::big_endian) != (std::endian::native == std::endian::big);
    BinaryBody body(header.body, swap, file);
    for (auto element = header.elements.begin(); element != vertex; ++element) body.skip(*element);
    bytes = body.take(*vertex, storage);
  }

  std::vector<Column> columns;
  for (const auto& property : vertex->properties) {
    if (!property.list_count) columns.push_back({property.name, property.type});
  }
  lay_out_records(columns);
  PointCloud cloud =
      cloud_from_columns(columns, bytes, static_cast<std::size_t>(vertex->count), swap, file);
  cloud.sensor_poses = header.poses;
  if (header.rows > 1 && header.columns > 0 && header.columns <= INT32_MAX &&
      header.rows <= INT32_MAX && header.columns * header.rows == vertex->count) {
    cloud.width = static_cast<int>(header.columns);
    cloud.height = static_cast<int>(header.rows);
  }
  return cloud;
}

std::string format_ply(const PointCloud& cloud, PlyData data, const std::string& file) {
  const std::vector<OutColumn> columns = columns_of(cloud, file);
  std::string text =
      fmt::format("ply\nformat {} 1.0\n", data == PlyData::ascii           ? "ascii"
                                          : data == PlyData::little_endian ? "binary_little_endian"
                                                                           : "binary_big_endian");
  for (const auto& pose : cloud.sensor_poses)
    text += fmt::format("comment {} {}\n", pose_comment, pose_text(pose));
  if (cloud.height > 1)
    text += fmt::format("obj_info num_cols {}\nobj_info num_rows {}\n", cloud.width, cloud.height);
  text += fmt::format("element vertex {}\n", cloud.size());
  for (const auto& column : columns)
    text += fmt::format("property {} {}\n", type_name(column.type), column.name);
  text += "end_header\n";
  if (data == PlyData::ascii) return text + text_records(cloud, columns);
  std::string bytes = pack_records(cloud, columns);
  if (data == PlyData::big_endian) swap_records(bytes, columns);
  return text + bytes;
}

}  // namespace scanchor
