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

/// Rays of one sensor position in the cells of a cube map. Immutable after construction.
/// Independent of the order of the points, but for the order of equal points.
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
  /// Unit vector from the sensor to a point of the cloud.
  [[nodiscard]] const Eigen::Vector3d& direction(std::uint32_t point) const {
    return directions_[point];
  }
  /// Cell of a point of the cloud, cell_count() if it was left out.
  [[nodiscard]] std::uint32_t cell_of_point(std::uint32_t point) const {
    return cell_of_point_[point];
  }
  /// The plane that owns all rays of the cell, or `empty`, or `mixed`; -1: rays of no plane.
  [[nodiscard]] std::int32_t owner(std::uint32_t cell) const { return owner_[cell]; }
  /// The points of a plane, cell by cell: a sequence without a trace of the order of the points, so
  /// that sums over it have the same bits for any.
  [[nodiscard]] std::span<const std::uint32_t> plane_points(std::int32_t plane) const {
    const auto p = static_cast<std::size_t>(plane);
    if (p + 1 >= plane_begin_.size()) return {};
    return {plane_order_.data() + plane_begin_[p], plane_order_.data() + plane_begin_[p + 1]};
  }
  /// Indices of the points in a cell, by x, then y, then z.
  [[nodiscard]] std::span<const std::uint32_t> points(std::uint32_t cell) const {
    return {order_.data() + begin_[cell], order_.data() + begin_[cell + 1]};
  }
  /// The eight cells around a cell, also across the edges of the cube (there some may repeat).
  [[nodiscard]] std::array<std::uint32_t, 8> around(std::uint32_t cell) const;

 private:
  Eigen::Vector3d sensor_;
  int side_ = 1;  ///< cells along an edge of the cube
  std::vector<Eigen::Vector3d> directions_;
  std::vector<std::uint32_t> cell_of_point_;
  std::vector<std::uint32_t> begin_, order_;
  std::vector<std::uint32_t> plane_begin_, plane_order_;
  std::vector<std::int32_t> owner_;
};

}  // namespace scanchor
