// One or two people's office.

#include "scenes/rooms/rooms.hpp"

namespace scanchor {

RoomPlan plan_office(Scene& scene, SequentialRandom& random, const RoomOptions& options) {
  RoomPlan plan = plan_room(random, options, {4.2, 3.8}, {6.2, 5.2}, 2.5, 3.0);
  const double w = side_length(plan.shell, Side::south);
  add_door(scene, plan, random, Side::south, random.chance(0.5) ? 0.8 : w - 0.8);
  add_windows(scene, plan, random, Side::north, 3);
  return plan;
}

bool furnish_office(Placer& placer, const RoomPlan& plan) {
  auto& random = placer.random();
  const double clutter = placer.options().clutter;
  prepare(placer, plan, true);
  if (!workplace(placer, {Side::north, Side::east, Side::west}, 2)) return false;
  const Eigen::Vector2d size = plan.shell.high - plan.shell.low;
  if (size.x() * size.y() > 21.0 && random.chance(0.6)) {
    workplace(placer, {Side::east, Side::west, Side::north}, static_cast<int>(random.below(4)));
  }
  const std::vector<Side> walls = {Side::east, Side::west, Side::south};
  const auto shelf = placer.put_at_some_wall(placer.make("shelf", "", {{"boards", 3.0 + random.below(4)}}), walls, 0.5, 24);
  const auto cabinet = placer.put_at_some_wall(placer.make("cabinet"), walls, 0.5, 24);
  if (!shelf || !cabinet) return false;
  if (random.chance(0.5)) placer.put_at_some_wall(placer.make("bookcase"), walls, 0.5);
  if (random.chance(0.4)) {
    if (const auto table = placer.put_at_some_wall(placer.make("table", "round pedestal", {{"diameter", 0.8}}), walls, 0.0)) {
      chair_at(placer, *table, 0, 0.0, "four legs");
    }
  }
  hang_up(placer, "whiteboard", random.chance(0.5) ? "plain" : "with tray", {Side::west, Side::east, Side::south}, 0.95);
  if (random.chance(0.7)) hang_up(placer, "picture", "", {Side::east, Side::south, Side::west}, 1.35);
  ceiling_lamps(placer, 2);
  if (random.chance(0.5)) placer.put_somewhere(placer.make("plant"));
  if (random.chance(0.25)) placer.put_somewhere(placer.make("floor lamp"));
  litter(placer, {"waste bin"}, 1);
  load_surfaces(placer, *shelf, {"box", "book", "box", "book", "bottle", "bowl"}, 0.2 + 0.6 * clutter);
  load_surfaces(placer, *cabinet, {"box", "book", "printer", "cup"}, 0.6 * clutter);
  litter(placer, {"box", "box", "bag", "book"}, static_cast<int>(8.0 * clutter + 0.5));
  return true;
}

}  // namespace scanchor
