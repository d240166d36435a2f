#pragma once
// First half of the default method: planes over cells. A cell of the octree whose points are flat
// to within the noise is taken as a whole, as large as it comes, so most points of a room are never
// looked at one by one.

#include <cstdint>
#include <vector>

#include "perception/cell_tree.hpp"

namespace scanchor {

/// A plane that is being grown, in the canonical frame.
struct GrownPlane {
  Moments moments;  ///< of its points
  MomentPlane plane;
  double sigma = 0.0;  ///< [m] of its points across it, within [0.25, 1.2] of the cloud's
};

/// Region of each canonical point, -1: none yet.
struct PlaneLabels {
  std::vector<std::int32_t> of_point;
  std::vector<GrownPlane> planes;
};

/// Finds flat cells, joins neighbours that continue each other's plane, and labels their points
/// within 3 sigma of it. `region_of_cell` (one a cell of the tree, -1: none) tells which flat cells
/// went where.
PlaneLabels cell_planes(const CanonicalCloud& cloud, const CellTree& tree, double sigma,
                        std::vector<std::int32_t>& region_of_cell);

/// Least-squares plane of the moments and its scatter, kept within what the noise allows.
GrownPlane grown_plane(const Moments& moments, double sigma);

}  // namespace scanchor
