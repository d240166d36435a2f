#pragma once
// What many tests of scenes ask.

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "scenes/catalogue.hpp"
#include "scenes/collide.hpp"
#include "scenes/generator.hpp"
#include "scenes/scene.hpp"

namespace scanchor::testing {

/// A scene with one thing of the catalogue, as it stands on its own.
inline Scene alone(const FurnitureRequest& request) {
  Scene scene;
  Instance thing = make_furniture(scene, request);
  thing.id = 1;
  scene.instances.push_back(thing);
  return scene;
}

/// A board of a size at a pose, as a thing with one box.
inline Scene boards(const std::vector<std::pair<Eigen::Vector3d, Eigen::Isometry3d>>& list) {
  Scene scene;
  for (const auto& [size, pose] : list) {
    Instance instance;
    instance.id = static_cast<std::int32_t>(scene.instances.size()) + 1;
    instance.class_id = 35;
    instance.kind = "box";
    instance.parts.push_back(box_part("board", 0, {0, 0, 0}, size));
    instance.T_world_instance = pose;
    scene.instances.push_back(instance);
  }
  return scene;
}

/// How often each kind stands in the rooms of a family, seeds 0 .. seeds - 1.
inline std::map<std::string, int> kinds_in(const std::string& family, std::uint64_t seeds) {
  std::map<std::string, int> count;
  RoomOptions options;
  options.family = family;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    for (const auto& instance : generate_room(options, seed).instances) ++count[instance.kind];
  }
  return count;
}

/// Name of a face by its index in all_faces.
inline std::string face_name(const Scene& scene, std::int32_t index) {
  const FaceAddress a = all_faces(scene)[static_cast<std::size_t>(index)];
  const Instance& instance = scene.instances[static_cast<std::size_t>(a.instance)];
  const Part& part = instance.parts[static_cast<std::size_t>(a.part)];
  return instance.kind + " " + std::to_string(instance.id) + " / " + part.name + " / " +
         part.faces[static_cast<std::size_t>(a.face)].name;
}

inline void expect_no_close_faces(const Scene& scene, const std::string& what) {
  for (const auto& pair : close_parallel_faces(scene, 0.001)) {
    ADD_FAILURE() << what << ": " << face_name(scene, pair.face_a) << " and "
                  << face_name(scene, pair.face_b) << " are " << pair.distance * 1000
                  << " mm apart";
  }
}

/// Edges that are not run through once in each direction: 0 for a closed, consistently turned mesh.
inline int open_edges(const Part& part) {
  std::map<std::pair<int, int>, int> runs;
  for (const auto& t : part.triangles) {
    for (int k = 0; k < 3; ++k) ++runs[{t[k], t[(k + 1) % 3]}];
  }
  int open = 0;
  for (const auto& [edge, count] : runs) {
    const auto back = runs.find({edge.second, edge.first});
    if (count != 1 || back == runs.end() || back->second != 1) ++open;
  }
  return open;
}

/// Volume by the divergence theorem; positive where triangles are counter-clockwise from outside.
inline double volume(const Part& part) {
  double six = 0.0;
  for (const auto& t : part.triangles) {
    const auto& a = part.vertices[static_cast<std::size_t>(t[0])];
    const auto& b = part.vertices[static_cast<std::size_t>(t[1])];
    const auto& c = part.vertices[static_cast<std::size_t>(t[2])];
    six += a.dot(b.cross(c));
  }
  return six / 6.0;
}

inline const Part* find_part(const Instance& instance, const std::string& name) {
  for (const auto& part : instance.parts) {
    if (part.name == name) return &part;
  }
  return nullptr;
}

inline const Face* find_face(const Part& part, const std::string& name) {
  for (const auto& face : part.faces) {
    if (face.name == name) return &face;
  }
  return nullptr;
}

}  // namespace scanchor::testing
