// Rooms to live in: kitchen, living room, bedroom.

#include <algorithm>

#include "scenes/pose.hpp"
#include "scenes/rooms/rooms.hpp"

namespace scanchor {

RoomPlan plan_kitchen(Scene& scene, SequentialRandom& random, const RoomOptions& options) {
  RoomPlan plan = plan_room(random, options, {3.6, 3.4}, {5.2, 4.8}, 2.4, 2.8);
  plan.shell.floor_material = random.chance(0.6) ? "tile" : "parquet";
  add_door_near_corner(scene, plan, random, 0.75);
  add_windows(scene, plan, random, Side::east, 1);
  return plan;
}

bool furnish_kitchen(Placer& placer, const RoomPlan& plan) {
  auto& random = placer.random();
  const double clutter = placer.options().clutter;
  prepare(placer, plan, false);
  // The run: refrigerator at one end, then counters, oven, sink, dishwasher as far as the wall
  // goes.
  const Side side = plan.turned(Side::north);
  const double length = side_length(plan.shell, side);
  const double height = 0.85 + 0.01 * random.below(9);
  std::vector<Instance> run;
  double used = 0.05;
  const auto want = [&](Instance thing) {
    const double width = local_bounds(thing).sizes().x();
    if (used + width + 0.05 > length) return;
    used += width + 0.006;
    run.push_back(std::move(thing));
  };
  want(placer.make("refrigerator", random.chance(0.8) ? "fridge-freezer" : "tall"));
  want(placer.make("sink counter", "", {{"height", height}}));
  want(placer.make("oven", "range"));
  want(placer.make("kitchen counter", random.chance(0.5) ? "with wall units" : "plain",
                   {{"width", 0.9}, {"height", height}}));
  if (random.chance(0.7)) want(placer.make("dishwasher"));
  want(placer.make("kitchen counter", "plain", {{"width", 0.6}, {"height", height}}));
  if (random.chance(0.3)) want(placer.make("washing machine"));
  const bool reversed = random.chance(0.5);
  if (reversed) std::reverse(run.begin(), run.end());
  const auto placed = put_in_a_row(
      placer, side, 0.05 + random.uniform() * std::max(0.0, length - used - 0.05), run, 0.006);
  if (placed.size() < 3) return false;
  bool microwave = false;
  for (const std::size_t index : placed) {
    placer.keep_front_free(index, 0.8);
    const std::string kind = placer.scene().instances[index].kind;
    if (kind != "kitchen counter") continue;
    auto surfaces = placer.surfaces(index);
    for (const auto& surface : surfaces) {
      if (surface.part != "worktop") continue;
      if (!microwave)
        microwave =
            placer.put_somewhere_on(surface, placer.make("microwave"), 0.0, 0.08, 6).has_value();
      for (int i = 0; i < 1 + static_cast<int>(5 * clutter); ++i) {
        placer.put_somewhere_on(surface,
                                placer.make(one_of(random, {"bottle", "bowl", "cup", "box"}), ""),
                                0.0, 0.5, 3);
      }
    }
  }
  const bool round = random.chance(0.4);
  const Instance table = round
                             ? placer.make("table", "round pedestal", {{"diameter", 0.9}})
                             : placer.make("table", "four legs", {{"width", 1.2}, {"depth", 0.8}});
  std::optional<std::size_t> dining =
      random.chance(0.5) ? placer.put_at_some_wall(
                               table, plan.turned({Side::west, Side::east, Side::south}), 0.0, 10)
                         : std::nullopt;
  if (!dining) dining = placer.put_somewhere(table, 20, 0.7);
  if (dining) {
    for (int s = 0; s < 4; ++s) {
      if (random.chance(0.75)) chair_at(placer, *dining, s, 0.0, "four legs");
    }
    load_surfaces(placer, *dining, {"cup", "bowl", "bottle", "laptop", "book"},
                  0.2 + 0.6 * clutter);
  }
  hang_up(placer, "picture", "", plan.turned({Side::west, Side::south, Side::east}), 1.4);
  placer.put(placer.make("ceiling lamp", "shade", {{"drop", 0.45}}),
             pose_at({0.5 * (plan.shell.low.x() + plan.shell.high.x()),
                      0.5 * (plan.shell.low.y() + plan.shell.high.y()), plan.shell.height}),
             false);
  if (random.chance(0.4)) placer.put_somewhere(placer.make("plant", "stalk"));
  litter(placer, {"waste bin", "bag", "box"}, 1 + static_cast<int>(4 * clutter));
  return true;
}

RoomPlan plan_living(Scene& scene, SequentialRandom& random, const RoomOptions& options) {
  RoomPlan plan = plan_room(random, options, {4.4, 4.0}, {6.8, 5.6}, 2.4, 2.9);
  plan.shell.floor_material = random.chance(0.7) ? "parquet" : "carpet grey";
  add_door_near_corner(scene, plan, random, 0.75);
  add_windows(scene, plan, random, Side::north, 3);
  return plan;
}

bool furnish_living(Placer& placer, const RoomPlan& plan) {
  auto& random = placer.random();
  const double clutter = placer.options().clutter;
  prepare(placer, plan, true);
  // The sofa looks across the room to the television.
  const Side sofa_side = plan.turned(random.chance(0.5) ? Side::east : Side::west);
  const Side screen_side = static_cast<Side>((static_cast<int>(sofa_side) + 2) % 4);
  std::optional<std::size_t> sofa;
  for (int i = 0; i < 8 && !sofa; ++i)
    sofa =
        placer.put_at_wall(placer.make("sofa", random.chance(0.8) ? "with arms" : "without arms"),
                           sofa_side, random.uniform(0.2, 0.8), random.uniform(0.03, 0.12));
  if (!sofa) return false;
  const Eigen::Isometry3d seat = placer.scene().instances[*sofa].T_world_instance;
  const double depth = placer.scene().instances[*sofa].parameters.at("depth");
  const Instance coffee = placer.make("coffee table");
  const double half = 0.5 * local_bounds(coffee).sizes().y();
  if (const auto table = placer.put(
          coffee, seat * pose_at({random.uniform(-0.2, 0.2), -0.5 * depth - 0.4 - half, 0},
                                 radians(random.uniform(-6, 6))))) {
    load_surfaces(placer, *table, {"cup", "book", "bottle", "bowl", "book"}, 0.2 + 0.6 * clutter);
  }
  if (random.chance(0.5)) {
    hang_up(placer, "television", "wall mount", {screen_side}, 0.95);
    placer.put_at_some_wall(placer.make("cabinet", "low", {{"height", 0.5}}), {screen_side}, 0.4);
  } else {
    const Instance board =
        placer.make("cabinet", "sliding doors", {{"height", 0.5}, {"width", 1.6}});
    if (const auto low = placer.put_at_some_wall(board, {screen_side}, 0.4)) {
      for (const auto& surface : placer.surfaces(*low)) {
        if (placer.put_on(surface, placer.make("television", "feet", {{"diagonal_inch", 50}}),
                          {0, 0}, 0.0))
          break;
      }
    }
  }
  if (random.chance(0.6)) placer.put_somewhere(placer.make("sofa", "armchair"), 12, 0.5);
  const std::vector<Side> walls = plan.turned({Side::west, Side::east, Side::south, Side::north});
  placer.put_at_some_wall(placer.make("bookcase", "books"), walls, 0.4);
  if (random.chance(0.5)) {
    put_loaded(placer, placer.make("shelf", "with back"), walls, 0.4,
               {"book", "bowl", "bottle", "box"}, 0.3 + 0.5 * clutter);
  }
  if (random.chance(0.5)) {
    if (const auto table =
            placer.put_somewhere(placer.make("table", "four legs", {{"width", 1.4}}), 16, 0.6)) {
      for (const int s : {0, 2}) {
        for (const double x : {-0.32, 0.32}) {
          if (random.chance(0.8)) chair_at(placer, *table, s, x, "four legs");
        }
      }
      load_surfaces(placer, *table, {"bowl", "bottle", "cup", "book"}, 0.5 * clutter);
    }
  }
  placer.put_somewhere(placer.make("floor lamp"));
  placer.put_somewhere(placer.make("plant"));
  for (int i = 0; i < 2; ++i) hang_up(placer, "picture", "", walls, 1.35);
  ceiling_lamps(placer, 1);
  litter(placer, {"cushion", "bag", "book", "box"}, static_cast<int>(6 * clutter));
  return true;
}

RoomPlan plan_bedroom(Scene& scene, SequentialRandom& random, const RoomOptions& options) {
  RoomPlan plan = plan_room(random, options, {3.6, 3.6}, {5.0, 4.8}, 2.4, 2.8);
  plan.shell.floor_material = random.chance(0.6) ? "parquet" : "carpet blue";
  add_door_near_corner(scene, plan, random, 0.75);
  add_windows(scene, plan, random, Side::north, 2);
  return plan;
}

bool furnish_bedroom(Placer& placer, const RoomPlan& plan) {
  auto& random = placer.random();
  const double clutter = placer.options().clutter;
  prepare(placer, plan, true);
  std::optional<std::size_t> bed;
  const Instance frame = placer.make("bed");
  for (int i = 0; i < 10 && !bed; ++i)
    bed = placer.put_at_wall(frame, plan.turned(i % 2 == 0 ? Side::east : Side::west),
                             random.uniform(0.2, 0.9), 0.03);
  if (!bed) return false;
  if (!placer.put_at_some_wall(placer.make("wardrobe"),
                               plan.turned({Side::west, Side::east, Side::south}), 0.6, 20))
    return false;
  // A bedside unit on each side.
  const Eigen::Isometry3d at = placer.scene().instances[*bed].T_world_instance;
  const Eigen::AlignedBox3d bounds = local_bounds(placer.scene().instances[*bed]);
  for (const double s : {-1.0, 1.0}) {
    const Instance unit =
        placer.make("drawer unit", "on glides", {{"depth", 0.4}, {"height", 0.53}});
    const auto placed =
        placer.put(unit, at * pose_at({s * (bounds.max().x() + 0.27), bounds.max().y() - 0.3, 0}));
    if (placed)
      load_surfaces(placer, *placed, {"desk lamp", "book", "cup", "bottle"}, 0.3 + 0.4 * clutter);
  }
  if (random.chance(0.5))
    workplace(placer, plan.turned({Side::north, Side::west, Side::east}),
              static_cast<int>(random.below(2)));
  if (random.chance(0.5))
    placer.put_at_some_wall(placer.make("bookcase"),
                            plan.turned({Side::south, Side::west, Side::east}), 0.4);
  hang_up(placer, "picture", "", plan.turned({Side::east, Side::west, Side::south}), 1.4);
  ceiling_lamps(placer, 1);
  if (random.chance(0.5)) placer.put_somewhere(placer.make("plant"));
  litter(placer, {"cushion", "bag", "book", "box"}, 1 + static_cast<int>(5 * clutter));
  return true;
}

}  // namespace scanchor
