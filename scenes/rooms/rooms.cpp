#include "scenes/rooms/rooms.hpp"

#include <algorithm>
#include <cmath>

#include "scenes/pose.hpp"

namespace scanchor {

std::string one_of(SequentialRandom& random, const std::vector<std::string>& words) {
  return words[random.below(static_cast<std::uint32_t>(words.size()))];
}

RoomPlan plan_room(SequentialRandom& random, const RoomOptions& options,
                   const Eigen::Vector2d& least, const Eigen::Vector2d& most, double height_low,
                   double height_high) {
  RoomPlan plan;
  // A wall must hold a door, whatever the scale.
  const double w = std::max(1.6, random.uniform(least.x(), most.x()) * options.size_scale);
  const double d = std::max(1.6, random.uniform(least.y(), most.y()) * options.size_scale);
  plan.shell.high = {to_mm(w), to_mm(d)};
  plan.shell.height = to_mm(random.uniform(height_low, height_high));
  plan.shell.floor_material = one_of(random, {"linoleum", "carpet grey", "carpet blue", "parquet"});
  plan.shell.wall_material = one_of(random, {"paint white", "paint white", "paint grey"});
  return plan;
}

void add_door(Scene& scene, RoomPlan& plan, SequentialRandom& random, Side side, double along,
              const std::string& variant, bool outwards) {
  const double wall = 0.12;
  FurnitureRequest request{"door", variant, random.below(1U << 30), {{"wall", wall}}, 0.0};
  Instance door = make_furniture(scene, request);
  const double width = door.parameters.at("width");
  const double height = std::min(door.parameters.at("height"), plan.shell.height - 0.1);
  const double margin = 0.5 * width + 0.15;
  const double length = side_length(plan.shell, side);
  along = length > 2 * margin ? std::clamp(along, margin, length - margin) : 0.5 * length;
  along = to_mm(along);
  plan.shell.openings.push_back(
      {side, {{along - 0.5 * width, 0.0}, {along + 0.5 * width, height}, wall}});
  const Eigen::Isometry3d frame = side_frame(plan.shell, side) * pose_at({along, 0, 0});
  door.T_world_instance = outwards ? frame * pose_at({0, wall, 0}, pi) : frame;
  if (plan.entrances.empty()) plan.door_side = side;
  plan.fittings.push_back(std::move(door));
  plan.entrances.push_back((frame * Eigen::Vector3d(0, -0.55, 0)).head<2>());
  plan.door_frames.push_back(frame);
  plan.door_widths.push_back(width);
}

void add_door_near_corner(Scene& scene, RoomPlan& plan, SequentialRandom& random, double inset) {
  const bool left = random.chance(0.5);
  add_door(scene, plan, random, Side::south,
           left ? inset : side_length(plan.shell, Side::south) - inset);
}

void add_windows(Scene& scene, RoomPlan& plan, SequentialRandom& random, Side side, int count) {
  const double wall = 0.24;
  const FurnitureRequest request{"window", "", random.below(1U << 30), {{"wall", wall}}, 0.0};
  const Instance window = make_furniture(scene, request);
  const double width = window.parameters.at("width");
  const double height = window.parameters.at("height");
  const double sill = to_mm(std::min(random.uniform(0.85, 1.0), plan.shell.height - height - 0.15));
  const double length = side_length(plan.shell, side);
  const int fitting = std::min(count, static_cast<int>((length - 0.4) / (width + 0.3)));
  for (int i = 0; i < fitting; ++i) {
    const double along = to_mm(length * (i + 0.5) / fitting);
    plan.shell.openings.push_back(
        {side, {{along - 0.5 * width, sill}, {along + 0.5 * width, sill + height}, wall}});
    Instance copy = window;
    copy.T_world_instance = side_frame(plan.shell, side) * pose_at({along, 0, sill});
    plan.fittings.push_back(std::move(copy));
    plan.window_frames.push_back(side_frame(plan.shell, side) * pose_at({along, 0, 0}));
    plan.window_widths.push_back(width);
  }
}

void build_plan(Scene& scene, const RoomPlan& plan) {
  add_shell(scene, plan.shell);
  for (Instance fitting : plan.fittings) {
    fitting.id = next_id(scene);
    scene.instances.push_back(std::move(fitting));
  }
}

void prepare(Placer& placer, const RoomPlan& plan, bool radiators) {
  for (std::size_t i = 0; i < plan.door_frames.size(); ++i) {
    const double half = 0.5 * plan.door_widths[i] + 0.05;
    placer.keep_free(plan.door_frames[i], {-half, -2 * half - 0.1}, {half, -0.001});
  }
  if (!radiators) return;
  for (std::size_t i = 0; i < plan.window_frames.size(); ++i) {
    double width = 0.6;
    for (const double w : {0.8, 1.0, 1.2, 1.6}) {
      if (w <= plan.window_widths[i]) width = w;
    }
    placer.put(placer.make("radiator", "", {{"width", width}, {"height", 0.5}}),
               plan.window_frames[i]);
  }
}

std::optional<std::size_t> chair_at(Placer& placer, std::size_t table, int side, double along,
                                    const std::string& variant) {
  const Instance& thing = placer.scene().instances[table];
  const Eigen::Isometry3d base = thing.T_world_instance;
  const Eigen::AlignedBox3d bounds = local_bounds(thing);
  const Instance chair = placer.make("chair", variant);
  auto& random = placer.random();
  const double first = random.uniform(0.05, 0.45);  // from pushed in to pulled out
  const double turn = radians(random.uniform(-25.0, 25.0));
  const double sway = random.uniform(-0.12, 0.12);
  for (int i = 0; i < 8; ++i) {
    const double out = first + 0.09 * i;
    Eigen::Vector3d at(along + sway, 0, 0);
    double yaw = pi;
    switch (side) {
      case 0:
        at.y() = bounds.min().y() - out;
        break;
      case 1:
        at = {bounds.max().x() + out, along + sway, 0};
        yaw = -0.5 * pi;
        break;
      case 2:
        at.y() = bounds.max().y() + out;
        yaw = 0.0;
        break;
      default:
        at = {bounds.min().x() - out, along + sway, 0};
        yaw = 0.5 * pi;
        break;
    }
    if (thing.variant == "L-shape" && side == 0) {
      // Into the crook, not at the end of the return.
      at.y() = -0.5 * thing.parameters.at("depth") - out;
      at.x() = std::max(at.x(), -0.5 * thing.parameters.at("width") + 0.6 + 0.35);
    }
    if (const auto placed = placer.put(chair, base * pose_at(at, yaw + turn), false)) return placed;
  }
  return std::nullopt;
}

void furnish_desk(Placer& placer, std::size_t desk, int monitors) {
  const Instance thing = placer.scene().instances[desk];  // a copy: placing moves the originals
  auto& random = placer.random();
  const double width = thing.parameters.at("width");
  const double depth = thing.parameters.at("depth");
  SupportSurface top;
  top.instance = desk;
  top.center = {0, 0, thing.parameters.at("height")};
  top.half = {0.5 * width, 0.5 * depth};
  top.clearance = 2.0;
  const auto chair = chair_at(placer, desk, 0, 0.0, random.chance(0.8) ? "office star base" : "");
  double seat = 0.0;  // where the user sits along the desk
  if (chair) {
    seat = (thing.T_world_instance.inverse() *
            placer.scene().instances[*chair].T_world_instance.translation())
               .x();
  }
  // Screens stand in an arc around the user's head; each faces it.
  const double diagonal = std::vector<double>{21.5, 23.8, 23.8, 27.0}[random.below(4)];
  const bool same = random.chance(0.8);
  const double pitch = diagonal * 0.0254 * 0.8716 + 0.06;
  for (int i = 0; i < monitors; ++i) {
    const double x =
        std::clamp(seat, -0.2 * width, 0.2 * width) + (i - 0.5 * (monitors - 1)) * pitch;
    Parameters parameters;
    if (same) parameters["diagonal_inch"] = diagonal;
    const Instance monitor =
        placer.make("monitor", random.chance(0.15) ? "round stand" : "stand", parameters);
    const double y = 0.5 * depth - 0.22 - 0.25 * std::abs(x - seat) * std::abs(x - seat);
    const double distance = y + 0.5 * depth + 0.15;
    // atan by the slope is near enough: the screens face the user to within a few degrees.
    const double slope = (seat - x) / distance;
    const double yaw = slope / std::sqrt(1.0 + slope * slope) + radians(random.uniform(-4.0, 4.0));
    for (int k = 0; k < 5; ++k) {
      const double back_off = 0.03 * k;
      const double side = (x < seat ? -1.0 : 1.0) * 0.02 * k;
      if (placer.put_on(top, monitor, {x + side, y - back_off}, yaw)) break;
    }
  }
  if (monitors == 0) {
    const auto laptop = placer.make("laptop", "open");
    placer.put_on(top, laptop, {seat, -0.1 * depth}, radians(random.uniform(-8, 8)));
  } else {
    placer.put_on(top, placer.make("keyboard"),
                  {seat + random.uniform(-0.05, 0.05), -0.5 * depth + 0.17},
                  radians(random.uniform(-6, 6)));
    placer.put_on(top, placer.make("mouse"),
                  {seat + random.uniform(0.32, 0.42), -0.5 * depth + 0.18},
                  radians(random.uniform(-15, 15)));
  }
  for (const char* kind : {"cup", "telephone", "book", "desk lamp", "bottle", "box", "book"}) {
    if (!random.chance(0.9 * placer.options().clutter)) continue;
    const std::string name = kind;
    placer.put_somewhere_on(top, placer.make(name, name == "box" ? "parcel" : ""),
                            random.uniform(-0.3, 0.3), 0.4, 6);
  }
  if (random.chance(0.6) && thing.variant != "L-shape") {
    // A drawer unit on castors under the desk, at the left or right.
    const Instance unit = placer.make("drawer unit", "on castors");
    const double side = random.chance(0.5) ? 1.0 : -1.0;
    for (int k = 0; k < 3; ++k) {
      if (placer.put(
              unit,
              thing.T_world_instance * pose_at({side * (0.5 * width - 0.36 - 0.03 * k), 0.03, 0}),
              false))
        break;
    }
  }
}

std::optional<std::size_t> workplace(Placer& placer, const std::vector<Side>& sides, int monitors) {
  const Instance desk = placer.make("desk");
  const auto placed = placer.put_at_some_wall(desk, sides, 0.85, 16);
  if (placed) furnish_desk(placer, *placed, monitors);
  return placed;
}

std::vector<std::size_t> put_in_a_row(Placer& placer, Side side, double start,
                                      const std::vector<Instance>& things, double gap) {
  std::vector<std::size_t> placed;
  const Eigen::Isometry3d frame = side_frame(placer.room(), side);
  double along = start;
  for (const auto& thing : things) {
    const Eigen::AlignedBox3d bounds = local_bounds(thing);
    const Eigen::Vector3d at(along - bounds.min().x(), -0.012 - bounds.max().y(), 0);
    const auto index = placer.put(thing, frame * pose_at(at));
    if (!index) continue;
    placed.push_back(*index);
    along += bounds.sizes().x() + gap;
  }
  return placed;
}

void load_surfaces(Placer& placer, std::size_t thing, const std::vector<std::string>& kinds,
                   double share) {
  auto& random = placer.random();
  for (const auto& surface : placer.surfaces(thing)) {
    if (surface.center.z() > 2.1) continue;
    const double room = 4.0 * surface.half.x() * surface.half.y();
    const int places = std::max(1, static_cast<int>(room / 0.08));
    for (int i = 0; i < std::min(places, 6); ++i) {
      if (!random.chance(share)) continue;
      const std::string kind = one_of(random, kinds);
      placer.put_somewhere_on(surface, placer.make(kind, kind == "monitor" ? "stand" : ""), 0.0,
                              kind == "box" ? 0.2 : 0.5, 3);
    }
  }
}

std::optional<std::size_t> put_loaded(Placer& placer, const Instance& thing,
                                      const std::vector<Side>& sides, double use,
                                      const std::vector<std::string>& kinds, double share) {
  const auto placed = placer.put_at_some_wall(thing, sides, use);
  if (placed) load_surfaces(placer, *placed, kinds, share);
  return placed;
}

void litter(Placer& placer, const std::vector<std::string>& kinds, int count) {
  for (int i = 0; i < count; ++i) {
    const std::string kind = one_of(placer.random(), kinds);
    const Instance thing = placer.make(kind);
    // Things end up along the walls more often than in the middle.
    if (placer.random().chance(0.7)) {
      Instance copy = thing;
      for (int k = 0; k < 6; ++k) {
        const Side side = static_cast<Side>(placer.random().below(4));
        const double gap = placer.random().uniform(0.01, 0.12);
        const double share = placer.random().uniform();
        const Eigen::AlignedBox3d bounds = local_bounds(copy);
        const Eigen::Isometry3d frame = side_frame(placer.room(), side);
        const double along = bounds.sizes().x() +
                             share * (side_length(placer.room(), side) - 2 * bounds.sizes().x());
        const double z = copy.loose ? 0.003 : 0.0;
        if (placer.put(copy, frame * pose_at({along, -gap - bounds.max().y() - 0.05, z},
                                             placer.random().uniform(-0.3, 0.3))))
          break;
      }
    } else {
      placer.put_somewhere(thing, 8);
    }
  }
}

void hang_up(Placer& placer, const std::string& kind, const std::string& variant,
             const std::vector<Side>& sides, double z) {
  const Instance thing = placer.make(kind, variant);
  const double half = 0.5 * local_bounds(thing).sizes().x();
  for (int i = 0; i < 8; ++i) {
    const Side side = sides[static_cast<std::size_t>(i) % sides.size()];
    const double length = side_length(placer.room(), side);
    if (length < 2 * half + 0.2) continue;
    const double along = placer.random().uniform(half + 0.1, length - half - 0.1);
    // Not over an opening.
    bool open = false;
    for (const auto& o : placer.room().openings) {
      open = open || (o.side == side && along + half > o.opening.low.x() - 0.05 &&
                      along - half < o.opening.high.x() + 0.05);
    }
    if (!open && placer.hang(thing, side, along, z)) return;
  }
}

void ceiling_lamps(Placer& placer, int count) {
  const Instance lamp =
      placer.make("ceiling lamp", "", {{"drop", std::min(0.5, 0.18 * placer.room().height)}});
  const Eigen::Vector2d size = placer.room().high - placer.room().low;
  for (int i = 0; i < count; ++i) {
    const double share = (i + 0.5) / count;
    const Eigen::Vector2d at = size.x() > size.y()
                                   ? Eigen::Vector2d(share * size.x(), 0.5 * size.y())
                                   : Eigen::Vector2d(0.5 * size.x(), share * size.y());
    const Eigen::Vector2d p = placer.room().low + at;
    placer.put(lamp,
               pose_at({p.x(), p.y(), placer.room().height}, size.x() > size.y() ? 0.0 : 0.5 * pi),
               false);
  }
}

bool walkable(const Placer& placer, const RoomPlan& plan) {
  const Scene& scene = placer.scene();
  const Eigen::AlignedBox2d room(plan.shell.low, plan.shell.high);
  const FloorGrid grid = walkable_floor(scene, room, 0.2, plan.entrances.front());
  for (const auto& entrance : plan.entrances) {
    if (!grid.reachable_near(entrance, 0.15)) return false;
  }
  for (const auto& instance : scene.instances) {
    const Eigen::Vector2d at = instance.T_world_instance.translation().head<2>();
    if (instance.kind == "chair" && room.contains(at) && !grid.reachable_near(at, 0.75))
      return false;
  }
  return grid.reachable_share() >= 0.85;
}

}  // namespace scanchor
