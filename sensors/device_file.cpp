#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/file.hpp"
#include "sensors/tilting_lidar.hpp"

// A device in YAML: option names and values, with `preset` naming the device that it differs from.
//
//     preset: utm-30lx
//     lines: 278
//     encoder_sigma_deg: 0.02

namespace scanchor {
namespace {

std::string place(const YAML::Mark& mark) { return fmt::format("line {}", mark.line + 1); }

std::string scalar(const YAML::Node& value, const std::string& file, const std::string& name) {
  if (!value.IsScalar()) {
    fail_data(file, place(value.Mark()), fmt::format("option {} wants one value", name));
  }
  return value.Scalar();
}

}  // namespace

LidarOptions read_lidar_options(const std::filesystem::path& path) {
  const std::string file = path.string();
  const std::string text = read_file(path);
  YAML::Node root;
  try {
    root = YAML::Load(text);
  } catch (const YAML::Exception& error) {
    fail_data(file, place(error.mark), error.msg);
  }
  if (!root.IsMap()) {
    fail_data(file, "line 1", "no map of option names to values",
              "write lines like 'range_sigma: 0.01'");
  }
  LidarOptions options;
  try {
    if (root["preset"]) options = lidar_preset(scalar(root["preset"], file, "preset"));
  } catch (const Error& error) {
    fail_data(file, place(root["preset"].Mark()), error.what());
  }
  OptionList list;
  options.describe(list);
  std::vector<std::string> seen;
  for (const auto& entry : root) {
    const std::string name = scalar(entry.first, file, "name");
    const std::string where = place(entry.first.Mark());
    if (std::find(seen.begin(), seen.end(), name) != seen.end()) {
      fail_data(file, where, fmt::format("option {} is given twice", name));
    }
    seen.push_back(name);
    if (name == "preset") continue;
    const std::string value = scalar(entry.second, file, name);
    try {
      list.set(name, value);
    } catch (const Error& error) {
      fail_data(file, where, error.what());
    }
  }
  try {
    check_lidar_options(options);
  } catch (const Error& error) {
    fail_data(file, "", error.what());
  }
  return options;
}

}  // namespace scanchor
