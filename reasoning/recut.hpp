#pragma once
// Surfaces cut in pieces and put together, with everything that is measured of them.

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

/// Positions at which the outline itself falls into pieces side by side, slivers (less than a tenth
/// of the largest) left out; empty where it does not.
std::vector<double> outline_seams(const Surface& surface);

/// Positions near the even ones at which the points thin out over the whole width: where two things
/// meet. `spacing`: of the cloud [m]. As many as asked for (`pieces` - 1), or nothing.
std::optional<std::vector<double>> find_seams(const Surface& surface,
                                              const std::vector<Eigen::Vector3d>& points,
                                              int pieces, double spacing);

/// Two surfaces in one plane as one, in the frame of the larger one, with what lies between them in
/// the shadow.
Surface join_surfaces(const Surface& a, const Surface& b);

/// How two surfaces in one plane face each other.
struct Facing {
  double gap = 0.0;     ///< [m] between the facing sides of their rectangles
  double common = 0.0;  ///< [0, 1] share of the shorter facing side that has the other opposite
  double shadow =
      0.0;  ///< [0, 1] share of the facing outline, the lesser of both, that is a shadow's
  double across = 0.0;  ///< [m] the other's middle above the plane
  double step = 0.0;    ///< [m] how far their sides along the gap's way are out of line
};
/// Nothing where they overlap, face each other with corners, or outlines were not examined.
std::optional<Facing> facing(const Surface& a, const Surface& b);

/// The list with some surfaces taken out and others put in, in the order of Surfaces, numbers and
/// points assigned anew. `place_of_added`: the new ids of `added`.
Surfaces with_changed(const Surfaces& surfaces, const std::vector<std::int32_t>& removed,
                      std::vector<Surface> added, std::vector<std::int32_t>* place_of_added);

}  // namespace scanchor
