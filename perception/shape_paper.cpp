#include "perception/shape_paper.hpp"

#include <algorithm>
#include <cmath>

#include "perception/alpha_shape.hpp"
#include "perception/hough_rectangle.hpp"
#include "perception/polygon_rings.hpp"
#include "perception/shape_common.hpp"

namespace scanchor {
namespace {

/// [m] radius of the disc that rolls along the points. The paper gives none. Four spacings bridge a
/// missing point of a lattice in both directions (its diagonal has 2.8) and keep gaps wider than
/// about eight spacings.
constexpr double radius_in_spacings = 4.0;

}  // namespace

void shape_as_paper(const PointCloud& cloud, Surface& surface) {
  const FlatPoints flat = flatten(cloud, surface);
  const Triangulation triangulation = delaunay(flat.points);
  const double radius = radius_in_spacings * median_spacing(flat.points, triangulation);
  surface.polygons = alpha_shape(flat.points, triangulation, radius);
  for (Polygon& polygon : surface.polygons) part_touching_holes(polygon);
  surface.eccentricity = ellipse_eccentricity(flat.points);

  double area = 0.0;
  std::vector<Eigen::Vector2d> outline;
  for (const Polygon& polygon : surface.polygons) {
    area += polygon.area();
    outline.insert(outline.end(), polygon.outer.begin(), polygon.outer.end());
  }
  if (outline.empty()) outline = flat.points;  // on a line: a rectangle without width
  surface.area = {area, area, area, false};
  surface.rectangle = minimum_area_rectangle(outline);

  const auto corners = hough_rectangle(surface.polygons);
  surface.is_rectangle = corners.has_value();
  if (corners) {
    // Means of opposite sides; the middle line of the longer pair gives the direction.
    const auto& c = *corners;
    const Eigen::Vector2d along = 0.5 * (c[1] - c[0] + c[2] - c[3]);
    const Eigen::Vector2d across = 0.5 * (c[3] - c[0] + c[2] - c[1]);
    const Eigen::Vector2d middle = 0.25 * (c[0] + c[1] + c[2] + c[3]);
    const double angle = std::atan2(along.y(), along.x());
    const Eigen::Vector2d half(0.5 * along.norm(), 0.5 * across.norm());
    surface.rectangle = rectangle_from_sides(angle, -half, half);
    surface.rectangle.center = middle;
  }
  const double box = surface.rectangle.length.value * surface.rectangle.width.value;
  surface.rectangularness = box > 0.0 ? std::min(1.0, area / box) : 0.0;
}

}  // namespace scanchor
