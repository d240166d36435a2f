#pragma once
// Delaunay triangulation of points in a plane, as plain arrays.

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace scanchor {

/// Triangles by the indices of their corners, counter-clockwise. neighbours[t][k] is the triangle
/// across the edge opposite to corner k (the edge from corner k+1 to corner k+2), -1 outside the
/// convex hull.
struct Triangulation {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::array<std::int32_t, 3>> neighbours;
};

/// Exact predicates, so duplicates, collinear points and lattices are no special cases: of equal
/// points the first is a corner and the others are left out; points on one line give no triangle.
/// The result depends on the sequence of the points only where four or more lie on one circle. O(n
/// log n).
Triangulation delaunay(const std::vector<Eigen::Vector2d>& points);

/// Order of the points along a Hilbert curve over their bounding box, of more cells than there are
/// points (2^16 x 2^16 at most), ties by x, then y, then index: neighbours in the order are
/// neighbours in the plane, and a permutation of the points gives the same sequence of positions.
std::vector<std::uint32_t> hilbert_order(const std::vector<Eigen::Vector2d>& points);

}  // namespace scanchor
