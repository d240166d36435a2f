#pragma once
// The two scales of a cloud that everything else follows from: how far points scatter across a
// surface, and how far apart they lie.

#include <Eigen/Core>
#include <vector>

#include "perception/canonical_cloud.hpp"
#include "perception/cell_tree.hpp"

namespace scanchor {

/// [m] Median distance to the nearest neighbour: exact for each point of an even sample of at most
/// 1024. 0 for fewer than 2 points.
double median_spacing(const CanonicalCloud& cloud);

/// [m] Standard deviation of the points across planar surfaces. A cell is believed to see noise and
/// not shape where the scatter of the whole equals that of its parts (a bend would grow with the
/// size); the estimate is the upper quartile over such cells, weighted by points, each divided by
/// the cosine of incidence where the sensor is known: range noise lies along the beam. Never less
/// than `least_noise`. Without such cells (fewer than 32 points, no surface): a quarter of the
/// median spacing.
double estimate_noise(const CanonicalCloud& cloud, const CellTree& tree, double spacing,
                      const std::vector<Eigen::Vector3d>& sensors);

/// [m] What rounding alone does: the floats of the canonical cloud, and 2 % of the spacing for
/// exactly flat data, where any other scale would be zero.
double least_noise(const CanonicalCloud& cloud, double spacing);

}  // namespace scanchor
