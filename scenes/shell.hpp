#pragma once
// Floor, walls and ceiling. Walls are inner faces with the reveals of their openings: two rooms
// that share a wall each own their side of it.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "scenes/mesh.hpp"
#include "scenes/scene.hpp"

namespace scanchor {

/// The four sides of a room: south (y low), east (x high), north (y high), west (x low).
enum class Side { south, east, north, west };

/// An opening in a wall: distance along the wall from its left end as seen from inside, and height.
/// An opening that reaches the floor gets a threshold over the depth of its reveals.
struct WallOpening {
  Side side = Side::south;
  Opening opening;
};

/// A rectangular room: where it is, how high, of what.
struct RoomShell {
  Eigen::Vector2d low = Eigen::Vector2d::Zero();
  Eigen::Vector2d high = Eigen::Vector2d(5, 4);
  double height = 2.6;
  std::string floor_material = "linoleum";
  std::string wall_material = "paint white";
  std::string ceiling_material = "ceiling panel";
  std::vector<WallOpening> openings;
};

/// Length of a side.
double side_length(const RoomShell& room, Side side);
/// Frame of a side seen from inside: origin at the left end on the floor, x to the right along the
/// wall, y into the wall, z up.
Eigen::Isometry3d side_frame(const RoomShell& room, Side side);

/// Adds floor (a slab below z = 0), ceiling (a slab above) and four walls, with the next free ids.
/// The truth faces are the whole rectangles; a wall's area has its openings taken off.
void add_shell(Scene& scene, const RoomShell& room);

/// A room without openings from (0, 0, 0) to `size`.
void add_plain_room(Scene& scene, const Eigen::Vector3d& size);

/// The next free instance id.
std::int32_t next_id(const Scene& scene);

}  // namespace scanchor
