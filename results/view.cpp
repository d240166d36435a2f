#include "results/view.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/math.hpp"

namespace scanchor {
namespace {

std::array<Eigen::Vector3d, 8> corners_of(const Eigen::AlignedBox3d& box) {
  std::array<Eigen::Vector3d, 8> result;
  for (int i = 0; i < 8; ++i) {
    result[std::size_t(i)] = {(i & 1 ? box.max() : box.min()).x(),
                              (i & 2 ? box.max() : box.min()).y(),
                              (i & 4 ? box.max() : box.min()).z()};
  }
  return result;
}

/// A box with room in it, also for nothing, one point or one wall.
Eigen::AlignedBox3d roomy(const Eigen::AlignedBox3d& box) {
  if (box.isEmpty()) {
    return {Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(1, 1, 1)};
  }
  const double least = std::max(1e-3 * box.diagonal().norm(), 0.05);
  const Eigen::Vector3d half = box.sizes().cwiseMax(least) / 2;
  return {box.center() - half, box.center() + half};
}

Eigen::Vector3d direction(double azimuth_deg, double elevation_deg) {
  const SinCos a = portable_sincos(radians(azimuth_deg));
  const SinCos e = portable_sincos(radians(elevation_deg));
  return {e.cos * a.cos, e.cos * a.sin, e.sin};
}

struct Axes {
  Eigen::Vector3d right, up, forward;
};

Axes axes_of(const Eigen::Vector3d& forward, const Eigen::Vector3d& up) {
  Axes axes;
  axes.forward = forward.normalized();
  Eigen::Vector3d right = axes.forward.cross(up);
  if (right.norm() < 1e-9) right = axes.forward.cross(Eigen::Vector3d::UnitY());
  if (right.norm() < 1e-9) right = Eigen::Vector3d::UnitX();
  axes.right = right.normalized();
  axes.up = axes.right.cross(axes.forward);
  return axes;
}

View parallel_view(const Eigen::AlignedBox3d& box, const Eigen::Vector3d& towards_eye,
                   const Eigen::Vector3d& up, double aspect, double share) {
  const Eigen::AlignedBox3d space = roomy(box);
  View view;
  view.vertical_fov_deg = 0.0;
  view.up = up;
  view.target = space.center();
  view.eye = space.center() + towards_eye * (space.diagonal().norm() + 1.0);
  const Axes axes = axes_of(-towards_eye, up);
  double w = 0.0;
  double h = 0.0;
  for (const Eigen::Vector3d& corner : corners_of(space)) {
    w = std::max(w, 2.0 * std::abs(axes.right.dot(corner - view.target)));
    h = std::max(h, 2.0 * std::abs(axes.up.dot(corner - view.target)));
  }
  view.parallel_height = std::max(h, w / aspect) / share;
  return view;
}

}  // namespace

View perspective_view(const Eigen::AlignedBox3d& box, double azimuth_deg, double elevation_deg,
                      double aspect, double share) {
  const auto corners = corners_of(roomy(box));
  return perspective_view(std::vector<Eigen::Vector3d>(corners.begin(), corners.end()), azimuth_deg,
                          elevation_deg, aspect, share);
}

View perspective_view(const std::vector<Eigen::Vector3d>& places, double azimuth_deg,
                      double elevation_deg, double aspect, double share) {
  Eigen::AlignedBox3d space;
  for (const Eigen::Vector3d& place : places) space.extend(place);
  // Room enough for a single point.
  if (space.isEmpty() || space.diagonal().norm() < 0.05) {
    return perspective_view(roomy(space), azimuth_deg, elevation_deg, aspect, share);
  }
  View view;
  const Axes axes = axes_of(-direction(azimuth_deg, elevation_deg), view.up);
  const double tan_y = std::tan(radians(view.vertical_fov_deg) / 2.0) * share;
  const double tan_x = std::tan(radians(view.vertical_fov_deg) / 2.0) * aspect * share;
  // Each place keeps the eye out of a wedge; the eye stands where the wedges of both sides meet,
  // horizontally and vertically.
  double right = -1e300, left = -1e300, top = -1e300, bottom = -1e300;
  for (const Eigen::Vector3d& place : places) {
    const Eigen::Vector3d c = place - space.center();
    const double x = axes.right.dot(c), y = axes.up.dot(c), z = axes.forward.dot(c);
    right = std::max(right, x - tan_x * z);
    left = std::max(left, -x - tan_x * z);
    top = std::max(top, y - tan_y * z);
    bottom = std::max(bottom, -y - tan_y * z);
  }
  const double z = std::min(-(right + left) / (2.0 * tan_x), -(top + bottom) / (2.0 * tan_y));
  view.eye = space.center() + axes.right * ((right - left) / 2.0) +
             axes.up * ((top - bottom) / 2.0) + axes.forward * z;
  view.target = view.eye + axes.forward * std::max(-z, 1e-3);
  return view;
}

View sensor_view(const Eigen::Isometry3d& T_world_sensor, double vertical_fov_deg) {
  View view;
  view.eye = T_world_sensor.translation();
  view.target = T_world_sensor * Eigen::Vector3d::UnitX();
  view.up = T_world_sensor.linear() * Eigen::Vector3d::UnitZ();
  view.vertical_fov_deg = vertical_fov_deg;
  return view;
}

View top_view(const Eigen::AlignedBox3d& box, double aspect, double share) {
  return parallel_view(box, Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitY(), aspect, share);
}

View side_view(const Eigen::AlignedBox3d& box, double azimuth_deg, double aspect, double share) {
  return parallel_view(box, direction(azimuth_deg, 0.0), Eigen::Vector3d::UnitZ(), aspect, share);
}

Projection::Projection(const View& view, int width, int height, const Eigen::AlignedBox3d& box,
                       const Eigen::Vector2d& shift_px)
    : width_(width), height_(height), parallel_(view.vertical_fov_deg <= 0.0), shift_px_(shift_px) {
  const Axes axes = axes_of(view.target - view.eye, view.up);
  eye_ = view.eye;
  forward_ = axes.forward;
  right_ = axes.right;
  up_ = axes.up;
  double nearest = 1e300;
  double farthest = -1e300;
  for (const Eigen::Vector3d& corner : corners_of(roomy(box))) {
    const double distance = forward_.dot(corner - eye_);
    nearest = std::min(nearest, distance);
    farthest = std::max(farthest, distance);
  }
  const double margin = 0.01 * (farthest - nearest) + 1e-3;
  far_ = std::max(farthest + margin, 0.1);
  near_ = parallel_ ? nearest - margin : std::max({nearest - margin, 0.05, far_ / 5000.0});
  if (far_ <= near_) far_ = near_ * 2.0 + 1.0;

  Eigen::Matrix4d look = Eigen::Matrix4d::Identity();
  look.block<1, 3>(0, 0) = right_.transpose();
  look.block<1, 3>(1, 0) = up_.transpose();
  look.block<1, 3>(2, 0) = -forward_.transpose();
  look.block<3, 1>(0, 3) = -(look.block<3, 3>(0, 0) * eye_);
  Eigen::Matrix4d lens = Eigen::Matrix4d::Zero();
  const Eigen::Vector2d shift(2.0 * shift_px_.x() / width_, -2.0 * shift_px_.y() / height_);
  if (parallel_) {
    scale_px_ = height_ / view.parallel_height;
    lens(0, 0) = 2.0 * scale_px_ / width_;
    lens(1, 1) = 2.0 * scale_px_ / height_;
    lens(2, 2) = -2.0 / (far_ - near_);
    lens(2, 3) = -(far_ + near_) / (far_ - near_);
    lens(0, 3) = shift.x();
    lens(1, 3) = shift.y();
    lens(3, 3) = 1.0;
  } else {
    focal_px_ = height_ / 2.0 / std::tan(radians(view.vertical_fov_deg) / 2.0);
    lens(0, 0) = 2.0 * focal_px_ / width_;
    lens(1, 1) = 2.0 * focal_px_ / height_;
    lens(2, 2) = -(far_ + near_) / (far_ - near_);
    lens(2, 3) = -2.0 * far_ * near_ / (far_ - near_);
    lens(0, 2) = -shift.x();
    lens(1, 2) = -shift.y();
    lens(3, 2) = -1.0;
  }
  matrix_ = lens * look;
}

Eigen::Vector3d Projection::pixel(const Eigen::Vector3d& p_world) const {
  const Eigen::Vector3d d = p_world - eye_;
  const double distance = forward_.dot(d);
  const double scale = pixels_per_metre(distance);
  return {width_ / 2.0 + shift_px_.x() + scale * right_.dot(d),
          height_ / 2.0 + shift_px_.y() - scale * up_.dot(d), distance};
}

double Projection::pixels_per_metre(double distance) const {
  return parallel_ ? scale_px_ : focal_px_ / std::max(std::abs(distance), 1e-9);
}

double Projection::distance_of_depth(double depth) const {
  if (parallel_) return near_ + depth * (far_ - near_);
  const double ndc = 2.0 * depth - 1.0;
  return 2.0 * far_ * near_ / (far_ + near_ - ndc * (far_ - near_));
}

}  // namespace scanchor
