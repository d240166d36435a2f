#include "sensors/footprint.hpp"

#include <algorithm>
#include <cmath>

#include "core/math.hpp"
#include "core/random.hpp"

namespace scanchor {

double footprint_diameter(const LidarOptions& options, double range) {
  return options.aperture + options.divergence * range;
}

double footprint_spread(const LidarOptions& options, double range, double cosine) {
  const double c = std::max(cosine, 1e-3);
  return 0.25 * footprint_diameter(options, range) * std::sqrt(1.0 - c * c) / c;
}

BeamFootprint::BeamFootprint(const LidarOptions& options, std::uint64_t seed)
    : aperture_(options.aperture),
      divergence_(options.divergence),
      seed_(stream_seed(seed, "footprint")) {
  const int count = std::max(1, options.subrays);
  const double golden = pi * (3.0 - std::sqrt(5.0));
  for (int i = 0; i < count; ++i) {
    const double share = (i + 0.5) / count;  // of the energy inside this radius
    // Gaussian with 1/e^2 radius 1: energy inside r is 1 - exp(-2 r^2).
    double radius = options.profile == "gaussian" ? std::sqrt(-0.5 * portable_log(1.0 - share))
                                                  : std::sqrt(share);
    if (count == 1) radius = 0.0;
    const auto [s, c] = portable_sincos(golden * i);
    points_.push_back({radius * c, radius * s});
    reach_ = std::max(reach_, radius);
  }
}

BeamFootprint::Axes BeamFootprint::axes(const Eigen::Vector3d& d, int line, int beam) const {
  // Any axis that is not along the beam will do: the pattern is turned at random anyway.
  const Eigen::Vector3d helper =
      std::fabs(d.z()) < 0.9 ? Eigen::Vector3d(0, 0, 1) : Eigen::Vector3d(1, 0, 0);
  Eigen::Vector3d a = helper.cross(d);
  a /= std::sqrt(a.squaredNorm());
  const Eigen::Vector3d b = d.cross(a);
  const double turn = 2.0 * pi *
                      CounterRandom(seed_).uniform(static_cast<std::uint64_t>(line),
                                                   static_cast<std::uint32_t>(beam));
  const auto [s, c] = portable_sincos(turn);
  return {c * a + s * b, c * b - s * a};
}

Ray BeamFootprint::subray(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                          const Axes& axes, std::size_t i) const {
  const Eigen::Vector3d side = 0.5 * (points_[i].u * axes.u + points_[i].v * axes.v);
  Ray ray;
  ray.origin = origin + aperture_ * side;
  ray.direction = direction + divergence_ * side;
  ray.direction /= std::sqrt(ray.direction.squaredNorm());
  return ray;
}

}  // namespace scanchor
