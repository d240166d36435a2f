#include "cloud/kitti.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstring>

#include "cloud/columns.hpp"
#include "core/error.hpp"

namespace scanchor {
namespace {

constexpr bool big_machine = std::endian::native == std::endian::big;

void put_little(char*& out, std::uint32_t word) {
  if constexpr (big_machine) word = __builtin_bswap32(word);
  std::memcpy(out, &word, 4);
  out += 4;
}

std::uint32_t sixteen_bits(const Field* field, std::size_t i, const std::string& file) {
  if (field == nullptr) return 0;
  const double value = field->at(i);
  if (!(value <= 65535.0)) {
    fail_data(
        file, fmt::format("point {}", i),
        fmt::format("the {} {} does not fit the 16 bits of a .label file", field->name, value));
  }
  return value > 0.0 ? static_cast<std::uint32_t>(value) : 0U;
}

}  // namespace

PointCloud parse_kitti(std::string_view content, const std::string& file, int columns) {
  std::vector<Column> layout = {{"x", ScalarType::f32},
                                {"y", ScalarType::f32},
                                {"z", ScalarType::f32},
                                {"intensity", ScalarType::f32}};
  if (columns == 5) layout.push_back({"ring", ScalarType::f32});
  const std::size_t record = lay_out_records(layout);
  if (content.size() % record != 0) {
    fail_data(file, "",
              fmt::format("has {} bytes, which is no multiple of the {} of a point", content.size(),
                          record),
              "the file is truncated or of another format");
  }
  return cloud_from_columns(layout, content, content.size() / record, big_machine, file);
}

void add_kitti_labels(PointCloud& cloud, std::string_view content, const std::string& file) {
  if (content.size() != 4 * cloud.size()) {
    fail_data(file, "",
              fmt::format("expected {} bytes for the labels of {} points, found {}",
                          4 * cloud.size(), cloud.size(), content.size()));
  }
  std::vector<std::uint16_t> label(cloud.size()), instance(cloud.size());
  const auto byte = [&](std::size_t at) {
    return static_cast<unsigned>(static_cast<unsigned char>(content[at]));
  };
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    label[i] = static_cast<std::uint16_t>(byte(4 * i) | byte(4 * i + 1) << 8);
    instance[i] = static_cast<std::uint16_t>(byte(4 * i + 2) | byte(4 * i + 3) << 8);
  }
  cloud.set({"label", std::move(label)});
  cloud.set({"instance", std::move(instance)});
}

std::string format_kitti(const PointCloud& cloud) {
  const Field* field = cloud.find("intensity");
  const auto* intensity =
      field != nullptr ? std::get_if<std::vector<float>>(&field->values) : nullptr;
  std::string bytes(16 * cloud.size(), '\0');
  char* out = bytes.data();
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    for (int k = 0; k < 3; ++k)
      put_little(out, std::bit_cast<std::uint32_t>(static_cast<float>(cloud.points[i][k])));
    const float value = intensity != nullptr ? (*intensity)[i]
                        : field != nullptr   ? static_cast<float>(field->at(i))
                                             : 0.0F;
    put_little(out, std::bit_cast<std::uint32_t>(value));
  }
  return bytes;
}

std::string format_kitti_labels(const PointCloud& cloud, const std::string& file) {
  const Field* label = cloud.find("label");
  const Field* instance = cloud.find("instance");
  std::string bytes(4 * cloud.size(), '\0');
  char* out = bytes.data();
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    put_little(out, sixteen_bits(label, i, file) | sixteen_bits(instance, i, file) << 16);
  }
  return bytes;
}

}  // namespace scanchor
