#include "scenes/scene.hpp"

namespace scanchor {

std::vector<FaceAddress> all_faces(const Scene& scene) {
  std::vector<FaceAddress> faces;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const auto& parts = scene.instances[i].parts;
    for (std::size_t p = 0; p < parts.size(); ++p) {
      for (std::size_t f = 0; f < parts[p].faces.size(); ++f) {
        faces.push_back({static_cast<std::int32_t>(i), static_cast<std::int32_t>(p),
                         static_cast<std::int32_t>(f)});
      }
    }
  }
  return faces;
}

WorldFace world_face(const Scene& scene, const FaceAddress& address) {
  const Instance& instance = scene.instances[static_cast<std::size_t>(address.instance)];
  const Part& part = instance.parts[static_cast<std::size_t>(address.part)];
  const Face& face = part.faces[static_cast<std::size_t>(address.face)];
  const Eigen::Isometry3d T_world_part = instance.T_world_instance * part.T_instance_part;
  return {T_world_part * face.center, T_world_part.linear() * face.normal,
          T_world_part.linear() * face.axis, face.size, face.area};
}

Part box_part(const std::string& name, int material, const Eigen::Vector3d& center,
              const Eigen::Vector3d& size) {
  Part part;
  part.name = name;
  part.material = material;
  for (int corner = 0; corner < 8; ++corner) {
    part.vertices.emplace_back(center.x() + ((corner & 1) != 0 ? 0.5 : -0.5) * size.x(),
                               center.y() + ((corner & 2) != 0 ? 0.5 : -0.5) * size.y(),
                               center.z() + ((corner & 4) != 0 ? 0.5 : -0.5) * size.z());
  }
  struct BoxFace {
    const char* name;
    int axis;  // of the normal
    int sign;
    int corners[4];  // counter-clockwise from outside
  };
  static constexpr BoxFace sides[] = {
      {"top", 2, 1, {4, 5, 7, 6}},  {"bottom", 2, -1, {0, 2, 3, 1}}, {"front", 1, -1, {0, 1, 5, 4}},
      {"back", 1, 1, {3, 2, 6, 7}}, {"left", 0, -1, {2, 0, 4, 6}},   {"right", 0, 1, {1, 3, 7, 5}},
  };
  for (std::int32_t k = 0; k < 6; ++k) {
    const BoxFace& side = sides[k];
    const auto& c = side.corners;
    part.triangles.emplace_back(c[0], c[1], c[2]);
    part.triangles.emplace_back(c[0], c[2], c[3]);
    part.triangle_face.push_back(k);
    part.triangle_face.push_back(k);
    Face face;
    face.name = side.name;
    face.normal = Eigen::Vector3d::Zero();
    face.normal[side.axis] = side.sign;
    face.center = center;
    face.center[side.axis] += 0.5 * side.sign * size[side.axis];
    const int u = side.axis == 0 ? 1 : 0;
    const int v = side.axis == 2 ? 1 : 2;
    const int longer = size[u] >= size[v] ? u : v;
    const int shorter = longer == u ? v : u;
    face.axis = Eigen::Vector3d::Zero();
    face.axis[longer] = 1.0;
    face.size = {size[longer], size[shorter]};
    face.area = size[u] * size[v];
    part.faces.push_back(face);
  }
  return part;
}

Eigen::AlignedBox3d local_bounds(const Instance& instance) {
  Eigen::AlignedBox3d bounds;
  for (const auto& part : instance.parts) {
    for (const auto& vertex : part.vertices) bounds.extend(part.T_instance_part * vertex);
  }
  return bounds;
}

Eigen::AlignedBox3d world_bounds(const Instance& instance) {
  Eigen::AlignedBox3d bounds;
  for (const auto& part : instance.parts) {
    const Eigen::Isometry3d T_world_part = instance.T_world_instance * part.T_instance_part;
    for (const auto& vertex : part.vertices) bounds.extend(T_world_part * vertex);
  }
  return bounds;
}

std::size_t triangle_count(const Scene& scene) {
  std::size_t count = 0;
  for (const auto& instance : scene.instances) {
    for (const auto& part : instance.parts) count += part.triangles.size();
  }
  return count;
}

}  // namespace scanchor
