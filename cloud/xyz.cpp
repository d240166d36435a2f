#include "cloud/xyz.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "cloud/columns.hpp"
#include "cloud/text_lines.hpp"
#include "core/error.hpp"

namespace scanchor {
namespace {

constexpr std::pair<std::string_view, ScalarType> type_names[] = {
    {"float32", ScalarType::f32}, {"float64", ScalarType::f64}, {"int32", ScalarType::i32},
    {"uint32", ScalarType::u32},  {"uint16", ScalarType::u16},  {"uint8", ScalarType::u8}};

std::vector<std::string_view> tokens_of(std::string_view line) {
  std::vector<std::string_view> tokens;
  for (auto t = next_token(line, ',', ';'); !t.empty(); t = next_token(line, ',', ';'))
    tokens.push_back(t);
  return tokens;
}

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return result;
}

/// What the comments and the first lines tell.
struct Preface {
  std::vector<std::string> names;
  std::vector<ScalarType> types;
  std::vector<Eigen::Isometry3d> poses;
  int width = 0, height = 0;
  std::optional<std::size_t> count;

  /// True if the words name columns: x y z first, in any case.
  bool take_names(const std::vector<std::string_view>& words) {
    if (words.size() < 3 || lower(words[0]) != "x" || lower(words[1]) != "y" ||
        lower(words[2]) != "z")
      return false;
    names = {"x", "y", "z"};
    for (std::size_t i = 3; i < words.size(); ++i) names.emplace_back(words[i]);
    return true;
  }

  void take_comment(std::string_view comment) {
    std::string_view rest = comment;
    const std::string_view key = next_token(rest);
    Eigen::Isometry3d pose;
    if (key == pose_comment) {
      if (parse_pose(rest, pose)) poses.push_back(pose);
    } else if (key == "types") {
      types.clear();
      for (const auto word : tokens_of(rest)) {
        const auto known = std::find_if(std::begin(type_names), std::end(type_names),
                                        [&](const auto& entry) { return entry.first == word; });
        types.push_back(known == std::end(type_names) ? ScalarType::f64 : known->second);
      }
    } else if (key == "organized") {
      const auto size = tokens_of(rest);
      if (size.size() == 2) {
        std::from_chars(size[0].data(), size[0].data() + size[0].size(), width);
        std::from_chars(size[1].data(), size[1].data() + size[1].size(), height);
      }
    } else if (names.empty()) {
      take_names(tokens_of(comment));
    }
  }
};

/// Without a types comment everything was read as double; columns of whole numbers become int32.
void narrow(Field& field, bool color) {
  const auto& values = std::get<std::vector<double>>(field.values);
  const double limit = color ? 255.0 : 2147483647.0;
  const bool whole = std::all_of(values.begin(), values.end(), [&](double v) {
    return v == std::floor(v) && v <= limit && v >= (color ? 0.0 : -limit);
  });
  if (!whole) return;
  if (color)
    field.values = std::vector<std::uint8_t>(values.begin(), values.end());
  else
    field.values = std::vector<std::int32_t>(values.begin(), values.end());
}

std::vector<std::string> default_names(std::size_t columns) {
  std::vector<std::string> names = {"x", "y", "z"};
  if (columns == 4 || columns == 7) names.emplace_back("intensity");
  if (columns == 6 || columns == 7) names.insert(names.end(), {"red", "green", "blue"});
  while (names.size() < columns) names.push_back(fmt::format("column_{}", names.size() + 1));
  return names;
}

}  // namespace

PointCloud parse_xyz(std::string_view content, const std::string& file) {
  Preface preface;
  std::vector<Column> columns;
  std::string bytes;
  std::size_t count = 0, record = 0;
  LineReader lines(content);
  std::string_view line;
  const auto fail = [&](const std::string& cause) {
    fail_data(file, fmt::format("line {}", lines.number()), cause);
  };
  const auto begin_columns = [&](std::size_t n) {
    if (n < 3) fail(fmt::format("has {} columns, a point needs x, y and z", n));
    if (preface.names.size() != n) preface.names = default_names(n);
    if (preface.types.size() != n) preface.types.clear();
    for (std::size_t i = 0; i < n; ++i) {
      columns.push_back(
          {preface.names[i], preface.types.empty() ? ScalarType::f64 : preface.types[i]});
    }
    record = lay_out_records(columns);
    bytes.reserve(content.size() / 2);
  };
  while (lines.next(line)) {
    std::string_view rest = line;
    if (lines.number() == 1 && rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);
    const std::size_t start = rest.find_first_not_of(" \t\r");
    if (start == std::string_view::npos) continue;
    rest.remove_prefix(start);
    if (rest.front() == '#' || rest.starts_with("//")) {
      preface.take_comment(rest.substr(rest.front() == '#' ? 1 : 2));
      continue;
    }
    // A remark behind the numbers; "1.#QNAN" has its # inside a number.
    for (auto at = rest.find('#'); at != std::string_view::npos; at = rest.find('#', at + 1)) {
      if (rest[at - 1] == ' ' || rest[at - 1] == '\t') {
        rest = rest.substr(0, at);
        break;
      }
    }
    if (columns.empty()) {
      const auto tokens = tokens_of(rest);
      if (preface.take_names(tokens)) continue;
      std::uint64_t only = 0;
      if (tokens.size() == 1 && !preface.count &&
          parse_scalar(tokens[0], ScalarType::u64, reinterpret_cast<char*>(&only))) {
        preface.count = static_cast<std::size_t>(only);
        continue;
      }
      begin_columns(tokens.size());
    }
    const std::size_t at = bytes.size();
    bytes.resize(at + record);
    for (const auto& column : columns) {
      const std::string_view token = next_token(rest, ',', ';');
      if (token.empty())
        fail(fmt::format("has fewer than the {} columns of the lines before", columns.size()));
      if (!parse_scalar(token, column.type, bytes.data() + at + column.offset)) {
        fail(fmt::format("'{}' is no value for the column '{}'", token.substr(0, 40), column.name));
      }
    }
    if (!next_token(rest, ',', ';').empty()) {
      fail(fmt::format("has more than the {} columns of the lines before", columns.size()));
    }
    ++count;
  }
  if (preface.count && *preface.count != count) {
    fail_data(file, "", fmt::format("expected {} points, found {}", *preface.count, count),
              "the file is truncated");
  }
  if (columns.empty()) {
    if (preface.names.empty()) fail_data(file, "", "holds no points");
    begin_columns(preface.names.size());
  }
  PointCloud cloud = cloud_from_columns(columns, bytes, count, false, file);
  if (preface.types.empty()) {
    for (auto& field : cloud.fields) {
      narrow(field, field.name == "red" || field.name == "green" || field.name == "blue");
    }
  }
  cloud.sensor_poses = preface.poses;
  if (preface.height > 1 && preface.width > 0 &&
      static_cast<std::size_t>(preface.width) * static_cast<std::size_t>(preface.height) == count) {
    cloud.width = preface.width;
    cloud.height = preface.height;
  }
  return cloud;
}

std::string format_xyz(const PointCloud& cloud, const std::string& file) {
  std::vector<OutColumn> columns = columns_of(cloud, file);
  std::string names, types;
  for (const auto& column : columns) {
    names += " " + column.name;
    for (const auto& [name, type] : type_names) {
      if (type == column.type) types += fmt::format(" {}", name);
    }
  }
  std::string text = fmt::format("#{}\n# types{}\n", names, types);
  for (const auto& pose : cloud.sensor_poses)
    text += fmt::format("# {} {}\n", pose_comment, pose_text(pose));
  if (cloud.height > 1) text += fmt::format("# organized {} {}\n", cloud.width, cloud.height);
  return text + text_records(cloud, columns);
}

}  // namespace scanchor
