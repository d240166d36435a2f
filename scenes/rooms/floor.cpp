// Corridors, and floors of several rooms along one.

#include <algorithm>
#include <cmath>

#include "scenes/pose.hpp"
#include "scenes/rooms/rooms.hpp"

namespace scanchor {
namespace {

constexpr double wall = 0.12;  // [m] between corridor and rooms, as add_door has it

double to_cm(double v) { return std::floor(v * 100.0 + 0.5) / 100.0; }

}  // namespace

RoomPlan plan_corridor(Scene& scene, SequentialRandom& random, const RoomOptions& options) {
  RoomPlan plan = plan_room(random, options, {8.0, 1.8}, {14.0, 2.6}, 2.4, 3.0);
  const double length = side_length(plan.shell, Side::south);
  // Doors of the rooms on both sides turn into those rooms; the way in is at the western end.
  add_door(scene, plan, random, Side::west, 0.5 * side_length(plan.shell, Side::west), "closed",
           true);
  for (const Side side : {Side::south, Side::north}) {
    const int doors = std::max(1, static_cast<int>(length / random.uniform(2.6, 4.5)));
    for (int i = 0; i < doors; ++i)
      add_door(scene, plan, random, side, length * (i + 0.5) / doors + random.uniform(-0.2, 0.2),
               "", true);
  }
  plan.door_side = Side::south;
  return plan;
}

bool furnish_corridor(Placer& placer, const RoomPlan& plan) {
  auto& random = placer.random();
  const double clutter = placer.options().clutter;
  for (std::size_t i = 0; i < plan.door_frames.size(); ++i) {
    const double half = 0.5 * plan.door_widths[i] + 0.05;
    placer.keep_free(plan.door_frames[i], {-half, -0.9}, {half, -0.001});
  }
  const std::vector<Side> sides = {Side::north, Side::south};
  if (random.chance(0.6)) {
    put_loaded(placer, placer.make("cabinet", "low"), sides, 0.3, {"box", "book", "printer"},
               0.5 * clutter);
  }
  if (random.chance(0.3)) placer.put_at_some_wall(placer.make("bookcase"), sides, 0.3);
  if (random.chance(0.4))
    placer.put_at_some_wall(placer.make("stool", "four legs"), {Side::east, Side::north}, 0.2);
  for (int i = 0; i < 3; ++i) hang_up(placer, "picture", "", sides, 1.35);
  if (random.chance(0.5)) hang_up(placer, "whiteboard", "plain", sides, 0.95);
  if (random.chance(0.5))
    placer.put_at_some_wall(placer.make("plant", "stalk"), {Side::east, Side::north, Side::south},
                            0.0);
  if (random.chance(0.4)) placer.put_somewhere(placer.make("trolley"));
  if (random.chance(0.3)) placer.put_somewhere(placer.make("mannequin", "walking"));
  ceiling_lamps(placer, 3);
  litter(placer, {"waste bin", "box", "bag"}, 1 + static_cast<int>(4 * clutter));
  return true;
}

bool build_floor(Scene& scene, SequentialRandom& random, const RoomOptions& options) {
  struct RoomType {
    Furnish furnish;
    double least_width, least_depth;
  };
  static constexpr RoomType types[] = {{furnish_office, 4.2, 4.0},     {furnish_office, 4.2, 4.0},
                                       {furnish_meeting, 5.2, 4.4},    {furnish_kitchen, 4.0, 3.6},
                                       {furnish_laboratory, 6.0, 5.0}, {furnish_office, 4.8, 4.4}};
  const double breadth = to_cm(random.uniform(1.9, 2.5));
  const double height = to_cm(random.uniform(2.6, 3.0));
  RoomPlan corridor;
  corridor.shell.height = height;
  corridor.shell.floor_material = "linoleum";
  std::vector<RoomPlan> rooms;
  std::vector<Furnish> furnish;
  double length = 0.0;
  for (const bool north : {true, false}) {
    double x = 0.0;
    const int count = north ? 2 : 1 + static_cast<int>(random.below(2));
    double depth = 0.0;
    std::vector<std::size_t> picked;
    for (int i = 0; i < count; ++i) {
      picked.push_back(random.below(std::size(types)));
      depth = std::max(depth, types[picked.back()].least_depth);
    }
    depth = to_cm((depth + random.uniform(0.0, 0.8)) * options.size_scale);
    for (int i = 0; i < count; ++i) {
      const RoomType& type = types[picked[static_cast<std::size_t>(i)]];
      const double width =
          to_cm((type.least_width + random.uniform(0.0, 1.2)) * options.size_scale);
      RoomPlan room;
      room.shell = corridor.shell;
      room.shell.floor_material = random.chance(0.5) ? "carpet grey" : "linoleum";
      room.shell.low = {x, north ? breadth + wall : -wall - depth};
      room.shell.high = {x + width, north ? breadth + wall + depth : -wall};
      x += width + wall;
      rooms.push_back(room);
      furnish.push_back(type.furnish);
    }
    length = std::max(length, x - wall);
  }
  corridor.shell.high = {length, breadth};
  add_door(scene, corridor, random, Side::west, 0.5 * breadth, "closed", true);
  corridor.door_side = Side::south;
  for (auto& room : rooms) {
    const bool north = room.shell.low.y() > 0;
    const Side side = north ? Side::south : Side::north;
    const double width = side_length(room.shell, side);
    add_door(scene, room, random, side, random.chance(0.5) ? 0.8 : width - 0.8,
             random.chance(0.6) ? "open" : "");
    add_windows(scene, room, random, north ? Side::north : Side::south, 3);
    // The same hole in the corridor's wall; the room owns reveals, door and threshold.
    const WallOpening& own = room.shell.openings.front();
    const Side other = north ? Side::north : Side::south;
    const Eigen::Isometry3d from = side_frame(room.shell, side);
    const Eigen::Isometry3d to = side_frame(corridor.shell, other).inverse();
    const double a = (to * (from * Eigen::Vector3d(own.opening.low.x(), 0, 0))).x();
    const double b = (to * (from * Eigen::Vector3d(own.opening.high.x(), 0, 0))).x();
    corridor.shell.openings.push_back(
        {other, {{std::min(a, b), 0.0}, {std::max(a, b), own.opening.high.y()}, 0.0}});
    const double middle = 0.5 * (a + b);
    const Eigen::Isometry3d frame = side_frame(corridor.shell, other) * pose_at({middle, 0, 0});
    corridor.entrances.push_back((frame * Eigen::Vector3d(0, -0.5, 0)).head<2>());
    corridor.door_frames.push_back(frame);
    corridor.door_widths.push_back(room.door_widths.front());
  }
  build_plan(scene, corridor);
  for (const auto& room : rooms) build_plan(scene, room);
  bool complete = true;
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    Placer placer(scene, rooms[i].shell, options, random);
    complete = furnish[i](placer, rooms[i]) && walkable(placer, rooms[i]) && complete;
    add_sensor_poses(placer, rooms[i], 1);
  }
  Placer placer(scene, corridor.shell, options, random);
  complete = furnish_corridor(placer, corridor) && walkable(placer, corridor) && complete;
  add_sensor_poses(placer, corridor, 1);
  return complete;
}

}  // namespace scanchor
