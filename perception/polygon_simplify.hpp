#pragma once
// Rings with as few vertices as the measurement supports.

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "perception/surface.hpp"

namespace scanchor {

/// A ring whose vertices are known only within `tolerance[i]` [m].
struct RoughRing {
  Ring points;
  std::vector<double> tolerance;  ///< [m] one a vertex, above 0
};

/// Indices of the vertices that stay, rising: Douglas and Peucker (Cartographica 10, 1973) on the
/// closed ring, where each vertex that goes lies within its own tolerance of the edge that replaces
/// it. At least three, at least four where the ring has them and needs them.
std::vector<std::uint32_t> simplify(const RoughRing& ring);

/// The ring with straight edges: each edge between two kept vertices is fitted to all vertices
/// along it by least squares (so the wavering averages out), neighbouring edges are brought to
/// intersection. One vertex for each entry of `kept`. A vertex moves by at most three times its
/// tolerance; where the fit would need more it stays.
Ring straighten(const RoughRing& ring, const std::vector<std::uint32_t>& kept);

}  // namespace scanchor
