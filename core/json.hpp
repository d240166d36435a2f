#pragma once
// JSON in and out, with errors that name the file and the place. Heavy: include it in .cpp files
// only.

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace scanchor {

using Json = nlohmann::ordered_json;

/// Reads a JSON file. Throws Error(bad_data): "scene.json: line 3, column 7: ...".
Json read_json(const std::filesystem::path& path);
/// Writes with two spaces of indent and a final newline, whole or not at all. Numbers are the
/// shortest text that reads back.
void write_json(const std::filesystem::path& path, const Json& json);

/// A view on one JSON object that knows where it is, so that a missing or wrong value is reported
/// as "scene.json: instances[3].size: must be a number above 0, is -1".
class JsonReader {
 public:
  JsonReader(const Json& json, std::string file, std::string place = "");
  [[nodiscard]] bool has(const std::string& key) const;
  [[nodiscard]] JsonReader at(const std::string& key) const;  ///< member; error if absent
  [[nodiscard]] JsonReader at(std::size_t index) const;       ///< element
  [[nodiscard]] std::size_t size() const;  ///< elements of an array; error if it is none
  [[nodiscard]] std::vector<std::string> keys() const;
  [[nodiscard]] double number() const;  ///< finite; error otherwise
  [[nodiscard]] double number_in(double minimum, double maximum) const;
  [[nodiscard]] std::int64_t integer() const;
  [[nodiscard]] std::uint64_t natural() const;  ///< whole number from 0 to 2^64 - 1: a seed
  [[nodiscard]] bool boolean() const;
  [[nodiscard]] std::string text() const;
  [[nodiscard]] Eigen::Vector3d vector3() const;
  [[nodiscard]] Eigen::Vector2d vector2() const;
  [[nodiscard]] Eigen::Isometry3d pose() const;  ///< {"position": [x,y,z], "quaternion": [w,x,y,z]}
  /// Error for every key that is not in the list, with a suggestion.
  void only(const std::vector<std::string>& known) const;
  [[nodiscard]] const Json& raw() const { return *json_; }
  [[noreturn]] void fail(const std::string& cause, const std::string& remedy = "") const;

 private:
  const Json* json_;
  std::string file_;
  std::string place_;
};

Json to_json(const Eigen::Vector3d& v);
Json to_json(const Eigen::Vector2d& v);
Json to_json(const Eigen::Isometry3d& pose);

}  // namespace scanchor
