#include "sim/inside.hpp"

#include <cmath>

#include "core/polygons.hpp"

namespace scanchor {
bool inside_mesh(const Part& part, const Eigen::Vector3d& point, double depth) {
  // Triangles over the point: a solid is entered and left, so an odd number of them is above one
  // inside. The point is moved off the lattice that corners and diagonals lie on.
  const Eigen::Vector3d p = point + Eigen::Vector3d(1.7e-6, 2.3e-6, 0.0);
  int above = 0;
  for (const auto& t : part.triangles) {
    const Eigen::Vector3d& a = part.vertices[static_cast<std::size_t>(t[0])];
    const Eigen::Vector3d& b = part.vertices[static_cast<std::size_t>(t[1])];
    const Eigen::Vector3d& c = part.vertices[static_cast<std::size_t>(t[2])];
    const double u = cross2((c - b).head<2>(), (p - b).head<2>());
    const double v = cross2((a - c).head<2>(), (p - c).head<2>());
    const double w = cross2((b - a).head<2>(), (p - a).head<2>());
    if (!((u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0))) continue;
    const double z = (u * a.z() + v * b.z() + w * c.z()) / (u + v + w);
    if (std::fabs(z - p.z()) < depth) return false;
    above += z > p.z() ? 1 : 0;
  }
  return above % 2 == 1;
}

bool sunk_into(const Instance& thing, const Instance& other, double depth) {
  const Eigen::AlignedBox3d around = world_bounds(thing);
  for (const Part& part : other.parts) {
    if (part.convex || part.triangles.empty()) continue;
    const Eigen::Isometry3d T = other.T_world_instance * part.T_instance_part;
    Eigen::AlignedBox3d box;
    for (const auto& v : part.vertices) box.extend(T * v);
    if (!box.intersects(around)) continue;
    const Eigen::Isometry3d T_part_thing = T.inverse() * thing.T_world_instance;
    for (const Part& own : thing.parts) {
      for (const auto& v : own.vertices) {
        if (inside_mesh(part, T_part_thing * (own.T_instance_part * v), depth)) return true;
      }
    }
  }
  return false;
}

}  // namespace scanchor
