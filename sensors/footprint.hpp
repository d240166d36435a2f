#pragma once
// A beam has a width: the rays that sample its footprint.

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "sensors/tilting_lidar.hpp"

namespace scanchor {

/// Diameter [m] of the footprint at a range: D(R) = aperture + divergence R (SICK manuals;
/// sensors.md 1.2 formula 1).
double footprint_diameter(const LidarOptions& options, double range);

/// Standard deviation [m] of the range inside the footprint on a plane met at an angle: (D/4) tan
/// a. The same for a uniform disc of diameter D and for a Gaussian beam whose 1/e^2 diameter is D.
double footprint_spread(const LidarOptions& options, double range, double cosine);

/// Points in the beam's cross-section, each for the same energy: a sunflower (Vogel, "A better way
/// to construct the sunflower head", Mathematical Biosciences 44, 1979) with the radii at equal
/// shares of the profile's energy. Each beam turns the pattern by an angle of its own, so that the
/// mean over beams is the integral over the profile.
class BeamFootprint {
 public:
  BeamFootprint(const LidarOptions& options, std::uint64_t seed);

  struct Point {
    double u, v;  ///< in half diameters
  };
  [[nodiscard]] const std::vector<Point>& points() const { return points_; }
  /// Half diameters from the middle to the farthest sub-ray.
  [[nodiscard]] double reach() const { return reach_; }
  [[nodiscard]] std::size_t size() const { return points_.size(); }

  /// The beam's cross-section axes, turned by the beam's own angle.
  struct Axes {
    Eigen::Vector3d u, v;
  };
  [[nodiscard]] Axes axes(const Eigen::Vector3d& direction, int line, int beam) const;
  /// Sub-ray i of a beam.
  [[nodiscard]] Ray subray(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                           const Axes& axes, std::size_t i) const;

 private:
  double aperture_, divergence_;
  std::uint64_t seed_;
  double reach_ = 0.0;
  std::vector<Point> points_;
};

}  // namespace scanchor
