#pragma once
// The paper's detection of rectangles (section 2, last steps, and section 3): the shape in a bitmap
// of 1 cm cells, lines by the Hough transform, four of them that meet in four points at about 90
// degrees.

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "perception/surface.hpp"

namespace scanchor {

struct HoughOptions {
  double cell =
      0.01;  ///< [m] of the bitmap, as in the paper; doubled until the shape fits in 4096 cells
  double angle_tolerance_deg = 10;  ///< about 90 degrees, about parallel
  double side_support = 0.5;        ///< share of each side that outline cells must lie along
  double outline_share = 0.8;       ///< share of the outline that must lie along the four sides
};

/// A line x cos(angle) + y sin(angle) = offset.
struct HoughLine {
  double angle = 0.0;   ///< [rad] of the normal, [0, pi)
  double offset = 0.0;  ///< [m]
  int votes = 0;        ///< outline cells along it
};

/// Lines of the outlines, strongest first, those of one edge merged and fitted anew to its cells.
/// Deterministic.
std::vector<HoughLine> hough_lines(const std::vector<Polygon>& polygons,
                                   const HoughOptions& options = {});

/// Four corners, counter-clockwise, where the lines hold a rectangle; the one with the
/// best-supported sides.
std::optional<std::array<Eigen::Vector2d, 4>> hough_rectangle(const std::vector<Polygon>& polygons,
                                                              const HoughOptions& options = {});

}  // namespace scanchor
