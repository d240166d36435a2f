#pragma once
// The stage from points to surfaces. Two methods behind one interface.

#include <string>
#include <vector>

#include "cloud/point_cloud.hpp"
#include "core/options.hpp"
#include "perception/paper_planes.hpp"
#include "perception/surface.hpp"

namespace scanchor {

struct PerceiveOptions {
  std::string method = "default";  ///< "default" or "paper"
  double noise_sigma = 0.0;        ///< [m] range noise of the sensor; 0: estimate it from the cloud
  double body_radius = -1.0;  ///< [m] returns nearer to a known sensor position are its own body;
                              ///< -1: found from the cloud
  bool shapes = true;         ///< false: stop after the planes
  PaperOptions paper;         ///< of the method "paper"
  void describe(OptionList& list);
};

/// Points -> planes. Only Surface::id, plane, T_cloud_surface, inliers and confidence are filled.
/// Deterministic: the same bytes for any number of threads and any permutation of the input (up to
/// the indices).
Surfaces find_planes(const PointCloud& cloud, const PerceiveOptions& options);

/// Planes -> shapes: fills polygons, rectangle, area, rectangularness, eccentricity,
/// occluded_outline of each surface.
void find_shapes(const PointCloud& cloud, const PerceiveOptions& options, Surfaces& surfaces);

/// Both: the paper's summary list in section 2, one line a step.
Surfaces perceive(const PointCloud& cloud, const PerceiveOptions& options);

}  // namespace scanchor
