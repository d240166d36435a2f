#include "reasoning/corner.hpp"

#include <algorithm>
#include <cmath>

#include "reasoning/likelihood.hpp"

namespace scanchor {
namespace {

constexpr double most_gap =
    0.06;                       // [m] outlines of faces end about a point spacing before the edge
constexpr double wholly = 0.6;  // of 1; what runs through the plane is at 0

/// How far a face lies behind a plane, in halves of its own extent along the plane's normal: 1 for
/// the side of a box behind its front, -1 for a board that sticks out of a panel.
double behind(const Item& plane, const Item& face, const Eigen::Vector3d& viewpoint) {
  const double outwards = plane.normal.dot(viewpoint - plane.center) < 0.0 ? -1.0 : 1.0;
  const double half = std::abs(plane.normal.dot(face.along)) * face.half_length +
                      std::abs(plane.normal.dot(face.across)) * face.half_width;
  return outwards * plane.normal.dot(plane.center - face.center) / std::max(half, 1e-3);
}

}  // namespace

Evidence outer_edge(const Item& a, const Item& b, const Eigen::Vector3d& viewpoint) {
  Evidence none{0.0, 0.0, 0.0, "m"};
  if (!a.has_shape || !b.has_shape) return none;
  double value =
      lower_likelihood(std::min(behind(a, b, viewpoint), behind(b, a, viewpoint)), wholly, 0.15);
  if (value < 1e-3) return none;
  value *= relate({Relation::orthogonal, {}}, a, b, {}).likelihood;
  if (value < 1e-3) return none;
  const double gap = gap_distance(a, b);
  return {value * upper_likelihood(gap, most_gap, 0.02), gap,
          std::hypot(a.extension.sigma, b.extension.sigma), "m"};
}

Evidence cornered(const std::vector<Item>& items, const Item& item, const Surrounding& around) {
  if (!around.viewpoint) return {0.5, 0.0, 0.0, ""};
  Evidence best{0.0, 0.0, 0.0, "m"};
  for (const auto& other : items) {
    if (other.group || other.id == item.id) continue;
    // Boxes hold the outlines, so they bound the gap from below.
    if (item.box.exteriorDistance(other.box) > 3.0 * most_gap) continue;
    const Evidence edge = outer_edge(item, other, *around.viewpoint);
    if (edge.likelihood > best.likelihood) best = edge;
    if (best.likelihood > 0.999) break;
  }
  return best;
}

}  // namespace scanchor
