#include "perception/join_planes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace scanchor {
namespace {

// Variance of a plane's height at a place, in units of the noise variance, from its own points
// alone.
double leverage(const GrownPlane& grown, const Eigen::Vector3d& at) {
  const Eigen::Vector3d out = at - grown.moments.mean();
  const double u = grown.plane.axes.col(1).dot(out), v = grown.plane.axes.col(2).dot(out);
  return (1.0 + u * u / std::max(grown.plane.variances[1], 1e-30) +
          v * v / std::max(grown.plane.variances[2], 1e-30)) /
         grown.moments.n;
}

// Half the extent of the points in a direction, if they are spread evenly: the half-length of a bar
// is sqrt(3) of its deviation.
double half_extent(const GrownPlane& grown, const Eigen::Vector3d& direction) {
  return std::sqrt(3.0 * std::max(0.0, direction.dot(grown.moments.covariance() * direction)));
}

// Two desks of one height lie in one plane too. What a shadow parts lies near each other, measured
// by the pieces themselves.
bool lie_near(const GrownPlane& a, const GrownPlane& b) {
  const Eigen::Vector3d between = b.moments.mean() - a.moments.mean();
  const double distance = between.norm();
  if (distance <= 0.0) return true;
  const double half_a = half_extent(a, between / distance),
               half_b = half_extent(b, between / distance);
  return distance - half_a - half_b <= std::min(half_a, half_b);
}

}  // namespace

bool same_plane(const GrownPlane& a, const GrownPlane& b, const BeamNoise& /*noise*/) {
  Moments both = a.moments;
  both.add(b.moments);
  const double squares = both.n * plane_variances_fast(both)[0];
  const double apart = a.moments.n * a.plane.variances[0] + b.moments.n * b.plane.variances[0];
  // At grazing incidence the scatter across a plane is far below the range noise: what the two
  // themselves show counts.
  const double scatter = std::max(a.sigma, b.sigma);
  return squares - apart <= scatter * scatter * (16.3 + 0.1 * std::min(a.moments.n, b.moments.n));
}

bool lie_in_one_plane(const GrownPlane& a, const GrownPlane& b, const BeamNoise& noise) {
  const GrownPlane& large = a.moments.n >= b.moments.n ? a : b;
  const GrownPlane& small = a.moments.n >= b.moments.n ? b : a;
  const Eigen::Vector3d there = small.moments.mean();
  const double off = std::abs(large.plane.distance(there));
  const double across = noise.across(large.plane, there);
  if (off > 3.0 * across) return false;
  const double known = 0.25 * noise.sigma * noise.sigma;  // (half a sigma)^2
  return large.sigma * large.sigma * leverage(large, there) < known && same_plane(a, b, noise);
}

double log_chance_agreement(const GrownPlane& a, const GrownPlane& b) {
  // Height and slopes of each about a place between them, by their own points.
  const GrownPlane& small = a.moments.n < b.moments.n ? a : b;
  const Eigen::Vector3d at = small.moments.mean();
  const Eigen::Vector3d u = small.plane.axes.col(1), v = small.plane.axes.col(2);
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  // of their difference
  for (const GrownPlane* grown : {&a, &b}) {
    const Eigen::Vector3d out = grown->moments.mean() - at;
    const Eigen::Matrix3d spread = grown->moments.covariance() + out * out.transpose();
    const double ou = u.dot(out), ov = v.dot(out), uu = u.dot(spread * u), uv = u.dot(spread * v),
                 vv = v.dot(spread * v);
    Eigen::Matrix3d information;
    information << 1.0, ou, ov, ou, uu, uv, ov, uv, vv;
    const double determinant = information.determinant();
    if (!(determinant > 0.0)) return 0.0;
    covariance += grown->sigma * grown->sigma / grown->moments.n * information.inverse();
  }
  // The ball of same_plane's test, in a box of what different planes may differ by.
  constexpr double ball = 4.18879 * 65.8, box = 0.25 * 0.25 * 0.25;
  return std::min(
      0.0, 0.5 * std::log(std::max(covariance.determinant(), 1e-300)) + std::log(ball / box));
}

bool surely_same_plane(const GrownPlane& a, const GrownPlane& b, const BeamNoise& noise) {
  return lie_near(a, b) && lie_in_one_plane(a, b, noise);
}

std::vector<std::int32_t> join_planes(
    const std::vector<std::pair<std::int32_t, std::int32_t>>& pairs, const BeamNoise& noise,
    bool (*same)(const GrownPlane&, const GrownPlane&, const BeamNoise&),
    std::vector<GrownPlane>& planes) {
  std::vector<std::int32_t> into(planes.size());
  std::iota(into.begin(), into.end(), 0);
  const auto root = [&](std::int32_t r) {
    while (into[static_cast<std::size_t>(r)] != r) r = into[static_cast<std::size_t>(r)];
    return r;
  };
  for (const auto& [i, j] : pairs) {
    auto a = root(i), b = root(j);
    if (a == b) continue;
    if (a > b) std::swap(a, b);
    auto &pa = planes[static_cast<std::size_t>(a)], &pb = planes[static_cast<std::size_t>(b)];
    if (pa.moments.n < 3.0 || pb.moments.n < 3.0 || !same(pa, pb, noise)) continue;
    Moments both = pa.moments;
    both.add(pb.moments);
    pa = grown_plane(both, noise);
    into[static_cast<std::size_t>(b)] = a;
  }
  for (std::size_t r = 0; r < into.size(); ++r) into[r] = root(static_cast<std::int32_t>(r));
  return into;
}

}  // namespace scanchor
