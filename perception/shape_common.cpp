#include "perception/shape_common.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/math.hpp"

namespace scanchor {

FlatPoints flatten(const ShapeView& view, const Surface& surface) {
  const Eigen::Isometry3d T_surface_cloud = surface.T_cloud_surface.inverse();
  const Eigen::Matrix<double, 2, 3> axes = T_surface_cloud.linear().topRows<2>();
  const Eigen::Vector3d origin = surface.T_cloud_surface.translation();
  const auto rays = view.plane_rays(surface.id);
  FlatPoints flat;
  flat.points.reserve(rays.size());
  flat.order.reserve(rays.size());
  for (const std::uint32_t k : rays) {
    const ShapeRay& ray = view.ray(k);
    flat.points.emplace_back(axes * (ray.point - origin));
    flat.order.push_back(ray.index);
  }
  return flat;
}

FlatPoints flatten(const PointCloud& cloud, const Surface& surface) {
  const Eigen::Isometry3d T_surface_cloud = surface.T_cloud_surface.inverse();
  const Eigen::Matrix<double, 2, 3> axes = T_surface_cloud.linear().topRows<2>();
  const Eigen::Vector3d origin = surface.T_cloud_surface.translation();
  std::vector<Eigen::Vector2d> rows;
  rows.reserve(surface.inliers.size());
  for (const std::uint32_t i : surface.inliers)
    rows.emplace_back(axes * (cloud.points[i] - origin));
  std::vector<std::uint32_t> order(rows.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const Eigen::Vector2d& p = rows[a];
    const Eigen::Vector2d& q = rows[b];
    if (p.x() != q.x()) return p.x() < q.x();
    if (p.y() != q.y()) return p.y() < q.y();
    return surface.inliers[a] < surface.inliers[b];
  });
  FlatPoints flat;
  flat.points.reserve(order.size());
  flat.order.reserve(order.size());
  for (const std::uint32_t k : order) {
    flat.points.push_back(rows[k]);
    flat.order.push_back(surface.inliers[k]);
  }
  return flat;
}

double ellipse_eccentricity(const std::vector<Eigen::Vector2d>& points) {
  if (points.size() < 2) return 0.0;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const auto& p : points) mean += p;
  mean /= static_cast<double>(points.size());
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (const auto& p : points) {
    const Eigen::Vector2d d = p - mean;
    xx += d.x() * d.x();
    xy += d.x() * d.y();
    yy += d.y() * d.y();
  }
  const double middle = 0.5 * (xx + yy);
  const double spread = std::hypot(0.5 * (xx - yy), xy);
  if (middle + spread <= 0.0) return 0.0;
  const double ratio = std::max(0.0, (middle - spread) / (middle + spread));
  return std::min(std::sqrt(1.0 - ratio), std::nextafter(1.0, 0.0));
}

FittedRectangle rectangle_from_sides(double angle, const Eigen::Vector2d& low,
                                     const Eigen::Vector2d& high) {
  FittedRectangle rectangle;
  const Eigen::Vector2d u(std::cos(angle), std::sin(angle));
  const Eigen::Vector2d v(-u.y(), u.x());
  const Eigen::Vector2d middle = 0.5 * (low + high);
  rectangle.center = middle.x() * u + middle.y() * v;
  double length = high.x() - low.x();
  double width = high.y() - low.y();
  if (width > length) {
    std::swap(length, width);
    angle += 0.5 * pi;
  }
  while (angle >= 0.5 * pi) angle -= pi;
  while (angle < -0.5 * pi) angle += pi;
  rectangle.angle = angle;
  rectangle.length = {length, length, length, false};
  rectangle.width = {width, width, width, false};
  return rectangle;
}

FittedRectangle minimum_area_rectangle(const std::vector<Eigen::Vector2d>& points) {
  // Hull by Andrew's monotone chain; the least rectangle has a side along an edge of the hull
  // (Freeman and Shapira 1975).
  std::vector<Eigen::Vector2d> sorted = points;
  std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  std::vector<Eigen::Vector2d> hull;
  const auto turn = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                       const Eigen::Vector2d& c) {
    return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
  };
  for (int half = 0; half < 2; ++half) {
    const std::size_t base = hull.size();
    for (const auto& p : sorted) {
      while (hull.size() >= base + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0.0)
        hull.pop_back();
      hull.push_back(p);
    }
    if (!hull.empty()) hull.pop_back();
    std::reverse(sorted.begin(), sorted.end());
  }
  if (hull.size() < 2) return {};
  FittedRectangle best;
  double best_area = -1.0;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Eigen::Vector2d edge = hull[(i + 1) % hull.size()] - hull[i];
    if (edge.squaredNorm() == 0.0) continue;
    const Eigen::Vector2d u = edge.normalized();
    const Eigen::Vector2d v(-u.y(), u.x());
    Eigen::Vector2d low = Eigen::Vector2d::Constant(1e300);
    Eigen::Vector2d high = -low;
    for (const auto& p : hull) {
      const Eigen::Vector2d q(p.dot(u), p.dot(v));
      low = low.cwiseMin(q);
      high = high.cwiseMax(q);
    }
    const double area = (high - low).prod();
    if (best_area < 0.0 || area < best_area) {
      best_area = area;
      best = rectangle_from_sides(std::atan2(u.y(), u.x()), low, high);
    }
  }
  return best;
}

}  // namespace scanchor
