#include "perception/shape_plane.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

namespace scanchor {

double RayPlane::distance_variance(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                   const Eigen::Vector3d& along) const {
  const auto slope = [&](const Eigen::Vector3d& x) -> Eigen::Vector3d {  // d(along . place) / dp
    const Eigen::Vector3d d = x - sensor;
    const double t = 1.0 / p.dot(d);
    return -along.dot(d) * t * t * d;
  };
  const Eigen::Vector3d g = slope(b) - slope(a);
  return std::max(0.0, g.dot(covariance * g));
}

RayPlane fit_along_rays(const PointCloud& cloud, const Surface& surface,
                        const Eigen::Vector3d& sensor, const ShapeView* view) {
  RayPlane plane;
  plane.sensor = sensor;
  plane.T_cloud_plane = surface.T_cloud_surface;
  const Eigen::Vector3d normal = surface.T_cloud_surface.linear().col(2);
  const Eigen::Vector3d origin = surface.T_cloud_surface.translation();
  const double distance = normal.dot(origin - sensor);
  if (distance == 0.0 || surface.inliers.size() < 4) return plane;
  plane.p = normal / distance;
  // Until the fit says better: what the surface knows of its plane, as an uncertainty of normal /
  // distance.
  const double across = surface.plane.centroid_sigma / distance;
  plane.covariance =
      (surface.plane.normal_covariance + across * across * normal * normal.transpose()) /
      (distance * distance);

  // The sums must not depend on the order of the points.
  struct Ray {
    Eigen::Vector3d direction;
    double range;
  };
  std::vector<Ray> rays;
  rays.reserve(surface.inliers.size());
  if (view != nullptr) {
    for (const std::uint32_t k : view->plane_rays(surface.id))
      rays.push_back({view->ray(k).direction, view->ray(k).range});
  } else {
    std::vector<Eigen::Vector3d> sorted;
    sorted.reserve(surface.inliers.size());
    for (const std::uint32_t i : surface.inliers) sorted.push_back(cloud.points[i] - sensor);
    std::sort(sorted.begin(), sorted.end(), [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
      return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
    });
    for (const Eigen::Vector3d& x : sorted) rays.push_back({x / x.norm(), x.norm()});
  }
  Eigen::Vector3d p = plane.p;
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  double squares = 0.0;
  constexpr double grazing =
      0.02;  // sine of about one degree: such rays have no say and a great weight
  for (int round = 0; round < 3; ++round) {
    squares = 0.0;
    std::size_t used = 0;
    const double least = grazing * p.norm();
    // The six different entries of the information, summed apart from Eigen's nine.
    double xx = 0.0, xy = 0.0, xz = 0.0, yy = 0.0, yz = 0.0, zz = 0.0;
    double gx = 0.0, gy = 0.0, gz = 0.0;
    for (const Ray& ray : rays) {
      const Eigen::Vector3d& d = ray.direction;
      const double facing = p.x() * d.x() + p.y() * d.y() + p.z() * d.z();
      if (facing < least) continue;
      const double t = 1.0 / facing;
      const double residual = ray.range - t;  // dt/dp = -t^2 d
      const double w = -t * t;
      const double jx = w * d.x(), jy = w * d.y(), jz = w * d.z();
      xx += jx * jx, xy += jx * jy, xz += jx * jz, yy += jy * jy, yz += jy * jz, zz += jz * jz;
      gx += residual * jx, gy += residual * jy, gz += residual * jz;
      squares += residual * residual;
      ++used;
    }
    information << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    const Eigen::Vector3d gradient(gx, gy, gz);
    if (used < 4) return plane;
    squares /= static_cast<double>(used - 3);
    const Eigen::LDLT<Eigen::Matrix3d> solver(information);
    const Eigen::Vector3d pivots = solver.vectorD();
    if (solver.info() != Eigen::Success || pivots.minCoeff() <= 1e-12 * pivots.maxCoeff())
      return plane;
    const Eigen::Vector3d step = solver.solve(gradient);
    if (!step.allFinite() || step.norm() > 0.2 * p.norm())
      return plane;  // not the same plane any more
    p += step;
  }
  plane.p = p;
  plane.covariance = squares * information.inverse();

  // The frame: the old origin dropped onto the new plane, the old x axis laid down on it.
  const Eigen::Vector3d n = (p.dot(normal) < 0.0 ? -p : p).normalized();
  const Eigen::Vector3d x =
      (surface.T_cloud_surface.linear().col(0) - n.dot(surface.T_cloud_surface.linear().col(0)) * n)
          .normalized();
  plane.T_cloud_plane.linear().col(0) = x;
  plane.T_cloud_plane.linear().col(1) = n.cross(x);
  plane.T_cloud_plane.linear().col(2) = n;
  const double off = (p.dot(origin - sensor) - 1.0) / p.norm();
  plane.T_cloud_plane.translation() = origin - off * p.normalized();
  return plane;
}

}  // namespace scanchor
