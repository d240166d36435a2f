#pragma once
// Two surfaces in one plane as one, and how they face each other.

#include <optional>

#include "perception/surface.hpp"

namespace scanchor {

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

}  // namespace scanchor
