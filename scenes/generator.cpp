#include "scenes/generator.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "core/text.hpp"
#include "scenes/rooms/rooms.hpp"

namespace scanchor {
namespace {

struct Family {
  const char* name;
  PlanRoom plan;  // null: a floor of several rooms
  Furnish furnish;
};

constexpr Family families[] = {
    {"office", plan_office, furnish_office},
    {"open-plan office", plan_open_plan, furnish_open_plan},
    {"meeting room", plan_meeting, furnish_meeting},
    {"laboratory", plan_laboratory, furnish_laboratory},
    {"storage aisle", plan_storage, furnish_storage},
    {"kitchen", plan_kitchen, furnish_kitchen},
    {"living room", plan_living, furnish_living},
    {"bedroom", plan_bedroom, furnish_bedroom},
    {"corridor", plan_corridor, furnish_corridor},
    {"floor", nullptr, nullptr},
};

/// Whether everything essential is in its place and can be walked to.
bool build(const Family& family, Scene& scene, SequentialRandom& random,
           const RoomOptions& options) {
  if (family.plan == nullptr)
    return build_floor(scene, random, options) && !scene.sensor_poses.empty();
  const RoomPlan plan = family.plan(scene, random, options);
  build_plan(scene, plan);
  Placer placer(scene, plan.shell, options, random);
  const bool complete = family.furnish(placer, plan) && walkable(placer, plan);
  add_sensor_poses(placer, plan, 3);
  return complete && !scene.sensor_poses.empty();
}

}  // namespace

void RoomOptions::describe(OptionList& list) {
  list.add("family", family, "kind of room", room_families());
  list.add("clutter", clutter, "1", "share of the possible clutter that is there", 0.0, 1.0);
  list.add("size_scale", size_scale, "1", "scales the room's sides", 0.5, 3.0);
  list.add("out_of_square_deg", out_of_square_deg, "deg",
           "standard deviation of the yaw of furniture against its wall", 0.0, 30.0);
  list.add("unusual_sizes", unusual_sizes, "1",
           "share of furniture with sizes outside the usual range", 0.0, 1.0);
}

const std::vector<std::string>& room_families() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const auto& family : families) list.emplace_back(family.name);
    return list;
  }();
  return names;
}

GeneratedRoom furnish_room(const RoomOptions& options, std::uint64_t seed, int first) {
  const auto* family = std::find_if(std::begin(families), std::end(families),
                                    [&](const Family& f) { return f.name == options.family; });
  if (family == std::end(families))
    fail_usage("unknown room family '" + options.family + "'",
               suggestion(options.family, room_families()));
  // A room whose paths are blocked or that lacks its essentials is furnished anew; the later tries
  // hold less.
  RoomOptions used = options;
  for (int skipped = 0; skipped < first; ++skipped) used.clutter *= 0.9;
  GeneratedRoom room;
  room.tries = first;
  do {
    room.scene = Scene();
    room.scene.family = options.family;
    room.scene.seed = seed;
    room.scene.name = options.family + " " + std::to_string(seed);
    SequentialRandom random(
        stream_seed(seed, options.family, static_cast<std::uint64_t>(room.tries)));
    room.complete = build(*family, room.scene, random, used);
    ++room.tries;
    used.clutter *= 0.9;
  } while (!room.complete && room.tries < first + most_tries);
  return room;
}

Scene generate_room(const RoomOptions& options, std::uint64_t seed) {
  return furnish_room(options, seed).scene;
}

}  // namespace scanchor
