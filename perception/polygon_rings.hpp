#pragma once
// From the directed boundary of a triangulated region to closed rings.

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "perception/surface.hpp"

namespace scanchor {

/// A piece of boundary with the region on its left. `component`: which edge-connected piece of the
/// region it bounds.
struct BoundarySegment {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  std::uint32_t component = 0;
  EdgeKind kind = EdgeKind::unknown;
};

/// A closed ring of nodes, each at most once; kinds[i] is of the edge from nodes[i] to nodes[i +
/// 1].
struct BoundaryRing {
  std::vector<std::uint32_t> nodes;
  std::vector<EdgeKind> kinds;
  std::uint32_t component = 0;
  double area = 0.0;  ///< [m2] signed: outer rings positive, holes negative
};

/// Chains segments into rings. Where several rings meet in one node they are cut apart there, so
/// that each ring is simple as long as no two segments cross. Every node must have as many arriving
/// as leaving segments. Rings begin at their smallest node by (x, y) and come sorted by component,
/// then by falling area, then by that node: the sequence of the input does not matter.
std::vector<BoundaryRing> chain_rings(const std::vector<Eigen::Vector2d>& nodes,
                                      const std::vector<BoundarySegment>& segments);

/// The polygons of the rings as they are: one a component, largest first, its holes behind it.
std::vector<Polygon> rings_to_polygons(const std::vector<Eigen::Vector2d>& nodes,
                                       const std::vector<BoundaryRing>& rings);

/// Where a hole shares a vertex with the outer ring or another hole it gives way by a millionth of
/// its edges there, so that no two rings touch (polygon_check.hpp).
void part_touching_holes(Polygon& polygon);

}  // namespace scanchor
