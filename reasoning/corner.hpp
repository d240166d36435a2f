#pragma once
// Outer edges: where two faces of one body meet.

#include <vector>

#include "reasoning/relation.hpp"

namespace scanchor {

/// That two faces meet at a right angle at an outer edge, as the front and the side of a box do:
/// orthogonal, within 6 cm of each other, and each wholly behind the plane of the other as seen
/// from `viewpoint`. A board that sticks out of a panel and a monitor on a desk do not. Symmetric;
/// measured is the gap [m].
Evidence outer_edge(const Item& a, const Item& b, const Eigen::Vector3d& viewpoint);

/// The word "cornered": the best outer edge of an item with any other surface. One half without a
/// viewpoint: it cannot be told which side of a face is outside. The evidence names no target.
Evidence cornered(const std::vector<Item>& items, const Item& item, const Surrounding& around);

}  // namespace scanchor
