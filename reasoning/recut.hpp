#pragma once
// Surfaces cut in pieces, with everything that is measured of them.

#include <optional>
#include <vector>

#include "perception/surface.hpp"

namespace scanchor {

/// Pieces of a surface between cuts across its longer side; `cuts`: rising positions along it, from
/// the middle of the rectangle [m]. `points`: the cloud's, for the inliers. Nothing where a piece
/// would have no outline or fewer than three points.
std::optional<std::vector<Surface>> cut_surface(const Surface& surface,
                                                const std::vector<Eigen::Vector3d>& points,
                                                const std::vector<double>& cuts);

/// Positions at which the outline itself falls into pieces side by side, more than `gap` [m] apart;
/// slivers (less than a tenth of the largest) left out; empty where it does not.
std::vector<double> outline_seams(const Surface& surface, double gap = 0.0);

/// Positions near the even ones at which the points thin out over the whole width: where two things
/// meet. `spacing`: of the cloud [m]. As many as asked for (`pieces` - 1), or nothing.
std::optional<std::vector<double>> find_seams(const Surface& surface,
                                              const std::vector<Eigen::Vector3d>& points,
                                              int pieces, double spacing);

/// The list with some surfaces taken out and others put in, in the order of Surfaces, numbers and
/// points assigned anew. `place_of_added`: the new ids of `added`.
Surfaces with_changed(const Surfaces& surfaces, const std::vector<std::int32_t>& removed,
                      std::vector<Surface> added, std::vector<std::int32_t>* place_of_added);

}  // namespace scanchor
