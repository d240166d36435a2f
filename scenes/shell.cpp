#include "scenes/shell.hpp"

#include <algorithm>

#include "scenes/materials.hpp"
#include "scenes/pose.hpp"

namespace scanchor {
namespace {

constexpr double slab_thickness = 0.2;  // [m] thickness of floor and ceiling, which nobody sees
constexpr double seam = 0.0015;         // [m] between a threshold and the floor: more than 1 mm

void add_stuff(Scene& scene, ClassId id, const std::string& kind, Part part) {
  Instance instance;
  instance.id = next_id(scene);
  instance.class_id = id;
  instance.kind = kind;
  instance.parts.push_back(std::move(part));
  scene.instances.push_back(std::move(instance));
}

}  // namespace

std::int32_t next_id(const Scene& scene) {
  std::int32_t id = 1;
  for (const auto& instance : scene.instances) id = std::max(id, instance.id + 1);
  return id;
}

double side_length(const RoomShell& room, Side side) {
  const Eigen::Vector2d size = room.high - room.low;
  return side == Side::south || side == Side::north ? size.x() : size.y();
}

Eigen::Isometry3d side_frame(const RoomShell& room, Side side) {
  // x to the right as seen from inside, y outwards: exact quarter turns.
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  const auto set = [&](double x, double y, const Eigen::Vector3d& right,
                       const Eigen::Vector3d& out) {
    frame.linear().col(0) = right;
    frame.linear().col(1) = out;
    frame.translation() = Eigen::Vector3d(x, y, 0);
  };
  switch (side) {
    case Side::south:
      set(room.high.x(), room.low.y(), {-1, 0, 0}, {0, -1, 0});
      break;
    case Side::east:
      set(room.high.x(), room.high.y(), {0, -1, 0}, {1, 0, 0});
      break;
    case Side::north:
      set(room.low.x(), room.high.y(), {1, 0, 0}, {0, 1, 0});
      break;
    case Side::west:
      set(room.low.x(), room.low.y(), {0, 1, 0}, {-1, 0, 0});
      break;
  }
  return frame;
}

void add_shell(Scene& scene, const RoomShell& room) {
  const Eigen::Vector2d size = room.high - room.low;
  const Eigen::Vector2d middle = 0.5 * (room.low + room.high);
  const int ground = use_material(scene, room.floor_material);
  add_stuff(scene, *find_class("floor"), "floor",
            box_part("slab", ground, {middle.x(), middle.y(), -0.5 * slab_thickness},
                     {size.x(), size.y(), slab_thickness}));
  int thresholds = 0;
  for (const auto& [side, opening] : room.openings) {
    if (opening.low.y() > 0 || opening.depth <= 2 * seam) continue;
    // Under the door, a seam off the floor on both sides.
    const Eigen::Vector2d width = opening.high - opening.low;
    Part part = box_part(
        "threshold " + std::to_string(++thresholds), ground,
        {0.5 * (opening.low.x() + opening.high.x()), 0.5 * opening.depth, -0.5 * slab_thickness},
        {width.x(), opening.depth - 2 * seam, slab_thickness});
    part.T_instance_part = side_frame(room, side);
    scene.instances.back().parts.push_back(std::move(part));
  }
  add_stuff(scene, *find_class("ceiling"), "ceiling",
            box_part("slab", use_material(scene, room.ceiling_material),
                     {middle.x(), middle.y(), room.height + 0.5 * slab_thickness},
                     {size.x(), size.y(), slab_thickness}));
  const int paint = use_material(scene, room.wall_material);
  static constexpr const char* names[] = {"south", "east", "north", "west"};
  for (const Side side : {Side::south, Side::east, Side::north, Side::west}) {
    std::vector<Opening> openings;
    for (const auto& opening : room.openings) {
      if (opening.side == side) openings.push_back(opening.opening);
    }
    Part part = panel_part(names[static_cast<int>(side)], paint, side_length(room, side),
                           room.height, slab_thickness, openings, false, side_frame(room, side));
    add_stuff(scene, *find_class("wall"), "wall", std::move(part));
  }
  scene.bounds.extend(Eigen::Vector3d(room.low.x(), room.low.y(), 0));
  scene.bounds.extend(Eigen::Vector3d(room.high.x(), room.high.y(), room.height));
}

void add_plain_room(Scene& scene, const Eigen::Vector3d& size) {
  RoomShell room;
  room.high = {size.x(), size.y()};
  room.height = size.z();
  add_shell(scene, room);
}

}  // namespace scanchor
