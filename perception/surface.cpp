#include "perception/surface.hpp"

namespace scanchor {

double ring_area(const Ring& ring) {
  // Shoelace formula about the first vertex, which keeps the terms small far from the origin.
  double twice = 0.0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const Eigen::Vector2d a = ring[i] - ring[0];
    const Eigen::Vector2d b = ring[i + 1] - ring[0];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * twice;
}

double Polygon::area() const {
  double sum = ring_area(outer);
  for (const Ring& hole : holes) sum += ring_area(hole);  // clockwise: negative
  return sum;
}

std::string_view edge_kind_name(EdgeKind kind) {
  switch (kind) {
    case EdgeKind::true_edge:
      return "true_edge";
    case EdgeKind::occlusion:
      return "occlusion";
    case EdgeKind::view_limit:
      return "view_limit";
    case EdgeKind::unknown:
      break;
  }
  return "unknown";
}

}  // namespace scanchor
