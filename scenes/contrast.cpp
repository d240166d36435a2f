#include "scenes/contrast.hpp"

#include <cmath>
#include <string>

#include "core/error.hpp"
#include "core/random.hpp"
#include "scenes/catalogue.hpp"
#include "scenes/collide.hpp"
#include "scenes/materials.hpp"
#include "scenes/pose.hpp"
#include "scenes/shell.hpp"

namespace scanchor {
namespace {

Instance board(Scene& scene, const char* class_name, const Eigen::Vector3d& size,
               const std::string& material) {
  Instance instance;
  instance.class_id = *find_class(class_name);
  instance.kind = "board";
  instance.variant = "plain";
  instance.parts.push_back(
      box_part("board", use_material(scene, material), Eigen::Vector3d::Zero(), size));
  return instance;
}

/// What a pair is made of: subject and target at poses, and the subject's other state.
struct Draft {
  Instance a, b;
  Instance a_without;
};

/// Places are relative to the target's, which stands at the origin of the draft; the room is put
/// around it.
Draft draft(Scene& scene, SpatialRelation relation, SequentialRandom& random) {
  Draft d;
  const double width = to_mm(random.uniform(0.7, 1.1));
  const double depth = to_mm(random.uniform(0.4, 0.6));
  const double height = to_mm(random.uniform(0.6, 0.8));
  const double yaw = random.uniform(-0.4, 0.4);
  const Eigen::Vector3d plate(width, depth, 0.03);
  const Eigen::Vector3d upright(width, 0.03, depth);
  const auto pose = [&](double x, double y, double z,
                        const Eigen::Matrix3d& turn = Eigen::Matrix3d::Identity()) {
    return pose_at({0, 0, 0}, yaw) * pose_at({x, y, z}, turn);
  };
  // Boards hang in the room as if on brackets: nothing else then changes with them.
  const Instance level = board(scene, "shelf", plate, "beech");
  const Instance wall_board = board(scene, "whiteboard", upright, "enamel white");
  switch (relation) {
    case SpatialRelation::parallel:
      d.b = level;
      d.b.T_world_instance = pose(0, 0, height);
      d.a = level;
      d.a.T_world_instance = pose(0, 0, height + 0.32);
      d.a_without = d.a;
      d.a_without.T_world_instance =
          pose(0, 0, height + 0.32, rotation_about(0, radians(random.uniform(9, 14))));
      break;
    case SpatialRelation::orthogonal:
      d.b = level;
      d.b.T_world_instance = pose(0, 0, height);
      d.a = board(scene, "monitor", {0.55, 0.03, 0.33}, "screen");
      d.a.T_world_instance = pose(random.uniform(-0.05, 0.05), 0, height + 0.28);
      d.a_without = d.a;
      d.a_without.T_world_instance.linear() =
          d.a.T_world_instance.linear() * rotation_about(0, -radians(random.uniform(25, 35)));
      break;
    case SpatialRelation::above:
    case SpatialRelation::below: {
      // From 60 % overlap to a tenth of it; both times near, and neither time on each other or in
      // line.
      const Instance small = board(scene, "box", {0.4, 0.3, 0.2}, "cardboard");
      const double side = random.chance(0.5) ? 1.0 : -1.0;
      const double first = 0.5 * width - 0.05;
      const double second = 0.5 * width + 0.3;
      if (relation == SpatialRelation::above) {
        d.b = level;
        d.b.T_world_instance = pose(0, 0, height);
        d.a = small;
        d.a.T_world_instance = pose(side * first, 0, height + 0.42);
        d.a_without = d.a;
        d.a_without.T_world_instance = pose(side * second, 0, height + 0.42);
      } else {
        d.b = small;
        d.b.T_world_instance = pose(0, 0, height + 0.42);
        d.a = level;
        d.a.T_world_instance = pose(side * first, 0, height);
        d.a_without = d.a;
        d.a_without.T_world_instance = pose(side * second, 0, height);
      }
      break;
    }
    case SpatialRelation::on:
    case SpatialRelation::supports: {
      const Instance small = board(scene, "box", {0.3, 0.25, 0.2}, "cardboard");
      const double x = random.uniform(-0.1, 0.1);
      if (relation == SpatialRelation::on) {
        d.b = level;
        d.b.T_world_instance = pose(0, 0, height);
        d.a = small;
        d.a.T_world_instance = pose(x, 0, height + 0.015 + 0.1 + 0.03);
        d.a_without = d.a;
        d.a_without.T_world_instance = pose(x, 0, height + 0.015 + 0.1 + 0.30);
      } else {
        d.b = small;
        d.b.T_world_instance = pose(x, 0, height + 0.015 + 0.1 + 0.03);
        d.a = level;
        d.a.T_world_instance = pose(0, 0, height);
        d.a_without = d.a;
        d.a_without.T_world_instance = pose(0, 0, height - 0.27);
      }
      break;
    }
    case SpatialRelation::inside: {
      // A crate, and a parcel that hangs in it or beside it.
      FurnitureRequest crate{"box",
                             "plastic crate",
                             random.below(1000),
                             {{"width", 0.6}, {"depth", 0.5}, {"height", 0.4}},
                             0.0};
      d.b = make_furniture(scene, crate);
      d.b.T_world_instance = pose(0, 0, height);
      d.a = board(scene, "box", {0.2, 0.18, 0.15}, "cardboard");
      d.b.loose = false;  // it hangs
      // Off the middle: vertically aligned neither in it nor beside it.
      const double x = (random.chance(0.5) ? 1.0 : -1.0) * random.uniform(0.05, 0.09);
      d.a.T_world_instance = pose(x, 0, height + 0.25);
      d.a_without = d.a;
      d.a_without.T_world_instance = pose(x, -0.52, height + 0.25);
      break;
    }
    case SpatialRelation::near: {
      const Instance small = board(scene, "box", {0.35, 0.3, 0.25}, "cardboard");
      d.b = small;
      d.b.T_world_instance = pose(0, 0, height);
      d.a = small;
      d.a.T_world_instance = pose(0.35 + random.uniform(0.1, 0.3), 0, height);
      d.a_without = d.a;
      d.a_without.T_world_instance = pose(0.35 + random.uniform(0.8, 1.0), 0, height);
      break;
    }
    case SpatialRelation::same_size: {
      d.b = level;
      d.b.T_world_instance = pose(0, 0, height);
      d.a = level;
      d.a.T_world_instance = pose(0, 0, height + 0.33);
      const double less = random.uniform(0.55, 0.7);
      d.a_without =
          board(scene, "shelf", {to_mm(less * width), to_mm(less * depth), 0.03}, "beech");
      d.a_without.T_world_instance = d.a.T_world_instance;
      break;
    }
    case SpatialRelation::vertically_aligned:
      d.b = level;
      d.b.T_world_instance = pose(0, 0, height);
      d.a = level;
      d.a.T_world_instance = pose(0, 0, height + 0.33);
      d.a_without = d.a;
      d.a_without.T_world_instance = pose(random.uniform(0.3, 0.4) * width, 0, height + 0.33);
      break;
    case SpatialRelation::coplanar:
      d.b = wall_board;
      d.b.T_world_instance = pose(0, 0, height + 0.3);
      d.a = wall_board;
      d.a.T_world_instance = pose(width + 0.15, 0, height + 0.3);
      d.a_without = d.a;
      d.a_without.T_world_instance = pose(width + 0.15, random.uniform(0.1, 0.16), height + 0.3);
      break;
    case SpatialRelation::left_of:
    case SpatialRelation::right_of:
    case SpatialRelation::in_front_of:
    case SpatialRelation::behind: {
      // The viewer stands at -x of the target. Off to the opposite side at the same distance.
      const Instance small = board(scene, "box", {0.25, 0.25, 0.25}, "cardboard");
      d.b = small;
      d.b.T_world_instance = pose_at({0, 0, height});
      const double off = to_mm(random.uniform(0.45, 0.6));
      const double slant = random.uniform(-0.06, 0.06);
      Eigen::Vector3d place(slant, off, height);
      if (relation == SpatialRelation::right_of) place = {slant, -off, height};
      if (relation == SpatialRelation::in_front_of) place = {-off, slant, height};
      if (relation == SpatialRelation::behind) place = {off, slant, height};
      d.a = small;
      d.a.T_world_instance = pose_at(place);
      d.a_without = d.a;
      d.a_without.T_world_instance = pose_at({-place.x(), -place.y(), height});
      break;
    }
  }
  return d;
}

}  // namespace

ContrastPair contrastive_pair(SpatialRelation relation, std::uint64_t seed, double clear) {
  for (std::uint64_t attempt = 0; attempt < 64; ++attempt) {
    SequentialRandom random(stream_seed(seed, relation_name(relation), attempt));
    ContrastPair pair;
    pair.relation = relation;
    Scene scene;
    scene.seed = seed;
    scene.family = "contrast";
    scene.name = "contrast " + std::string(relation_name(relation)) + " " + std::to_string(seed);
    RoomShell room;
    room.high = {to_mm(random.uniform(4.4, 5.4)), to_mm(random.uniform(3.8, 4.8))};
    add_shell(scene, room);
    const Draft d = draft(scene, relation, random);
    const Eigen::Isometry3d place =
        pose_at({to_mm(0.5 * room.high.x() + random.uniform(0.0, 0.4)),
                 to_mm(0.5 * room.high.y() + random.uniform(-0.2, 0.2)), 0.0});
    const Eigen::Vector3d eye(0.5, place.translation().y(), 1.3);
    scene.sensor_poses.push_back(pose_at(eye));
    pair.viewpoint = eye;
    const auto add = [&](Scene& to, Instance thing) {
      thing.id = next_id(to);
      thing.T_world_instance = place * thing.T_world_instance;
      to.instances.push_back(std::move(thing));
      return to.instances.size() - 1;
    };
    pair.b = add(scene, d.b);
    pair.a = scene.instances.size();
    // Bystanders along the wall behind: the same in both scenes.
    std::vector<Instance> others;
    for (int i = 0; i < 2; ++i) {
      Instance thing = make_furniture(
          scene, {i == 0 ? "cabinet" : "waste bin", "", random.below(1U << 20), {}, 0.0});
      const Eigen::AlignedBox3d bounds = local_bounds(thing);
      thing.T_world_instance =
          pose_at({random.uniform(0.7, room.high.x() - 0.7),
                   room.high.y() - 0.03 - bounds.max().y(), thing.loose ? 0.003 : 0.0});
      others.push_back(std::move(thing));
    }
    pair.with = scene;
    pair.without = scene;
    add(pair.with, d.a);
    add(pair.without, d.a_without);
    for (Instance thing : others) {
      for (Scene* to : {&pair.with, &pair.without}) {
        thing.id = next_id(*to);
        to->instances.push_back(thing);
      }
    }
    const auto margin = [&](const Scene& in) {
      return relate(instance_body(in, pair.a), instance_body(in, pair.b), relation, eye).margin;
    };
    if (margin(pair.with) < clear || margin(pair.without) > -clear) continue;
    if (!interpenetrations(pair.with, 0.0).empty() || !interpenetrations(pair.without, 0.0).empty())
      continue;
    return pair;
  }
  fail_usage("no contrastive pair for '" + std::string(relation_name(relation)) +
                 "' with a margin of " + std::to_string(clear),
             "ask for a smaller margin");
}

}  // namespace scanchor
