#include "perception/moments.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace scanchor {
namespace {

MomentPlane plane_of(const Moments& moments,
                     const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>& solver) {
  MomentPlane plane;
  plane.axes = solver.eigenvectors();
  plane.variances = solver.eigenvalues().cwiseMax(0.0);
  plane.normal = plane.axes.col(0);
  plane.offset = plane.normal.dot(moments.mean());
  return plane;
}

}  // namespace

Eigen::Matrix3d Moments::covariance() const {
  const double mx = x / n, my = y / n, mz = z / n;
  Eigen::Matrix3d c;
  c(0, 0) = xx / n - mx * mx;
  c(1, 1) = yy / n - my * my;
  c(2, 2) = zz / n - mz * mz;
  c(0, 1) = c(1, 0) = xy / n - mx * my;
  c(0, 2) = c(2, 0) = xz / n - mx * mz;
  c(1, 2) = c(2, 1) = yz / n - my * mz;
  return c;
}

double MomentPlane::mean_square(const Moments& m) const {
  const double a = normal.x(), b = normal.y(), c = normal.z();
  const double quadratic = a * a * m.xx + b * b * m.yy + c * c * m.zz +
                           2.0 * (a * b * m.xy + a * c * m.xz + b * c * m.yz);
  const double linear = a * m.x + b * m.y + c * m.z;
  return std::max(0.0, (quadratic - 2.0 * offset * linear) / m.n + offset * offset);
}

MomentPlane fit_plane(const Moments& moments) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.compute(moments.covariance());
  return plane_of(moments, solver);
}

MomentPlane fit_plane_fast(const Moments& moments) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(moments.covariance());
  return plane_of(moments, solver);
}

Eigen::Vector3d plane_variances_fast(const Moments& moments) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(moments.covariance(), Eigen::EigenvaluesOnly);
  return solver.eigenvalues().cwiseMax(0.0);
}

}  // namespace scanchor
