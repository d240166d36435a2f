#pragma once
// The alpha shape of points in a plane (paper section 2; Edelsbrunner, Kirkpatrick, Seidel, "On the
// shape of a set of points in the plane", IEEE Trans. Inf. Theory 29, 1983).

#include <Eigen/Core>
#include <vector>

#include "perception/alpha_triangulation.hpp"
#include "perception/surface.hpp"

namespace scanchor {

/// The regularized alpha shape: the union of the Delaunay triangles whose circumscribed circle has
/// a radius of at most `radius` [m]. (CGAL's Alpha_shape_2 takes the square of the radius as its
/// alpha. It works out the interval of alpha for every triangle and edge; with one alpha known
/// beforehand, the filter on the triangles gives the same shape at a tenth of the cost.) Polygons
/// with holes, largest first; each ring is simple.
std::vector<Polygon> alpha_shape(const std::vector<Eigen::Vector2d>& points, double radius);
std::vector<Polygon> alpha_shape(const std::vector<Eigen::Vector2d>& points,
                                 const Triangulation& triangulation, double radius);

/// [m] median over the points of the distance to the nearest other point, which is a Delaunay
/// neighbour. 0 without triangles.
double median_spacing(const std::vector<Eigen::Vector2d>& points,
                      const Triangulation& triangulation);

}  // namespace scanchor
