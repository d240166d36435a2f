#pragma once
// An entity as the relations see it: its numbers in the levelled frame, in which z is up.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <vector>

#include "perception/surface.hpp"

namespace scanchor {

/// A measured number and its standard deviation; `hidden` in [0, 1) is the share expected in the
/// shadow, 0: seen whole.
struct Quantity {
  double value = 0.0;
  double sigma = 0.0;
  double hidden = 0.0;
};

/// The shadow of an entity on the ground: a parallelogram, center -+ u -+ v [m], thickened to a
/// width of at least 5 cm.
struct Footprint {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  Eigen::Vector2d u = Eigen::Vector2d::UnitX();
  Eigen::Vector2d v = Eigen::Vector2d::UnitY();
  [[nodiscard]] double area() const;  ///< [m2]
};

/// A surface or a group, in the levelled frame [m].
struct Item {
  std::int32_t id = 0;
  bool group = false;
  bool has_shape = true;  ///< false: perception stopped at the plane, or the shape is degenerate
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  Eigen::Matrix3d normal_covariance = Eigen::Matrix3d::Zero();  ///< [rad2]
  double tilt_sigma = 0.0;                                      ///< [rad] sqrt(trace / 2)
  double offset_sigma = 0.0;                           ///< [m] of the plane at its centroid
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  ///< of the inliers
  Eigen::Vector3d center =
      Eigen::Vector3d::Zero();  ///< of the fitted rectangle, or of the group's box
  Eigen::Vector3d along = Eigen::Vector3d::UnitX();   ///< unit, along the longer side
  Eigen::Vector3d across = Eigen::Vector3d::UnitY();  ///< unit, along the shorter side
  double half_length = 0.0, half_width = 0.0;         ///< [m]
  /// Share of the outline that faces each side (towards along, away, towards across, away) and ends
  /// in a shadow or at the end of the view: there the thing may go on.
  std::array<double, 4> open = {0.0, 0.0, 0.0, 0.0};
  double edge_sigma = 0.0;  ///< [m] of a side of the rectangle; the sizes' own deviations hold
                            ///< other readings of a side as well
  Quantity area, extension, width, height, rectangularness;
  double z_low = 0.0, z_high = 0.0, z = 0.0;  ///< lower end, upper end, middle
  double z_sigma = 0.0;
  Footprint footprint;
  Eigen::AlignedBox3d box;
  std::vector<std::int32_t> members;  ///< of a group, item ids, lowest first
};

/// Rotation that carries `up` (unit) to z.
Eigen::Matrix3d levelling(const Eigen::Vector3d& up);

/// True if the two are the same to the last bit in everything that relations look at.
bool same_geometry(const Item& a, const Item& b);

/// For each item the first one of the same geometry, itself if there is none in front of it.
std::vector<std::int32_t> first_of_twins(const std::vector<Item>& items);

/// One item a surface, in the same order, ids from 0.
std::vector<Item> make_items(const Surfaces& surfaces, const Eigen::Matrix3d& R_level_cloud);

/// [rad] deviation of each of the two tilts of a normal, of its covariance.
double tilt_sigma_of(const Eigen::Matrix3d& normal_covariance);

/// The box around some items, its sides along those of the first (largest) one; z up. Members
/// lowest first.
Item make_group(const std::vector<Item>& items, std::vector<std::int32_t> members, std::int32_t id);

}  // namespace scanchor
