#pragma once
// The outline of a surface between the rays that met it and the rays that did not.

#include <cstdint>
#include <vector>

#include "perception/alpha_triangulation.hpp"
#include "perception/outline_samples.hpp"
#include "perception/polygon_rings.hpp"

namespace scanchor {

/// A vertex of the raw outline.
struct OutlineNode {
  Eigen::Vector2d position;  ///< [m] in the surface's frame
  double half_gap = 0.0;  ///< [m] the true edge is this near: half of the way from the last sample
                          ///< inside to the first outside
};

/// The raw outline: one node for each pair of neighbouring samples of which one is inside. Wavers
/// by half_gap.
struct Outline {
  std::vector<OutlineNode> nodes;
  std::vector<BoundaryRing>
      rings;  ///< by component: outer ring, then holes; specks of fewer than three samples left out
  std::vector<Eigen::Vector2d> inside;  ///< [m] samples on the surface but for those deep inside
  std::vector<double> inside_height;    ///< [m] of each over the plane (OutlineSample::height)
  std::vector<Eigen::Vector2d>
      beyond;  ///< [m] samples next to a true edge that are not on the surface
  std::vector<double> beyond_height;  ///< [m]
  double spacing = 0.0;  ///< median longest side of the triangles, in the samples' metric
};

/// Marching triangles on the Delaunay triangulation of the samples: the outline runs half-way
/// between samples inside and outside, which is where an edge lies on average, so that neither area
/// nor sides are biased by half a spacing. Triangles whose sides exceed 2.5 times the local spacing
/// stand for places where nothing was measured; there the outline runs half a cell outside the
/// outermost samples. `gate` [m]: noise of a point across the plane, for telling contact from
/// shadow.
Outline find_outline(const PointCloud& cloud, const Surfaces& surfaces, const Surface& surface,
                     const OutlineSamples& samples, double gate);

}  // namespace scanchor
