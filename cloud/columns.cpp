#include "cloud/columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <set>
#include <utility>

#include "cloud/text_lines.hpp"
#include "core/error.hpp"

namespace scanchor {
namespace {

/// Calls body(T{}) with the C++ type of a scalar type.
template <class Body>
decltype(auto) with_type(ScalarType type, Body&& body) {
  switch (type) {
    case ScalarType::i8:
      return body(std::int8_t{});
    case ScalarType::u8:
      return body(std::uint8_t{});
    case ScalarType::i16:
      return body(std::int16_t{});
    case ScalarType::u16:
      return body(std::uint16_t{});
    case ScalarType::i32:
      return body(std::int32_t{});
    case ScalarType::u32:
      return body(std::uint32_t{});
    case ScalarType::i64:
      return body(std::int64_t{});
    case ScalarType::u64:
      return body(std::uint64_t{});
    case ScalarType::f32:
      return body(float{});
    case ScalarType::f64:
      break;
  }
  return body(double{});
}

template <class T>
T load(const char* bytes, bool swap) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), bytes, sizeof(T));
  if (swap) std::reverse(raw.begin(), raw.end());
  return std::bit_cast<T>(raw);
}

template <class Target>
std::vector<Target> values_as(const Column& column, const char* bytes, std::size_t count,
                              bool swap) {
  std::vector<Target> values(count);
  with_type(column.type, [&](auto sample) {
    using T = decltype(sample);
    const char* at = bytes + column.offset;
    for (std::size_t i = 0; i < count; ++i, at += column.stride) {
      values[i] = static_cast<Target>(load<T>(at, swap));
    }
  });
  return values;
}

/// 64-bit integers have no field type of their own: the smallest type that holds them all exactly,
/// else the nearest doubles.
template <class T>
Field wide_integers(const Column& column, const char* bytes, std::size_t count, bool swap) {
  const std::vector<T> values = values_as<T>(column, bytes, count, swap);
  const auto fits = [&](auto low, auto high) {
    return std::all_of(values.begin(), values.end(), [&](T v) {
      return std::cmp_greater_equal(v, low) && std::cmp_less_equal(v, high);
    });
  };
  if (fits(INT32_MIN, INT32_MAX))
    return {column.name, std::vector<std::int32_t>(values.begin(), values.end())};
  if (fits(0, UINT32_MAX))
    return {column.name, std::vector<std::uint32_t>(values.begin(), values.end())};
  return {column.name, std::vector<double>(values.begin(), values.end())};
}

Field decode_field(const Column& column, const char* bytes, std::size_t count, bool swap) {
  switch (column.type) {
    case ScalarType::i8:
    case ScalarType::i16:
    case ScalarType::i32:
      return {column.name, values_as<std::int32_t>(column, bytes, count, swap)};
    case ScalarType::u8:
      return {column.name, values_as<std::uint8_t>(column, bytes, count, swap)};
    case ScalarType::u16:
      return {column.name, values_as<std::uint16_t>(column, bytes, count, swap)};
    case ScalarType::u32:
      return {column.name, values_as<std::uint32_t>(column, bytes, count, swap)};
    case ScalarType::i64:
      return wide_integers<std::int64_t>(column, bytes, count, swap);
    case ScalarType::u64:
      return wide_integers<std::uint64_t>(column, bytes, count, swap);
    case ScalarType::f32:
      return {column.name, values_as<float>(column, bytes, count, swap)};
    case ScalarType::f64:
      break;
  }
  return {column.name, values_as<double>(column, bytes, count, swap)};
}

template <class T>
bool parse_number(std::string_view token, char* out) {
  T value{};
  auto result = std::from_chars(token.data(), token.data() + token.size(), value);
  if (result.ec == std::errc::result_out_of_range && std::is_floating_point_v<T>) {
    // Too small or too large for the type: what a C reader gives, zero or infinity.
    double wide = 0.0;
    const auto again = std::from_chars(token.data(), token.data() + token.size(), wide);
    if (again.ec == std::errc::result_out_of_range) {
      const auto e = token.find_first_of("eE");
      const bool tiny = e != std::string_view::npos && token.find('-', e) != std::string_view::npos;
      wide = tiny ? 0.0 : std::numeric_limits<double>::infinity();
      if (token.front() == '-') wide = -wide;
    }
    value = static_cast<T>(wide);
    result = {again.ptr, std::errc{}};
  }
  if (result.ec != std::errc{} || result.ptr != token.data() + token.size()) return false;
  std::memcpy(out, &value, sizeof(T));
  return true;
}

template <class T>
bool parse_whole(std::string_view token, char* out) {
  if (parse_number<T>(token, out)) return true;
  double real = 0.0;  // "3.0", "1e3": whole numbers as a table program writes them
  if (!parse_number<double>(token, reinterpret_cast<char*>(&real))) return false;
  constexpr double two_to_53 = 9007199254740992.0;
  if (!(std::fabs(real) <= two_to_53) || real != std::floor(real)) return false;
  const auto whole = static_cast<std::int64_t>(real);
  if (!std::in_range<T>(whole)) return false;
  const T value = static_cast<T>(whole);
  std::memcpy(out, &value, sizeof(T));
  return true;
}

ScalarType type_of(const Field& field) {
  static constexpr ScalarType types[] = {ScalarType::f32, ScalarType::f64, ScalarType::i32,
                                         ScalarType::u32, ScalarType::u16, ScalarType::u8};
  return types[field.values.index()];
}

/// Calls body(value) with the typed value of a column at point i.
template <class Body>
void with_value(const PointCloud& cloud, const OutColumn& column, std::size_t i, Body&& body) {
  if (column.axis >= 0) {
    const double v = cloud.points[i][column.axis];
    if (column.type == ScalarType::f32)
      body(static_cast<float>(v));
    else
      body(v);
  } else {
    std::visit([&](const auto& values) { body(values[i]); }, column.field->values);
  }
}

template <class T>
void store_little(char* out, T value) {
  auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
  if constexpr (std::endian::native == std::endian::big) std::reverse(raw.begin(), raw.end());
  std::memcpy(out, raw.data(), sizeof(T));
}

void pack_into(std::string& bytes, const PointCloud& cloud, const OutColumn& column,
               std::size_t offset, std::size_t stride) {
  char* at = bytes.data() + offset;
  for (std::size_t i = 0; i < cloud.size(); ++i, at += stride) {
    with_value(cloud, column, i, [at](auto value) { store_little(at, value); });
  }
}

}  // namespace

std::size_t scalar_size(ScalarType type) {
  return with_type(type, [](auto sample) { return sizeof(sample); });
}

std::size_t lay_out_records(std::vector<Column>& columns) {
  std::size_t size = 0;
  for (auto& column : columns) {
    column.offset = size;
    size += scalar_size(column.type);
  }
  for (auto& column : columns) column.stride = size;
  return size;
}

PointCloud cloud_from_columns(const std::vector<Column>& columns, std::string_view bytes,
                              std::size_t count, bool swap_bytes, const std::string& file) {
  PointCloud cloud;
  std::set<std::string_view> names;
  for (const auto& column : columns) {
    if (!names.insert(column.name).second) {
      fail_data(file, "header", fmt::format("names the field '{}' twice", column.name));
    }
  }
  for (const char* axis : {"x", "y", "z"}) {
    if (!names.contains(axis)) {
      fail_data(file, "header", fmt::format("has no field '{}'", axis), "a point needs x, y and z");
    }
  }
  cloud.points.resize(count);
  for (const auto& column : columns) {
    if (column.name == "x" || column.name == "y" || column.name == "z") {
      const int axis = column.name[0] - 'x';
      with_type(column.type, [&](auto sample) {
        using T = decltype(sample);
        const char* at = bytes.data() + column.offset;
        for (std::size_t i = 0; i < count; ++i, at += column.stride) {
          cloud.points[i][axis] = static_cast<double>(load<T>(at, swap_bytes));
        }
      });
    } else {
      cloud.fields.push_back(decode_field(column, bytes.data(), count, swap_bytes));
    }
  }
  return cloud;
}

bool parse_scalar(std::string_view token, ScalarType type, char* out) {
  if (token.size() > 1 && token.front() == '+') token.remove_prefix(1);
  if (token.empty()) return false;
  return with_type(type, [&](auto sample) {
    using T = decltype(sample);
    if constexpr (std::is_floating_point_v<T>) {
      if (parse_number<T>(token, out)) return true;
      // How older Windows libraries print what is no number: 1.#QNAN, -1.#IND, 1.#INF.
      if (token.find("#QNAN") == std::string_view::npos &&
          token.find("#IND") == std::string_view::npos) {
        return false;
      }
      const T nan = std::numeric_limits<T>::quiet_NaN();
      std::memcpy(out, &nan, sizeof(T));
      return true;
    } else {
      return parse_whole<T>(token, out);
    }
  });
}

std::vector<OutColumn> columns_of(const PointCloud& cloud, const std::string& file) {
  const bool organized = cloud.width != 0 || cloud.height != 0;
  if (organized &&
      (cloud.width < 1 || cloud.height < 1 ||
       static_cast<std::uint64_t>(cloud.width) * static_cast<std::uint64_t>(cloud.height) !=
           cloud.size())) {
    fail_data(file, "",
              fmt::format("cannot be written: {} points are not {} x {}", cloud.size(), cloud.width,
                          cloud.height));
  }
  const bool narrow =
      std::all_of(cloud.points.begin(), cloud.points.end(), [](const Eigen::Vector3d& p) {
        for (int k = 0; k < 3; ++k) {
          if (static_cast<double>(static_cast<float>(p[k])) != p[k] && !std::isnan(p[k]))
            return false;
        }
        return true;
      });
  const ScalarType position = narrow ? ScalarType::f32 : ScalarType::f64;
  std::vector<OutColumn> columns = {{"x", position, 0}, {"y", position, 1}, {"z", position, 2}};
  std::set<std::string> names = {"x", "y", "z"};
  for (const auto& field : cloud.fields) {
    if (field.size() != cloud.size()) {
      fail_data(file, "",
                fmt::format("cannot be written: the field '{}' has {} values for {} points",
                            field.name, field.size(), cloud.size()));
    }
    std::string name = field.name;
    for (char& c : name) {
      if (static_cast<unsigned char>(c) <= ' ' || c == ',' || c == ';') c = '_';
    }
    // "_" means padding in PCD.
    if (name.empty() || name == "_" || !names.insert(name).second) {
      fail_data(
          file, "",
          fmt::format("cannot be written: '{}' cannot be the name of a field here", field.name));
    }
    columns.push_back({name, type_of(field), -1, &field});
  }
  return columns;
}

std::string pack_records(const PointCloud& cloud, const std::vector<OutColumn>& columns) {
  std::size_t stride = 0;
  for (const auto& column : columns) stride += scalar_size(column.type);
  std::string bytes(stride * cloud.size(), '\0');
  std::size_t offset = 0;
  for (const auto& column : columns) {
    pack_into(bytes, cloud, column, offset, stride);
    offset += scalar_size(column.type);
  }
  return bytes;
}

std::string pack_columns(const PointCloud& cloud, const std::vector<OutColumn>& columns) {
  std::size_t stride = 0;
  for (const auto& column : columns) stride += scalar_size(column.type);
  std::string bytes(stride * cloud.size(), '\0');
  std::size_t offset = 0;
  for (const auto& column : columns) {
    pack_into(bytes, cloud, column, offset, scalar_size(column.type));
    offset += scalar_size(column.type) * cloud.size();
  }
  return bytes;
}

std::string text_records(const PointCloud& cloud, const std::vector<OutColumn>& columns) {
  std::string text;
  text.reserve(cloud.size() * columns.size() * 10);
  char buffer[40];
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    for (std::size_t k = 0; k < columns.size(); ++k) {
      with_value(cloud, columns[k], i, [&](auto value) {
        if (value != value) {
          text += "nan";  // to_chars would print the sign of a NaN too
        } else {
          text.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
        }
      });
      text += k + 1 < columns.size() ? ' ' : '\n';
    }
  }
  return text;
}

std::string pose_text(const Eigen::Isometry3d& pose) {
  Eigen::Quaterniond q(pose.linear());
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  const Eigen::Vector3d t = pose.translation();
  return fmt::format("{} {} {} {} {} {} {}", t.x(), t.y(), t.z(), q.w(), q.x(), q.y(), q.z());
}

bool parse_pose(std::string_view text, Eigen::Isometry3d& pose) {
  std::array<double, 7> v{};
  for (double& value : v) {
    const std::string_view token = next_token(text);
    if (!parse_scalar(token, ScalarType::f64, reinterpret_cast<char*>(&value)) ||
        !std::isfinite(value)) {
      return false;
    }
  }
  const Eigen::Quaterniond q(v[3], v[4], v[5], v[6]);
  if (!next_token(text).empty() || q.norm() < 1e-6) return false;
  pose = Eigen::Isometry3d::Identity();
  pose.translation() = Eigen::Vector3d(v[0], v[1], v[2]);
  pose.linear() = q.normalized().toRotationMatrix();
  return true;
}

}  // namespace scanchor
