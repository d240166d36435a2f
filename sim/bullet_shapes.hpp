#pragma once
// Parts as Bullet takes them: padded shapes, which of them are boxes, and what they weigh. Private
// to sim/settle.cpp.

#include <btBulletDynamicsCommon.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>

#include "scenes/scene.hpp"

namespace scanchor {

/// A shape whose bounds reach a little farther than it does. Bullet forgets the contacts of a piece
/// of a thing as soon as the bounds part: a lamp that lay a micrometre above a desk would have none
/// in one step and a single new one in the next, and would tremble for ever.
template <class Shape>
struct Padded : Shape {
  using Shape::Shape;
  void getAabb(const btTransform& t, btVector3& low, btVector3& high) const override {
    Shape::getAabb(t, low, high);
    const btVector3 pad(btScalar(0.002), btScalar(0.002), btScalar(0.002));
    low -= pad;
    high += pad;
  }
};

/// Whether the part's vertices are the corners of a box along its axes.
inline bool is_box(const Part& part, const Eigen::AlignedBox3d& box) {
  if (!part.convex || part.vertices.size() < 8) return false;
  unsigned corners = 0;
  for (const auto& v : part.vertices) {
    unsigned corner = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const bool low = std::fabs(v[axis] - box.min()[axis]) < 1e-9;
      const bool high = std::fabs(v[axis] - box.max()[axis]) < 1e-9;
      if (!low && !high) return false;
      if (high) corner |= 1U << axis;
    }
    corners |= 1U << corner;
  }
  return corners == 0xffU;
}

/// Volume and its first moment of a part's closed mesh, in the part's frame.
struct Bulk {
  double volume = 0.0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
};
inline Bulk bulk(const Part& part) {
  Bulk sum;
  for (const auto& t : part.triangles) {
    const Eigen::Vector3d& a = part.vertices[static_cast<std::size_t>(t[0])];
    const Eigen::Vector3d& b = part.vertices[static_cast<std::size_t>(t[1])];
    const Eigen::Vector3d& c = part.vertices[static_cast<std::size_t>(t[2])];
    const double volume = a.dot(b.cross(c)) / 6.0;
    sum.volume += volume;
    sum.moment += volume * 0.25 * (a + b + c);
  }
  return sum;
}

}  // namespace scanchor
