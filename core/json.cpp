#include "core/json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/text.hpp"

namespace scanchor {
namespace {

/// The value as text, cut to what fits on a line of an error.
std::string brief(const Json& json) {
  std::string text = json.dump(-1, ' ', true, Json::error_handler_t::replace);
  if (text.size() > 60) text = text.substr(0, 57) + "...";
  return text;
}

}  // namespace

Json read_json(const std::filesystem::path& path) {
  const std::string content = read_file(path);
  if (content.empty()) fail_data(path.string(), "", "is empty, JSON was expected");
  try {
    return Json::parse(content);
  } catch (const nlohmann::json::parse_error& error) {
    std::size_t line = 1;
    std::size_t column = 1;
    const std::size_t end =
        std::min<std::size_t>(error.byte > 0 ? error.byte - 1 : 0, content.size());
    for (std::size_t i = 0; i < end; ++i) {
      ++column;
      if (content[i] == '\n') {
        ++line;
        column = 1;
      }
    }
    fail_data(path.string(), fmt::format("line {}, column {}", line, column),
              end >= content.size() ? "JSON ends too early" : "is no valid JSON here");
  } catch (const nlohmann::json::out_of_range&) {
    fail_data(path.string(), "", "holds a number that is too large");
  }
}

void write_json(const std::filesystem::path& path, const Json& json) {
  // Names of files need not be UTF-8; a replacement character beats an exception.
  write_file(path, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

JsonReader::JsonReader(const Json& json, std::string file, std::string place)
    : json_(&json), file_(std::move(file)), place_(std::move(place)) {}

void JsonReader::fail(const std::string& cause, const std::string& remedy) const {
  fail_data(file_, place_, cause, remedy);
}

bool JsonReader::has(const std::string& key) const {
  return json_->is_object() && json_->contains(key);
}

JsonReader JsonReader::at(const std::string& key) const {
  if (!json_->is_object()) fail("must be an object");
  const auto found = json_->find(key);
  if (found == json_->end()) fail(fmt::format("'{}' is missing", key));
  return {*found, file_, place_.empty() ? key : place_ + "." + key};
}

JsonReader JsonReader::at(std::size_t index) const {
  if (index >= size()) fail(fmt::format("has no element {}", index));
  return {(*json_)[index], file_, fmt::format("{}[{}]", place_, index)};
}

std::size_t JsonReader::size() const {
  if (!json_->is_array()) fail("must be a list");
  return json_->size();
}

std::vector<std::string> JsonReader::keys() const {
  if (!json_->is_object()) fail("must be an object");
  std::vector<std::string> names;
  for (const auto& item : json_->items()) names.push_back(item.key());
  return names;
}

double JsonReader::number() const {
  if (!json_->is_number()) fail(fmt::format("must be a number, is {}", brief(*json_)));
  const auto value = json_->get<double>();
  if (!std::isfinite(value)) fail("must be a finite number");
  return value;
}

double JsonReader::number_in(double minimum, double maximum) const {
  const double value = number();
  if (value < minimum || value > maximum) {
    fail(fmt::format("must lie in {} .. {}, is {}", minimum, maximum, value));
  }
  return value;
}

std::int64_t JsonReader::integer() const {
  if (!json_->is_number_integer())
    fail(fmt::format("must be a whole number, is {}", brief(*json_)));
  if (json_->is_number_unsigned() && json_->get<std::uint64_t>() > std::uint64_t{INT64_MAX})
    fail("is too large");
  return json_->get<std::int64_t>();
}

std::uint64_t JsonReader::natural() const {
  if (!json_->is_number_unsigned())
    fail(fmt::format("must be a whole number from 0, is {}", brief(*json_)));
  return json_->get<std::uint64_t>();
}

bool JsonReader::boolean() const {
  if (!json_->is_boolean()) fail(fmt::format("must be true or false, is {}", brief(*json_)));
  return json_->get<bool>();
}

std::string JsonReader::text() const {
  if (!json_->is_string()) fail(fmt::format("must be a text, is {}", brief(*json_)));
  return json_->get<std::string>();
}

Eigen::Vector3d JsonReader::vector3() const {
  if (size() != 3) fail("must be three numbers");
  return {at(std::size_t{0}).number(), at(1).number(), at(2).number()};
}

Eigen::Vector2d JsonReader::vector2() const {
  if (size() != 2) fail("must be two numbers");
  return {at(std::size_t{0}).number(), at(1).number()};
}

Eigen::Isometry3d JsonReader::pose() const {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  const JsonReader q = at("quaternion");
  if (q.size() != 4) q.fail("must be four numbers w, x, y, z");
  Eigen::Quaterniond rotation(q.at(std::size_t{0}).number(), q.at(1).number(), q.at(2).number(),
                              q.at(3).number());
  if (std::abs(rotation.norm() - 1.0) > 1e-3) q.fail("must have length 1");
  pose.linear() = rotation.normalized().toRotationMatrix();
  pose.translation() = at("position").vector3();
  return pose;
}

void JsonReader::only(const std::vector<std::string>& known) const {
  for (const auto& key : keys()) {
    bool found = false;
    for (const auto& name : known) found = found || name == key;
    if (!found) fail(fmt::format("unknown key '{}'", key), suggestion(key, known));
  }
}

Json to_json(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
Json to_json(const Eigen::Vector2d& v) { return {v.x(), v.y()}; }

Json to_json(const Eigen::Isometry3d& pose) {
  Eigen::Quaterniond q(pose.linear());
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  return {{"position", to_json(Eigen::Vector3d(pose.translation()))},
          {"quaternion", {q.w(), q.x(), q.y(), q.z()}}};
}

}  // namespace scanchor
