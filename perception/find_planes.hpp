#pragma once
// The steps of find_planes (declared in perceive.hpp) that are common to both methods.

#include <cstdint>
#include <vector>

#include "perception/canonical_cloud.hpp"
#include "perception/perceive.hpp"

namespace scanchor {

/// What both methods work on, and the scales they take their thresholds from.
struct PlaneInput {
  CanonicalCloud cloud;
  double sigma =
      0.0;  ///< [m] across surfaces: given or estimated, never below the least that is believed
  double spacing = 0.0;           ///< [m] median distance to the nearest neighbour
  bool noise_along_beams = true;  ///< if one sensor is known; the paper fits squared distances
};

/// Sets aside what is no return of a surface and makes the input of a plane finder, all but its
/// sigma; writes what the surfaces know of the cloud by then: sensor positions, what was set aside,
/// the spacing, and no plane for any point.
PlaneInput plane_input(const PointCloud& cloud, const PerceiveOptions& options, Surfaces& surfaces);

/// Regions of canonical points -> surfaces of the cloud, in their documented order; a region of
/// fewer than 3 points is none.
void collect_surfaces(const PointCloud& cloud, const PlaneInput& input,
                      const std::vector<std::int32_t>& region_of, Surfaces& surfaces);

}  // namespace scanchor
