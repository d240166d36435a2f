#pragma once
// Small things to draw, made by hand so that the answers are known.

#include <filesystem>
#include <string>

#include "results/drawing.hpp"
#include "results/image.hpp"
#include "results/view.hpp"
#include "scenes/scene.hpp"

namespace scanchor::samples {

/// The pixel's colour, opaque.
inline Color pixel(const Image& image, int x, int y) {
  const std::size_t at = 3 * (std::size_t(y) * std::size_t(image.width) + std::size_t(x));
  return {image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]};
}

/// How many pixels have exactly that colour.
inline std::size_t count(const Image& image, Color color) {
  std::size_t n = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) n += pixel(image, x, y) == color ? 1 : 0;
  }
  return n;
}

/// An unshaded square of side 2 in the plane z = height around (x, y).
inline DrawnMesh square(double x, double y, double height, Color color, double side = 2.0) {
  const double h = side / 2;
  DrawnMesh mesh;
  mesh.vertices = {{x - h, y - h, height},
                   {x + h, y - h, height},
                   {x + h, y + h, height},
                   {x - h, y + h, height}};
  mesh.colors.assign(4, color);
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

/// From above, 8 m high and so 50 pixels a metre at 400 pixels; +y up.
inline View from_above() {
  View view;
  view.eye = {0, 0, 10};
  view.target = {0, 0, 0};
  view.up = Eigen::Vector3d::UnitY();
  view.vertical_fov_deg = 0;
  view.parallel_height = 8;
  return view;
}

/// A floor, two walls (one at y = 0 that a viewer from -y sees from behind), a desk and a door in
/// the near wall.
inline Scene room() {
  Scene scene;
  scene.family = "test";
  scene.materials.push_back({"wood", 0.5, 0, 0, {200, 150, 100}});
  const auto add = [&](const char* name, const Part& part) {
    Instance instance;
    instance.id = std::int32_t(scene.instances.size()) + 1;
    instance.class_id = *find_class(name);
    instance.parts.push_back(part);
    scene.instances.push_back(instance);
  };
  const auto sheet = [](const Eigen::Vector3d& a, const Eigen::Vector3d& u,
                        const Eigen::Vector3d& v) {
    Part part;
    part.name = "sheet";
    part.vertices = {a, a + u, a + u + v, a + v};
    part.triangles = {{0, 1, 2}, {0, 2, 3}};
    part.triangle_face = {0, 0};
    Face face;
    face.name = "inside";
    face.normal = u.cross(v).normalized();
    face.center = a + (u + v) / 2;
    part.faces.push_back(face);
    return part;
  };
  using V = Eigen::Vector3d;
  add("floor", sheet(V(0, 0, 0), V(4, 0, 0), V(0, 3, 0)));
  add("wall", sheet(V(0, 0, 0), V(0, 0, 2.5), V(4, 0, 0)));     // near, looks to +y
  add("wall", sheet(V(0, 3, 0), V(4, 0, 0), V(0, 0, 2.5)));     // far, looks to -y
  add("ceiling", sheet(V(0, 0, 2.5), V(0, 3, 0), V(4, 0, 0)));  // looks down
  add("desk", box_part("top", 0, V(2, 2, 0.72), V(1.6, 0.8, 0.04)));
  add("door", box_part("leaf", 0, V(1, 0.02, 1), V(0.9, 0.04, 2)));
  return scene;
}

/// A folder of its own below the system's temporary one.
inline std::filesystem::path scratch(const std::string& name) {
  const auto folder = std::filesystem::temp_directory_path() / ("scanchor_results_" + name);
  std::filesystem::create_directories(folder);
  return folder;
}

}  // namespace scanchor::samples
