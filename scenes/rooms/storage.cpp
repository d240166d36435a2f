// Rooms to keep things in: the laboratory with shelves (Fig. 1 of the paper) and the storage aisle
// (its logistics scenario).

#include <algorithm>

#include "scenes/pose.hpp"
#include "scenes/rooms/rooms.hpp"

namespace scanchor {

RoomPlan plan_laboratory(Scene& scene, SequentialRandom& random, const RoomOptions& options) {
  RoomPlan plan = plan_room(random, options, {6.0, 5.0}, {9.0, 7.0}, 2.7, 3.4);
  plan.shell.floor_material = "linoleum";
  const double w = side_length(plan.shell, Side::south);
  add_door(scene, plan, random, Side::south, random.uniform(0.8, w - 0.8));
  add_windows(scene, plan, random, Side::north, 4);
  return plan;
}

bool furnish_laboratory(Placer& placer, const RoomPlan& plan) {
  auto& random = placer.random();
  const double clutter = placer.options().clutter;
  prepare(placer, plan, false);
  const std::vector<Side> walls = plan.turned({Side::east, Side::west, Side::south, Side::north});
  int shelves = 0;
  const int wanted = 2 + static_cast<int>(random.below(3));
  for (int i = 0; i < wanted; ++i) {
    const Instance shelf =
        placer.make("shelf", random.chance(0.6) ? "open" : "", {{"boards", 3.0 + random.below(4)}});
    const auto placed = placer.put_at_some_wall(shelf, walls, 0.7, 20);
    if (!placed) continue;
    ++shelves;
    load_surfaces(placer, *placed, {"box", "box", "bottle", "box", "bowl", "book"},
                  0.25 + 0.6 * clutter);
  }
  const auto bench = placer.put_at_some_wall(
      placer.make("workbench"), plan.turned({Side::north, Side::east, Side::west}), 0.8, 20);
  if (shelves == 0 || !bench) return false;
  load_surfaces(placer, *bench, {"box", "bottle", "laptop", "cup", "bowl", "desk lamp"},
                0.3 + 0.5 * clutter);
  const double pull = placer.random().uniform(0.2, 0.4);
  const Eigen::Isometry3d base = placer.scene().instances[*bench].T_world_instance;
  placer.put(placer.make("stool", "laboratory"),
             base * pose_at({random.uniform(-0.4, 0.4), -0.4 - pull, 0}), false);
  if (random.chance(0.6)) {
    put_loaded(placer, placer.make("workbench"), walls, 0.8, {"box", "bottle", "printer"},
               0.5 * clutter);
  }
  // An island in the middle: a table with things on it.
  if (random.chance(0.7)) {
    const Eigen::Vector2d middle = 0.5 * (plan.shell.low + plan.shell.high);
    const auto table = placer.put(
        placer.make("table", random.chance(0.5) ? "four legs" : "trestles"),
        pose_at({middle.x() + random.uniform(-0.5, 0.5), middle.y() + random.uniform(-0.4, 0.4), 0},
                random.uniform(-0.5, 0.5)));
    if (table) {
      load_surfaces(placer, *table, {"box", "laptop", "bottle", "book", "monitor"},
                    0.3 + 0.5 * clutter);
      chair_at(placer, *table, 0, 0.0);
    }
  }
  put_loaded(placer, placer.make("cabinet", "tall"), walls, 0.5, {"box"}, 0.4);
  workplace(placer, plan.turned({Side::north, Side::east, Side::west}),
            1 + static_cast<int>(random.below(2)));
  if (random.chance(0.6)) placer.put_somewhere(placer.make("trolley"));
  if (random.chance(0.4)) placer.put_somewhere(placer.make("mannequin"));
  if (random.chance(0.3))
    placer.put_somewhere(placer.make("pillar", "", {{"height", plan.shell.height}}));
  if (random.chance(0.5)) placer.put_somewhere(placer.make("box stack"));
  hang_up(placer, "whiteboard", "with tray", walls, 0.95);
  ceiling_lamps(placer, 2);
  litter(placer, {"waste bin", "box", "box", "bag"}, 1 + static_cast<int>(9 * clutter));
  return true;
}

RoomPlan plan_storage(Scene& scene, SequentialRandom& random, const RoomOptions& options) {
  RoomPlan plan = plan_room(random, options, {9.0, 4.6}, {14.0, 6.2}, 3.4, 4.8);
  plan.shell.floor_material = "concrete";
  plan.shell.wall_material = "paint grey";
  plan.shell.ceiling_material = "concrete";
  add_door(scene, plan, random, Side::west, 0.5 * side_length(plan.shell, Side::west));
  plan.door_side = Side::south;  // the family is written in the room's own directions
  return plan;
}

bool furnish_storage(Placer& placer, const RoomPlan& plan) {
  auto& random = placer.random();
  const double clutter = placer.options().clutter;
  prepare(placer, plan, false);
  // Racks along both long walls, the aisle between them.
  int racks = 0;
  for (const Side side : {Side::north, Side::south}) {
    const double width = random.chance(0.5) ? 2.7 : 1.8;
    const double depth = random.chance(0.5) ? 1.1 : 0.8;
    const double pitch = std::min(1.4, (plan.shell.height - 0.8) / 2.2);
    const int levels = plan.shell.height > 4.0 ? 3 : 2;
    const std::string variant = random.chance(0.5) ? "low bay" : "floor bay";
    const int count = static_cast<int>((side_length(plan.shell, side) - 0.8) / (width + 0.05));
    std::vector<Instance> row;
    for (int i = 0; i < count; ++i) {
      const double level = std::min(pitch, (plan.shell.height - 0.9) / levels);
      row.push_back(placer.make(
          "pallet rack", variant,
          {{"width", width}, {"depth", depth}, {"pitch", level}, {"levels", 1.0 * levels}}));
    }
    const auto placed = put_in_a_row(placer, side, random.uniform(0.2, 0.6), row, 0.04);
    racks += static_cast<int>(placed.size());
    for (const std::size_t rack : placed) {
      const Eigen::Isometry3d base = placer.scene().instances[rack].T_world_instance;
      for (const auto& surface : placer.surfaces(rack)) {
        if (surface.clearance < 0.35 || surface.center.z() > 3.2) continue;
        // Pallets side by side with boxes on them, or boxes straight on the deck.
        if (surface.clearance > 0.8 && random.chance(0.5)) {
          for (double x = -surface.half.x() + 0.45; x < surface.half.x() - 0.4; x += 0.86) {
            if (!random.chance(0.75)) continue;
            const bool deep = surface.half.y() > 0.5;
            const Instance pallet = placer.make("pallet", deep ? "euro" : "half");
            const auto p = placer.put(
                pallet, base * pose_at({x, 0.0, surface.center.z()}, deep ? 0.5 * pi : 0.0), false);
            if (p) load_surfaces(placer, *p, {"box"}, 0.7);
          }
        } else {
          for (int i = 0; i < 1 + static_cast<int>(6 * clutter); ++i)
            placer.put_somewhere_on(surface, placer.make("box"), 0.0, 0.15, 4);
        }
      }
    }
    // Below the first beam of a floor bay stand pallets on the floor.
    if (variant == "floor bay") {
      for (const std::size_t rack : placed) {
        if (!random.chance(0.6)) continue;
        const Eigen::Isometry3d base = placer.scene().instances[rack].T_world_instance;
        if (const auto p = placer.put(placer.make("pallet", depth > 1.0 ? "euro" : "half"),
                                      base * pose_at({random.uniform(-0.3, 0.3), 0, 0}), false)) {
          for (const auto& deck : placer.surfaces(*p))
            placer.put_somewhere_on(deck, placer.make("box"), 0.0, 0.1, 4);
        }
      }
    }
  }
  if (racks < 2) return false;
  if (random.chance(0.7)) placer.put_somewhere(placer.make("trolley"));
  if (random.chance(0.5)) placer.put_somewhere(placer.make("pallet", "stack"));
  if (random.chance(0.5)) placer.put_somewhere(placer.make("box stack"));
  if (random.chance(0.4)) placer.put_somewhere(placer.make("mannequin"));
  ceiling_lamps(placer, 3);
  litter(placer, {"box", "box", "waste bin"}, static_cast<int>(8 * clutter));
  return true;
}

}  // namespace scanchor
