#pragma once
// Second half of the default method: planes among the points of the pool, at the level of points.

#include <functional>

#include "perception/point_pool.hpp"

namespace scanchor {

/// Fewest points that make a plane: fewer fit a plane by accident too often (docs/why/planes.md).
inline constexpr std::size_t fewest_points = 20;

/// Things to do for which nobody waits yet.
struct BesideThinPlanes {
  std::function<void()> growing = [] {};
  std::function<void()> overgrowing = [] {};  ///< begins when growing has ended
};

/// Lets the regions of cell_planes claim the pool points on their planes, finds further planes
/// among the rest, and decides for each pool point between the planes around it. Labels and planes
/// are updated; planes of fewer than `fewest_points` are dissolved. Growing and overgrowing let
/// each plane wait for the one before: what `beside` names is done beside them, each once.
void thin_planes(const CanonicalCloud& cloud, const CellTree& tree, const BeamNoise& noise,
                 const std::vector<std::int32_t>& region_of_cell, PlaneLabels& labels,
                 const BesideThinPlanes& beside = {});

}  // namespace scanchor
