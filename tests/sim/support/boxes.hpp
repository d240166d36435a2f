#pragma once
// Small scenes of boxes, and a tracer for them that shares nothing with the one under test.

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/random.hpp"
#include "scenes/scene.hpp"
#include "sim/world.hpp"

namespace scanchor::testing {

/// An instance that is one box, its centre at the pose's origin.
inline Instance box_instance(std::int32_t id, const Eigen::Vector3d& size,
                             const Eigen::Isometry3d& pose, bool loose = false) {
  Instance instance;
  instance.id = id;
  instance.class_id = 1;
  instance.kind = "box";
  instance.T_world_instance = pose;
  instance.parts.push_back(box_part("box", 0, Eigen::Vector3d::Zero(), size));
  instance.loose = loose;
  return instance;
}

inline Eigen::Isometry3d at(double x, double y, double z) {
  return Eigen::Isometry3d(Eigen::Translation3d(x, y, z));
}

/// A scene with one matt material and no instance.
inline Scene empty_scene() {
  Scene scene;
  scene.materials.push_back({"matt", 0.5, 0.0, 0.0, {200, 200, 200}});
  scene.bounds = Eigen::AlignedBox3d(Eigen::Vector3d(-20, -20, -5), Eigen::Vector3d(20, 20, 20));
  return scene;
}

/// Six slabs of 10 cm that leave the inside [0, size] free: seen from inside the room is closed.
inline void add_room(Scene& scene, const Eigen::Vector3d& size) {
  constexpr double thick = 0.1;
  const Eigen::Vector3d half = 0.5 * size;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      Eigen::Vector3d extent = size + Eigen::Vector3d::Constant(2.0 * thick);
      Eigen::Vector3d center = half;
      extent[axis] = thick;
      center[axis] += side * (half[axis] + 0.5 * thick);
      scene.instances.push_back(box_instance(static_cast<std::int32_t>(scene.instances.size()) + 1,
                                             extent, at(center.x(), center.y(), center.z())));
    }
  }
  scene.bounds = Eigen::AlignedBox3d(Eigen::Vector3d::Zero(), size);
}

inline Eigen::Vector3d random_direction(SequentialRandom& random) {
  Eigen::Vector3d d;
  do {
    d = Eigen::Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  } while (d.squaredNorm() > 1.0 || d.squaredNorm() < 1e-3);
  return d.normalized();
}

/// What the slab method finds: the nearest box and the range to it.
struct BoxHit {
  std::int32_t instance = -1;
  double range = std::numeric_limits<double>::infinity();
  double runner_up = std::numeric_limits<double>::infinity();  ///< range of the next surface
  double edge_distance = 0.0;  ///< [m] from the hit to the nearest edge of its box
};

/// Every instance must be one box as box_instance makes it. Slab method (Kay & Kajiya 1986) in
/// double precision.
inline BoxHit trace_boxes(const Scene& scene, const Ray& ray) {
  BoxHit best;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    Eigen::AlignedBox3d box;
    for (const auto& v : instance.parts[0].vertices) box.extend(v);
    const Eigen::Isometry3d inverse = instance.T_world_instance.inverse();
    const Eigen::Vector3d o = inverse * ray.origin;
    const Eigen::Vector3d d = inverse.linear() * ray.direction;
    double enter = -std::numeric_limits<double>::infinity();
    double leave = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      const double a = (box.min()[axis] - o[axis]) / d[axis];
      const double b = (box.max()[axis] - o[axis]) / d[axis];
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    if (enter > leave || leave < 0.0) continue;
    for (const double range : {enter, leave}) {
      if (range <= 1e-4) continue;
      if (range < best.range) {
        best.runner_up = best.range;
        best.range = range;
        best.instance = static_cast<std::int32_t>(i);
        // On a face one coordinate is at the border; the next nearest border is the edge.
        const Eigen::Vector3d p = o + range * d;
        Eigen::Vector3d gap = (p - box.min()).cwiseAbs().cwiseMin((box.max() - p).cwiseAbs());
        std::sort(gap.data(), gap.data() + 3);
        best.edge_distance = gap[1];
      } else {
        best.runner_up = std::min(best.runner_up, range);
      }
    }
  }
  return best;
}

/// A room of random boxes, turned every which way, none near another's plane.
inline Scene random_boxes(int count, std::uint64_t seed) {
  SequentialRandom random(seed);
  Scene scene = empty_scene();
  add_room(scene, {6, 5, 3});
  for (int i = 0; i < count; ++i) {
    Eigen::Isometry3d pose =
        at(random.uniform(0.5, 5.5), random.uniform(0.5, 4.5), random.uniform(0.3, 2.7));
    pose.linear() =
        Eigen::AngleAxisd(random.uniform(0, 3), random_direction(random)).toRotationMatrix();
    scene.instances.push_back(box_instance(
        static_cast<std::int32_t>(scene.instances.size()) + 1,
        {random.uniform(0.05, 0.8), random.uniform(0.05, 0.8), random.uniform(0.05, 0.8)}, pose));
  }
  return scene;
}

}  // namespace scanchor::testing
