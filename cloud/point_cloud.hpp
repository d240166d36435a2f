#pragma once
// The value that the sensor makes and the perception reads.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace scanchor {

/// A named column of numbers, one a point: "intensity", "label", "instance", "plane", or whatever a
/// file brought along.
struct Field {
  std::string name;
  std::variant<std::vector<float>, std::vector<double>, std::vector<std::int32_t>,
               std::vector<std::uint32_t>, std::vector<std::uint16_t>, std::vector<std::uint8_t>>
      values;
  [[nodiscard]] std::size_t size() const;
  /// Value i, whatever the type.
  [[nodiscard]] double at(std::size_t i) const;
};

/// Points in a frame that the file or the caller names, z up where nothing else is said. Points may
/// be non-finite (a depth camera marks missing returns so); whoever reads them sets those aside and
/// counts them.
struct PointCloud {
  std::vector<Eigen::Vector3d> points;  ///< [m]
  std::vector<Field> fields;            ///< each as long as `points`
  int width = 0;                        ///< columns of an organized cloud; 0: unorganized
  int height = 0;                       ///< rows of an organized cloud; 0: unorganized
  /// Where the sensor stood, T_cloud_sensor. Empty: unknown. More than one: a merged cloud.
  std::vector<Eigen::Isometry3d> sensor_poses;

  [[nodiscard]] std::size_t size() const { return points.size(); }
  /// The field of that name, or nullptr.
  [[nodiscard]] const Field* find(std::string_view name) const;
  /// Adds or replaces a field; its length must be that of `points`.
  void set(Field field);
};

}  // namespace scanchor
