#pragma once
// The frame of a surface and of its rectangle: what cutting and joining share.

#include <cmath>

#include "perception/surface.hpp"

namespace scanchor {

/// Coordinates along the sides of a rectangle, from its middle.
struct RectangleSides {
  Eigen::Vector2d center, u, v;
  explicit RectangleSides(const FittedRectangle& r)
      : center(r.center),
        u(std::cos(r.angle), std::sin(r.angle)),
        v(-std::sin(r.angle), std::cos(r.angle)) {}
  [[nodiscard]] Eigen::Vector2d of(const Eigen::Vector2d& p) const {
    return {u.dot(p - center), v.dot(p - center)};
  }
};

/// Share of the outline that borders a shadow or the end of the view.
inline double outline_in_shadow(const Surface& surface) {
  double shadow = 0.0;
  double all = 0.0;
  for (const auto& polygon : surface.polygons) {
    for (std::size_t i = 0; i < polygon.outer.size(); ++i) {
      const double length =
          (polygon.outer[(i + 1) % polygon.outer.size()] - polygon.outer[i]).norm();
      all += length;
      if (i < polygon.outer_kind.size() && (polygon.outer_kind[i] == EdgeKind::occlusion ||
                                            polygon.outer_kind[i] == EdgeKind::view_limit))
        shadow += length;
    }
  }
  return all > 0.0 ? shadow / all : 0.0;
}

/// A side keeps the uncertainty of its two edges.
inline Measured side(const Measured& as, double value, bool at_least) {
  return {value, value - (as.value - as.low), value + (as.high - as.value), at_least};
}

/// Moves the frame's origin to the plane's centroid.
inline void centre_frame(Surface& surface) {
  const Eigen::Vector3d origin = surface.T_cloud_surface.translation();
  const Eigen::Vector3d& n = surface.plane.normal;
  Eigen::Vector3d& centroid = surface.plane.centroid;
  centroid -= n * (n.dot(centroid) - surface.plane.offset);  // on the plane that was fitted
  const Eigen::Vector2d shift =
      (surface.T_cloud_surface.linear().transpose() * (centroid - origin)).head<2>();
  for (auto& polygon : surface.polygons) {
    for (auto& p : polygon.outer) p -= shift;
    for (auto& hole : polygon.holes) {
      for (auto& p : hole) p -= shift;
    }
  }
  surface.rectangle.center -= shift;
  surface.T_cloud_surface.translation() = centroid;
}

}  // namespace scanchor
