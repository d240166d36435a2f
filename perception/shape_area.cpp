#include "perception/shape_area.hpp"

#include <algorithm>
#include <cmath>

#include "core/polygons.hpp"

namespace scanchor {

Measured polygon_area(const std::vector<Polygon>& polygons, const std::vector<OutlineEdge>& edges) {
  Measured area;
  for (const Polygon& polygon : polygons) area.value += polygon.area();
  double variance = 0.0;
  for (const OutlineEdge& e : edges) {
    const double length = (e.to - e.from).norm();
    const double whole = e.gap * e.gap / 12.0;
    const double wavering = std::min(whole, e.waver * e.waver);
    const double runs = std::max(1.0, 0.5 * length / std::max(e.gap, 1e-12));
    variance += length * length * (std::max(0.02 * whole, whole - wavering) + wavering / runs);
  }
  const double half = 1.959963984540054 * std::sqrt(variance);
  area.low = std::max(0.0, area.value - half);
  area.high = area.value + half;
  return area;
}

double area_outside(const std::vector<Polygon>& polygons, const FittedRectangle& rectangle,
                    bool beyond_ends, bool beyond_sides) {
  const Eigen::Vector2d u = unit_vector(rectangle.angle);
  const Eigen::Vector2d v(-u.y(), u.x());
  const auto outside = [&](const Ring& ring) {  // of a hole: negative
    Ring inside = ring;
    const auto cut = [&](const Eigen::Vector2d& outwards, double half) {
      const Eigen::Vector2d along(-outwards.y(), outwards.x());
      const Eigen::Vector2d at = rectangle.center + half * outwards;
      clip(inside, at, at + along);  // keeps what lies to the left, which is inside
    };
    for (const double side : {1.0, -1.0}) {
      if (beyond_ends) cut(side * u, 0.5 * rectangle.length.value);
      if (beyond_sides) cut(side * v, 0.5 * rectangle.width.value);
    }
    return ring_area(ring) - ring_area(inside);
  };
  double sum = 0.0;
  for (const Polygon& polygon : polygons) {
    sum += outside(polygon.outer);
    for (const Ring& hole : polygon.holes) sum += outside(hole);
  }
  return std::max(0.0, sum);
}

void take_off(double doubtful, Measured& area) {
  area.value = std::max(0.0, area.value - doubtful);
  area.low = std::max(0.0, area.low - doubtful);
}

}  // namespace scanchor
