#pragma once
// What must hold in every room, as lines of what does not: for the property tests, and for
// bench/laws_bench, which asks thousands of rooms.

#include <fmt/format.h>

#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "scenes/collide.hpp"
#include "scenes/relations.hpp"
#include "scenes/scene.hpp"

namespace scanchor::testing {

inline bool of_the_shell(const Instance& thing) {
  return thing.kind == "floor" || thing.kind == "ceiling" || thing.kind == "wall";
}

/// `kind` and id.
inline std::string called(const Instance& thing) {
  return fmt::format("{} {}", thing.kind, thing.id);
}

/// No ray may have to choose between two faces. After physics things touch what carries them: such
/// faces look at each other.
inline void ask_faces(const Scene& scene, bool settled, std::vector<std::string>& broken) {
  const auto faces = all_faces(scene);
  const auto looks_down = [&](std::int32_t face) {
    const WorldFace world = world_face(scene, faces[static_cast<std::size_t>(face)]);
    return world.normal.z() < -0.99;
  };
  for (const auto& pair : close_parallel_faces(scene, 0.001)) {
    // ... and the undersides of two things that touch on one desk lie in its plane.
    if (settled && (!pair.same_side || looks_down(pair.face_a))) continue;
    const auto name = [&](std::int32_t face) {
      const FaceAddress& a = faces[static_cast<std::size_t>(face)];
      const Instance& thing = scene.instances[static_cast<std::size_t>(a.instance)];
      return called(thing) + " '" + thing.parts[static_cast<std::size_t>(a.part)].name + "'";
    };
    broken.push_back(fmt::format("faces of {} and {} are {:.2f} mm apart", name(pair.face_a),
                                 name(pair.face_b), 1e3 * pair.distance));
  }
}

/// Things have ids of their own, classes, places in the room, and do not go through each other.
inline void ask_things(const Scene& scene, bool settled, std::vector<std::string>& broken) {
  if (!settled) {  // afterwards Bullet's own report says it, for turned boxes around round things
                   // do overlap
    for (const auto& line : interpenetrations(scene, 0.0)) broken.push_back(line + " overlap");
  }
  const double slack = settled ? 0.001 : 0.0;
  Eigen::AlignedBox3d bounds = scene.bounds;
  bounds.min().array() -= slack;
  bounds.max().array() += slack;
  std::set<std::int32_t> ids;
  for (const auto& thing : scene.instances) {
    if (!ids.insert(thing.id).second) broken.push_back(called(thing) + " has an id of another");
    if (thing.class_id == unlabelled) broken.push_back(called(thing) + " has no class");
    if (!thing.T_world_instance.matrix().allFinite())
      broken.push_back(called(thing) + " is nowhere");
    if (of_the_shell(thing) || thing.kind == "door" || thing.kind == "window") continue;
    if (!bounds.contains(world_bounds(thing))) broken.push_back(called(thing) + " leaves the room");
  }
}

/// One can stand where the scanner stands, and nothing is within 25 cm of it.
inline void ask_poses(const Scene& scene, bool settled, std::vector<std::string>& broken) {
  if (scene.sensor_poses.empty()) broken.emplace_back("has no place to scan from");
  for (const auto& pose : scene.sensor_poses) {
    const Eigen::Vector3d p = pose.translation();
    if (p.z() < 1.2 || p.z() > 1.5) broken.push_back(fmt::format("scanner {} m high", p.z()));
    if (std::abs(pose.linear().determinant() - 1.0) > 1e-12 ||
        std::abs(pose.linear()(2, 2) - 1.0) > 1e-12)
      broken.emplace_back("scanner is not upright");
    for (const auto& thing : scene.instances) {
      if (of_the_shell(thing) || (settled && thing.loose)) continue;
      for (const auto& box : part_boxes(thing)) {
        const Eigen::Vector3d outside =
            ((box.axes.transpose() * (p - box.center)).cwiseAbs() - box.half).cwiseMax(0.0);
        if (outside.norm() < 0.25) broken.push_back(called(thing) + " is at the scanner");
      }
    }
  }
}

/// From where the scanner stands something 0.4 m wide comes to every door and every chair of the
/// room, and to most of the floor. (A floor of rooms is asked room by room by the generator.)
inline void ask_paths(const Scene& scene, std::vector<std::string>& broken) {
  if (scene.family == "floor" || scene.sensor_poses.empty()) return;
  const Eigen::AlignedBox2d room(scene.bounds.min().head<2>(), scene.bounds.max().head<2>());
  const FloorGrid grid =
      walkable_floor(scene, room, 0.2, scene.sensor_poses[0].translation().head<2>());
  for (const auto& thing : scene.instances) {
    const Eigen::Vector2d at = thing.T_world_instance.translation().head<2>();
    if ((thing.kind == "door" && !grid.reachable_near(at, 0.85)) ||
        (thing.kind == "chair" && !grid.reachable_near(at, 0.75)))
      broken.push_back(called(thing) + " cannot be reached");
  }
  if (grid.reachable_share() < 0.85)
    broken.push_back(
        fmt::format("only {:.0f} % of the free floor is joined", 100 * grid.reachable_share()));
}

/// Symmetric relations are listed once; the others come with their inverse, exclude what they
/// exclude, and what is above or on lies higher.
inline void ask_relations(const Scene& scene, std::vector<std::string>& broken) {
  std::set<std::tuple<SpatialRelation, std::int32_t, std::int32_t>> facts;
  const auto list = instance_relations(scene);
  for (const auto& fact : list) facts.insert({fact.relation, fact.a, fact.b});
  const auto holds = [&](SpatialRelation r, std::int32_t a, std::int32_t b) {
    return facts.count({r, a, b}) != 0;
  };
  for (const auto& fact : list) {
    const std::string line = fmt::format(
        "{} {} {}", called(scene.instances[static_cast<std::size_t>(fact.a)]),
        relation_name(fact.relation), called(scene.instances[static_cast<std::size_t>(fact.b)]));
    if (is_symmetric(fact.relation)) {
      if (holds(fact.relation, fact.b, fact.a)) broken.push_back(line + " is listed twice");
      continue;
    }
    const bool viewed = needs_viewpoint(fact.relation);  // each from its own line of sight
    if (!viewed && holds(fact.relation, fact.b, fact.a))
      broken.push_back(line + ", and the other way round");
    if (inverse(fact.relation) != fact.relation && !holds(inverse(fact.relation), fact.b, fact.a))
      broken.push_back(line + ", without its inverse");
    if ((fact.relation == SpatialRelation::left_of &&
         holds(SpatialRelation::right_of, fact.a, fact.b)) ||
        (fact.relation == SpatialRelation::in_front_of &&
         holds(SpatialRelation::behind, fact.a, fact.b)))
      broken.push_back(line + ", and on the other side");
    // Heights order what is above: no cycle of any length can be.
    if (fact.relation == SpatialRelation::above &&
        !(world_bounds(scene.instances[static_cast<std::size_t>(fact.a)]).center().z() >
          world_bounds(scene.instances[static_cast<std::size_t>(fact.b)]).center().z()))
      broken.push_back(line + ", but not higher");
  }
}

/// All of it; each line begins with the scene's name.
inline std::vector<std::string> broken_laws(const Scene& scene, bool settled) {
  std::vector<std::string> broken;
  ask_faces(scene, settled, broken);
  ask_things(scene, settled, broken);
  ask_poses(scene, settled, broken);
  if (!settled) ask_paths(scene, broken);
  ask_relations(scene, broken);
  for (auto& line : broken) line = scene.name + ": " + line;
  return broken;
}

}  // namespace scanchor::testing
