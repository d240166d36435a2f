#pragma once
// Where things are in each other's way: oriented boxes of parts, floor that can be walked on, and
// faces that lie too near.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "scenes/scene.hpp"

namespace scanchor {

/// The box of one part in its own frame, in the world. Exact for box parts, a hull for others.
struct OrientedBox {
  Eigen::Vector3d center;
  Eigen::Matrix3d axes;  ///< columns: unit directions of the sides
  Eigen::Vector3d half;  ///< [m] half sides
};
std::vector<OrientedBox> part_boxes(const Instance& instance);
Eigen::AlignedBox3d bounds_of(const OrientedBox& box);

/// Whether two boxes come nearer than `gap` [m] (negative: overlap by more than that), by the 15
/// separating axes (Gottschalk, Lin, Manocha, "OBBTree", SIGGRAPH 1996). Between skew edges the
/// test errs to the side of "near".
bool boxes_near(const OrientedBox& a, const OrientedBox& b, double gap);

/// Pairs of things whose parts overlap by more than `tolerance` [m]: one line each, "desk 7 'top'
/// and box 12 'box'". Floor, walls and ceiling are left out: what stands in a wall's opening
/// belongs there.
std::vector<std::string> interpenetrations(const Scene& scene, double tolerance);

/// Two triangles of different faces that are parallel within 0.1 degrees, overlap by more than a
/// sliver when seen along their normal, and come nearer than `distance` [m].
struct ClosePair {
  std::int32_t face_a, face_b;  ///< indices into all_faces
  double distance;              ///< [m] smallest
  bool same_side;               ///< the normals point the same way: a ray can tie between them
};
std::vector<ClosePair> close_parallel_faces(const Scene& scene, double distance);

/// The floor of a room as a grid of cells, and which a person or robot of some radius can reach.
struct FloorGrid {
  Eigen::Vector2d low = Eigen::Vector2d::Zero();
  double cell = 0.05;  ///< [m]
  int nx = 0;
  int ny = 0;
  std::vector<std::uint8_t> free;       ///< 1: no obstacle nearer than the radius
  std::vector<std::uint8_t> reachable;  ///< 1: joined to the start
  [[nodiscard]] bool inside(int x, int y) const { return x >= 0 && y >= 0 && x < nx && y < ny; }
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(x);
  }
  /// [m] middle of a cell.
  [[nodiscard]] Eigen::Vector2d center(int x, int y) const {
    return low + cell * Eigen::Vector2d(x + 0.5, y + 0.5);
  }
  [[nodiscard]] bool is_free(const Eigen::Vector2d& p) const;
  [[nodiscard]] bool is_reachable(const Eigen::Vector2d& p) const;
  /// Whether a reachable cell lies within `distance` [m] of a place.
  [[nodiscard]] bool reachable_near(const Eigen::Vector2d& p, double distance) const;
  /// Share of the free cells that are reachable.
  [[nodiscard]] double reachable_share() const;
};
/// Obstacles are the parts of all things but floor, walls, ceiling and doors that reach into z =
/// 0.03 .. 1.9 m.
FloorGrid walkable_floor(const Scene& scene, const Eigen::AlignedBox2d& room, double radius,
                         const Eigen::Vector2d& start);

}  // namespace scanchor
