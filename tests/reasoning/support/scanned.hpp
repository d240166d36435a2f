#pragma once
// Plates with their points, for what looks at more than outlines.

#include "cloud/point_cloud.hpp"
#include "tests/reasoning/support/built.hpp"

namespace scanchor::test {

struct Scanned {
  Surfaces surfaces;
  PointCloud cloud;
};

/// Points on a grid of `spacing` on each plate, the sensor at (0, 0, 1.4), every outline a true
/// edge.
Scanned scanned(const std::vector<Plate>& plates, double spacing = 0.02);

/// Takes the points and the outline of one surface away between `from` and `to` along its longer
/// side [m from its middle].
void take_out(Scanned& scene, std::int32_t surface, double from, double to);

/// Marks the side of a surface's outline that looks along `direction` as a shadow's edge.
void shade(Scanned& scene, std::int32_t surface, const Eigen::Vector3d& direction);

}  // namespace scanchor::test
