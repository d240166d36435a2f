#pragma once
// What is where: the value that the generator makes, physics settles, the sensor scans and the
// scores are held against.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "scenes/classes.hpp"

namespace scanchor {

/// How a surface answers light of 905 nm. Index into Scene::materials.
struct Material {
  std::string name;
  double reflectance = 0.5;    ///< Lambertian reflectance rho in [0, 1]
  double specular = 0.0;       ///< share of light mirrored, [0, 1]; 1: mirror
  double transmittance = 0.0;  ///< share of light passed on straight, [0, 1]; glass near 0.9
  std::array<std::uint8_t, 3> color = {180, 180, 180};  ///< RGB for pictures
};

/// A planar rectangle or polygon or a curved piece of a part's outside. Everything in the part's
/// frame.
struct Face {
  std::string name;  ///< "top", "front", "board 3 top"
  bool planar = true;
  // For planar faces; the exact values that a measurement is scored against:
  Eigen::Vector3d center = Eigen::Vector3d::Zero();   ///< [m] centre of the fitted rectangle
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit, pointing outwards
  Eigen::Vector3d axis =
      Eigen::Vector3d::UnitX();                    ///< unit, along the longer side of the rectangle
  Eigen::Vector2d size = Eigen::Vector2d::Zero();  ///< [m] sides of the minimum-area rectangle,
                                                   ///< longer first (E = size.x())
  double area = 0.0;  ///< [m2] of the face itself, holes and cut corners taken off
};

/// A rigid piece of one material: a board, a leg, a screen. Triangles in the part's frame.
struct Part {
  std::string name;  ///< "top", "leg 2", "screen"
  int material = 0;  ///< index into Scene::materials
  Eigen::Isometry3d T_instance_part = Eigen::Isometry3d::Identity();
  std::vector<Eigen::Vector3d> vertices;    ///< [m]
  std::vector<Eigen::Vector3i> triangles;   ///< counter-clockwise from outside
  std::vector<std::int32_t> triangle_face;  ///< index into `faces`, one a triangle
  std::vector<Face> faces;
  bool convex = true;  ///< the collision shape may be the convex hull of the vertices
};

/// One thing of one class.
struct Instance {
  std::int32_t id = 0;  ///< unique in the scene, from 1; stuff has ids too
  ClassId class_id = unlabelled;
  std::string kind;     ///< catalogue kind, "desk"
  std::string variant;  ///< "panel legs"
  Eigen::Isometry3d T_world_instance = Eigen::Isometry3d::Identity();
  std::vector<Part> parts;
  bool loose = false;  ///< falls and is settled by physics; otherwise it stands fixed
  double mass = 1.0;   ///< [kg], for loose things
  std::map<std::string, double>
      parameters;  ///< what the catalogue drew: "width" [m], "boards", ...; empty for other things
};

/// A room or a floor of rooms in the frame "world": metres, z up, floor near z = 0.
struct Scene {
  std::string name;
  std::string family;  ///< "office", "storage aisle", ...
  std::uint64_t seed = 0;
  std::vector<Material> materials;
  std::vector<Instance> instances;
  std::vector<Eigen::Isometry3d>
      sensor_poses;            ///< free places to scan from, T_world_sensor (x forward, z up)
  Eigen::AlignedBox3d bounds;  ///< [m] of the rooms
};

/// A face by its place, and its number in the order instances, parts, faces: the `face` of a
/// point's truth.
struct FaceAddress {
  std::int32_t instance, part, face;  ///< indices, not ids
};
std::vector<FaceAddress> all_faces(const Scene& scene);

/// A planar face moved to the world frame.
struct WorldFace {
  Eigen::Vector3d center, normal, axis;
  Eigen::Vector2d size;
  double area;
};
WorldFace world_face(const Scene& scene, const FaceAddress& address);

/// Adds a convex box part with six named faces ("top", "bottom", "front" (-y), "back" (+y), "left"
/// (-x), "right" (+x)), centred at `center` in the instance's frame.
Part box_part(const std::string& name, int material, const Eigen::Vector3d& center,
              const Eigen::Vector3d& size);

/// Bounding box in the instance's own frame, and in the world. Empty without vertices.
Eigen::AlignedBox3d local_bounds(const Instance& instance);
Eigen::AlignedBox3d world_bounds(const Instance& instance);
std::size_t triangle_count(const Scene& scene);

/// scene.json, documented in docs/reference/scene-format.md. Reading throws Error(bad_data) with
/// file, place and cause.
nlohmann::ordered_json scene_to_json(const Scene& scene);
Scene scene_from_json(const nlohmann::ordered_json& json, const std::string& file);
void write_scene(const std::filesystem::path& path, const Scene& scene);
Scene read_scene(const std::filesystem::path& path);

}  // namespace scanchor
