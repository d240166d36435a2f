#pragma once
// The cloud as one sensor position saw it: rays sorted by direction, so that the rays beside a ray
// are found at once. What lies beyond the edge of a surface, something farther (a true edge),
// something nearer (a shadow) or nothing, is a question to these rays.

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "cloud/point_cloud.hpp"

namespace scanchor {

/// One ray and what it met, in one line of the processor's memory.
struct ShapeRay {
  Eigen::Vector3d point;      ///< [m] in the cloud's frame
  Eigen::Vector3d direction;  ///< unit vector from the sensor
  double range;               ///< [m]
  std::uint32_t index;        ///< of the point in the cloud
  std::int32_t plane;         ///< that owns the point, -1: none
};

/// Rays of one sensor position in the cells of a cube map, cell by cell in memory, so that the
/// surfaces need not gather their points one by one. Immutable after construction. Independent of
/// the order of the points, but for the order of equal points.
class ShapeView {
 public:
  /// owner of a cell that holds no ray, or rays of several planes.
  static constexpr std::int32_t empty = -3;
  static constexpr std::int32_t mixed = -2;

  /// Non-finite points and points at the sensor itself are left out. plane_of_point: -1 for none.
  ShapeView(const PointCloud& cloud, const Eigen::Vector3d& sensor,
            const std::vector<std::int32_t>& plane_of_point);

  [[nodiscard]] const Eigen::Vector3d& sensor() const { return sensor_; }
  /// [rad] side of a cell at the middle of a face of the cube: about two spacings of the rays.
  [[nodiscard]] double cell_angle() const { return 2.0 / side_; }
  [[nodiscard]] std::uint32_t cell_count() const {
    return static_cast<std::uint32_t>(owner_.size());
  }
  /// Cell of a direction, which need not have length 1.
  [[nodiscard]] std::uint32_t cell_of(const Eigen::Vector3d& direction) const;
  /// The plane that owns all rays of the cell, or `empty`, or `mixed`; -1: rays of no plane.
  [[nodiscard]] std::int32_t owner(std::uint32_t cell) const { return owner_[cell]; }
  /// All rays of the cell and of the eight around it belong to one plane.
  [[nodiscard]] bool is_deep(std::uint32_t cell) const { return deep_[cell] != 0; }
  /// The rays in a cell, by x, then y, then z of their points.
  [[nodiscard]] std::span<const ShapeRay> rays(std::uint32_t cell) const {
    return {rays_.data() + begin_[cell], rays_.data() + begin_[cell + 1]};
  }
  /// The rays of a plane, cell by cell: a sequence without a trace of the order of the points, so
  /// that sums over it have the same bits for any. To be asked for with ray().
  [[nodiscard]] std::span<const std::uint32_t> plane_rays(std::int32_t plane) const {
    return of_plane(plane, plane_begin_, plane_order_);
  }
  [[nodiscard]] const ShapeRay& ray(std::uint32_t place) const { return rays_[place]; }
  /// The cells that hold a ray of the plane, each once, rising.
  [[nodiscard]] std::span<const std::uint32_t> plane_cells(std::int32_t plane) const {
    return of_plane(plane, plane_cell_begin_, plane_cell_);
  }
  /// The eight cells around a cell, also across the edges of the cube (there some may repeat).
  [[nodiscard]] std::array<std::uint32_t, 8> around(std::uint32_t cell) const;

 private:
  Eigen::Vector3d sensor_;
  int side_ = 1;  ///< cells along an edge of the cube
  std::vector<ShapeRay> rays_;
  std::vector<std::uint32_t> begin_;
  std::vector<std::uint32_t> plane_begin_, plane_order_;
  std::vector<std::uint32_t> plane_cell_begin_, plane_cell_;
  std::vector<std::int32_t> owner_;
  std::vector<char> deep_;

  void fill_cells(const PointCloud& cloud, const std::vector<std::int32_t>& plane_of_point,
                  const std::vector<std::uint32_t>& cell_of_point);
  void find_deep_cells();
  void list_planes();
  static std::span<const std::uint32_t> of_plane(std::int32_t plane,
                                                 const std::vector<std::uint32_t>& begin,
                                                 const std::vector<std::uint32_t>& list) {
    const auto p = static_cast<std::size_t>(plane);
    if (p + 1 >= begin.size()) return {};
    return {list.data() + begin[p], list.data() + begin[p + 1]};
  }
};

}  // namespace scanchor
