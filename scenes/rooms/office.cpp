// Rooms to work in: office, open-plan office, meeting room.

#include <algorithm>

#include "scenes/pose.hpp"
#include "scenes/rooms/rooms.hpp"

namespace scanchor {

RoomPlan plan_office(Scene& scene, SequentialRandom& random, const RoomOptions& options) {
  RoomPlan plan = plan_room(random, options, {4.2, 3.8}, {6.2, 5.2}, 2.5, 3.0);
  add_door_near_corner(scene, plan, random, 0.8);
  add_windows(scene, plan, random, Side::north, 3);
  return plan;
}

bool furnish_office(Placer& placer, const RoomPlan& plan) {
  auto& random = placer.random();
  const double clutter = placer.options().clutter;
  prepare(placer, plan, true);
  if (!workplace(placer, plan.turned({Side::north, Side::east, Side::west}), 2)) return false;
  const auto have = [&](const char* kind) {
    const auto& all = placer.scene().instances;
    return std::count_if(all.begin(), all.end(),
                         [&](const Instance& thing) { return thing.kind == kind; });
  };
  if (have("monitor") < 2 || have("chair") < 1) return false;
  const Eigen::Vector2d size = plan.shell.high - plan.shell.low;
  if (size.x() * size.y() > 21.0 && random.chance(0.6)) {
    workplace(placer, plan.turned({Side::east, Side::west, Side::north}),
              static_cast<int>(random.below(4)));
  }
  const std::vector<Side> walls = plan.turned({Side::east, Side::west, Side::south});
  const auto shelf = placer.put_at_some_wall(
      placer.make("shelf", "", {{"boards", 3.0 + random.below(4)}}), walls, 0.5, 24);
  const auto cabinet = placer.put_at_some_wall(placer.make("cabinet"), walls, 0.5, 24);
  if (!shelf || !cabinet) return false;
  if (random.chance(0.5)) placer.put_at_some_wall(placer.make("bookcase"), walls, 0.5);
  if (random.chance(0.4)) {
    if (const auto table = placer.put_at_some_wall(
            placer.make("table", "round pedestal", {{"diameter", 0.8}}), walls, 0.0)) {
      chair_at(placer, *table, 0, 0.0, "four legs");
    }
  }
  hang_up(placer, "whiteboard", random.chance(0.5) ? "plain" : "with tray",
          plan.turned({Side::west, Side::east, Side::south}), 0.95);
  if (random.chance(0.7))
    hang_up(placer, "picture", "", plan.turned({Side::east, Side::south, Side::west}), 1.35);
  ceiling_lamps(placer, 2);
  if (random.chance(0.5)) placer.put_somewhere(placer.make("plant"));
  if (random.chance(0.25)) placer.put_somewhere(placer.make("floor lamp"));
  litter(placer, {"waste bin"}, 1);
  load_surfaces(placer, *shelf, {"box", "book", "box", "book", "bottle", "bowl"},
                0.2 + 0.6 * clutter);
  load_surfaces(placer, *cabinet, {"box", "book", "printer", "cup"}, 0.6 * clutter);
  litter(placer, {"box", "box", "bag", "book"}, static_cast<int>(8.0 * clutter + 0.5));
  return true;
}

RoomPlan plan_open_plan(Scene& scene, SequentialRandom& random, const RoomOptions& options) {
  RoomPlan plan = plan_room(random, options, {8.0, 6.0}, {12.0, 8.5}, 2.7, 3.3);
  const double w = side_length(plan.shell, Side::south);
  add_door(scene, plan, random, Side::south, random.uniform(0.8, w - 0.8));
  add_windows(scene, plan, random, Side::north, 5);
  if (random.chance(0.5)) add_windows(scene, plan, random, Side::west, 3);
  return plan;
}

bool furnish_open_plan(Placer& placer, const RoomPlan& plan) {
  auto& random = placer.random();
  const double clutter = placer.options().clutter;
  prepare(placer, plan, true);
  const Eigen::Vector2d middle = 0.5 * (plan.shell.low + plan.shell.high);
  const Eigen::Vector2d size = plan.shell.high - plan.shell.low;
  if (random.chance(0.5)) {
    const Instance pillar = placer.make("pillar", "", {{"height", plan.shell.height}});
    placer.put(pillar, pose_at({middle.x(), plan.shell.low.y() + 0.3 * size.y(), 0}));
  }
  // Islands: two desks back to back, side by side in rows that run from the windows into the room.
  const double width = std::vector<double>{1.4, 1.6, 1.6}[random.below(3)];
  const std::string variant = one_of(random, {"four legs", "panel legs", "height-adjustable"});
  const double pitch = width + 0.06;
  const int per_row = std::min(3, static_cast<int>((size.x() - 2.4) / pitch));
  const int rows = std::max(1, static_cast<int>((size.y() - 1.4) / 3.6));
  int desks = 0;
  for (int row = 0; row < rows; ++row) {
    const double y = plan.shell.low.y() + size.y() * (row + 0.5) / rows;
    const double x0 = middle.x() - 0.5 * (per_row - 1) * pitch + random.uniform(-0.3, 0.3);
    for (int i = 0; i < per_row; ++i) {
      for (const double side : {-1.0, 1.0}) {
        if (random.chance(0.1)) continue;
        const Instance desk = placer.make("desk", variant, {{"width", width}, {"depth", 0.8}});
        const double yaw = (side < 0 ? 0.0 : pi) + 0.3 * placer.jitter();
        const auto placed = placer.put(desk, pose_at({x0 + i * pitch, y + side * 0.47, 0}, yaw));
        if (!placed) continue;
        ++desks;
        placer.keep_front_free(*placed, 0.8);
        furnish_desk(placer, *placed, 1 + static_cast<int>(random.below(2)));
      }
    }
    if (random.chance(0.7)) {
      const Instance screen =
          placer.make("partition", "high feet", {{"height", 1.4}, {"width", 1.6}});
      placer.put(screen, pose_at({x0 - 0.5 * pitch - 0.35, y, 0}, 0.5 * pi));
    }
  }
  if (desks < 2) return false;
  const std::vector<Side> walls = plan.turned({Side::east, Side::south, Side::west});
  for (int i = 0; i < 3; ++i) {
    put_loaded(placer, placer.make("cabinet"), walls, 0.5, {"box", "book", "printer"},
               0.5 * clutter);
  }
  put_loaded(placer, placer.make("shelf"), walls, 0.5, {"box", "book", "book"},
             0.3 + 0.5 * clutter);
  if (random.chance(0.6)) placer.put_somewhere(placer.make("whiteboard", "on stand"));
  hang_up(placer, "whiteboard", "with tray", walls, 0.95);
  ceiling_lamps(placer, 3);
  for (int i = 0; i < 2; ++i) placer.put_somewhere(placer.make("plant"));
  if (random.chance(0.3)) placer.put_somewhere(placer.make("mannequin"));
  litter(placer, {"waste bin", "box", "bag"}, 2 + static_cast<int>(8.0 * clutter));
  return true;
}

RoomPlan plan_meeting(Scene& scene, SequentialRandom& random, const RoomOptions& options) {
  RoomPlan plan = plan_room(random, options, {5.0, 4.0}, {8.0, 5.5}, 2.6, 3.2);
  add_door_near_corner(scene, plan, random, 0.8);
  add_windows(scene, plan, random, Side::north, 3);
  return plan;
}

bool furnish_meeting(Placer& placer, const RoomPlan& plan) {
  auto& random = placer.random();
  const double clutter = placer.options().clutter;
  prepare(placer, plan, true);
  const Eigen::Vector2d middle = 0.5 * (plan.shell.low + plan.shell.high);
  const Eigen::Vector2d size = plan.shell.high - plan.shell.low;
  const bool along_x = size.x() >= size.y();
  const double longest = std::max(size.x(), size.y()) - 2.2;
  std::vector<double> lengths;
  for (const double w : {1.6, 2.0, 2.4, 2.8, 3.2, 3.6}) {
    if (w <= longest) lengths.push_back(w);
  }
  const double depth = std::min(1.2, std::min(size.x(), size.y()) - 2.2);
  if (lengths.empty() || depth < 0.5) return false;
  const double width = lengths[random.below(static_cast<std::uint32_t>(lengths.size()))];
  const Instance table = placer.make("meeting table", "", {{"width", width}, {"depth", depth}});
  std::optional<std::size_t> placed;
  for (int i = 0; i < 6 && !placed; ++i) {
    const Eigen::Vector2d at =
        middle + Eigen::Vector2d(random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3));
    placed = placer.put(table,
                        pose_at({at.x(), at.y(), 0}, (along_x ? 0.0 : 0.5 * pi) + placer.jitter()));
  }
  if (!placed) return false;
  const std::string chair = one_of(random, {"cantilever", "four legs", "office star base"});
  const int seats = static_cast<int>(width / 0.68);
  for (const int side : {0, 2}) {
    for (int i = 0; i < seats; ++i) {
      if (random.chance(0.9))
        chair_at(placer, *placed, side, (i - 0.5 * (seats - 1)) * 0.68, chair);
    }
  }
  for (const int side : {1, 3}) {
    if (random.chance(0.6)) chair_at(placer, *placed, side, 0.0, chair);
  }
  const std::vector<Side> heads =
      along_x ? plan.turned({Side::east, Side::west}) : plan.turned({Side::south, Side::north});
  if (random.chance(0.6)) {
    hang_up(placer, "television", "wall mount", heads, 1.1);
  } else {
    hang_up(placer, "whiteboard", "with tray", heads, 0.9);
  }
  if (random.chance(0.5)) placer.put_somewhere(placer.make("whiteboard", "on stand"));
  put_loaded(placer, placer.make("cabinet", "low"),
             plan.turned({Side::east, Side::west, Side::south}), 0.4,
             {"bottle", "cup", "bowl", "box"}, 0.3 + 0.5 * clutter);
  for (const auto& surface : placer.surfaces(*placed)) {
    for (int i = 0; i < 1 + static_cast<int>(8 * clutter); ++i) {
      const std::string kind = one_of(random, {"laptop", "cup", "bottle", "book", "bowl"});
      placer.put_somewhere_on(surface, placer.make(kind), random.chance(0.5) ? 0.0 : pi, 0.3, 3);
    }
  }
  ceiling_lamps(placer, 2);
  if (random.chance(0.5)) placer.put_somewhere(placer.make("plant"));
  hang_up(placer, "picture", "", plan.turned({Side::south, Side::west, Side::east}), 1.35);
  litter(placer, {"waste bin", "bag"}, 1 + static_cast<int>(3 * clutter));
  return true;
}

}  // namespace scanchor
