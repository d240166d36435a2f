#pragma once
// The four sides of a rectangle, roughly: where the outline of a surface runs, and how well.

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <vector>

#include "perception/surface.hpp"

namespace scanchor {

/// A straight edge of the outline, region on its left.
struct OutlineEdge {
  Eigen::Vector2d from, to;  ///< [m]
  EdgeKind kind = EdgeKind::unknown;
  double gap = 0.0;    ///< [m] between the samples on its two sides
  double waver = 0.0;  ///< [m] rms distance of the raw outline from the edge
};

/// One of the four sides. Position is the distance from the middle along the outward normal.
struct RectangleSide {
  double turn = 0.0;  ///< of the outward normal against the main direction: 0, 90, 180, 270 degrees
  double position = 0.0;         ///< [m] first guess
  double gap = 0.0;              ///< [m] width of the uncertainty
  double waver = 0.0;            ///< [m] rms of the raw outline about it
  double low = 0.0, high = 0.0;  ///< [m] extent along the side
  double support = 0.0;
  bool censored = false;
  /// [m], [m2] what sticks out and may be another thing: how much farther in most of the true edges
  /// lie that face this way, and the area beyond them; where no edge is seen, a last twelfth of the
  /// area that is less than half as broad as the rest.
  double loose = 0.0, loose_area = 0.0;
};

inline Eigen::Vector2d unit_vector(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// [rad] direction modulo a right angle, [-pi/4, pi/4), that most of the outline has.
double main_direction(const std::vector<OutlineEdge>& edges);

/// First guess of a side, whose `turn` is set: walking inwards from the outermost edge that faces
/// this way until a tenth of the side is met, or three samples of true edge, but never past what
/// has much of the area beyond it.
void guess_side(const std::vector<OutlineEdge>& edges, double direction, RectangleSide& side);

}  // namespace scanchor
