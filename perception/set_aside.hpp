#pragma once
// Returns that are no surface: they are taken out before anything is measured, and counted.

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "cloud/point_cloud.hpp"
#include "perception/surface.hpp"

namespace scanchor {

/// Points that may lie on surfaces, and the count of the others by cause.
struct UsablePoints {
  std::vector<std::uint32_t> index;  ///< of the cloud, rising
  SetAside set_aside;
  double body_radius = 0.0;  ///< [m] as used; 0: no body was found
};

/// Sets aside, in this order: points with a NaN or an infinite coordinate; and, where sensor
/// positions are known, returns at the sensor's maximum range (at least 20 points and 0.05 % within
/// one part in 10,000 of the largest range: no real surface is a sphere about the scanner) and
/// returns of the scanner's own body (nearer to their sensor than `body_radius`). body_radius < 0:
/// found as an empty shell: a cluster of at least 0.5 % of the points within 1 m of the sensor,
/// with nothing between it and 1.25 times its radius; or within 0.5 m with at most a twentieth as
/// many returns in that shell as within it, since the edges of a body veil the gap with mixed
/// pixels. The emptiest place of the nearest such gap counts. 0: no body.
UsablePoints set_aside(const PointCloud& cloud, double body_radius);

}  // namespace scanchor
