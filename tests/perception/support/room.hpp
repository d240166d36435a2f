#pragma once
// A room of boxes and a ray caster of its own, so that planes are judged against exact truth
// without any other room of the house. The furniture of perception.md section 3 of the design: 6 x
// 5 x 2.8 m, desk, two monitors, five-board shelf, cabinet, chair, 17 boxes; a scanner at
// (0.9, 2.3, 1.4).

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "cloud/point_cloud.hpp"

namespace scanchor::support {

/// A box with its own planes: six faces, ids 6 * k .. 6 * k + 5 in the order -x, +x, -y, +y, -z,
/// +z.
struct Box {
  Eigen::Isometry3d T_world_box = Eigen::Isometry3d::Identity();
  Eigen::Vector3d half = Eigen::Vector3d::Ones();
  bool inside = false;  ///< seen from within: the walls of the room
};

struct RoomScan {
  PointCloud cloud;
  std::vector<std::int32_t> plane;    ///< id of the face, a point
  std::vector<double> incidence_cos;  ///< cosine between beam and face normal, a point
};

/// Seed 0: the furniture exactly where the design has it. Other seeds move, turn and resize it and
/// shuffle the boxes: thresholds are chosen on those, and reported on others.
std::vector<Box> reference_room(std::uint64_t seed);

struct RayGrid {
  int beams = 500, lines = 200;
  double horizontal_deg = 180.0, vertical_deg = 90.0, tilt_deg = -15.0;
  double range_sigma = 0.01;
  Eigen::Vector3d position = Eigen::Vector3d(0.9, 2.3, 1.4);
  std::uint64_t seed = 1;
};

/// One return a ray: nearest face, range noise N(0, sigma) along the ray.
RoomScan scan_boxes(const std::vector<Box>& boxes, const RayGrid& grid);

/// The same points in another order (Fisher-Yates from a seed); `plane` and the rest follow.
RoomScan shuffled(const RoomScan& scan, std::uint64_t seed);

}  // namespace scanchor::support
