// CGAL's Efficient RANSAC (Schnabel, Wahl, Klein 2007). Epsilon 2 sigma, normals within cos 0.7,
// clusters of 8 cm. The library draws from a global generator: it is seeded before preprocess(), or
// two runs differ.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Random.h>
#include <CGAL/Shape_detection/Efficient_RANSAC.h>
#include <CGAL/pca_estimate_normals.h>
#include <CGAL/property_map.h>

#include "bench/peers/peer.hpp"

namespace scanchor::peers {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
// Point, normal, place in the input: the library reorders what it is given, and its indices are of
// the new order.
using Item = std::tuple<Point, Kernel::Vector_3, std::size_t>;
using PointMap = CGAL::Nth_of_tuple_property_map<0, Item>;
using NormalMap = CGAL::Nth_of_tuple_property_map<1, Item>;
using Cloud = std::vector<Item>;
using Traits = CGAL::Shape_detection::Efficient_RANSAC_traits<Kernel, Cloud, PointMap, NormalMap>;
using Ransac = CGAL::Shape_detection::Efficient_RANSAC<Traits>;
using PlaneShape = CGAL::Shape_detection::Plane<Traits>;

}  // namespace

Labels cgal_efficient_ransac(const Points& points, const PeerOptions& options) {
  Cloud cloud;
  cloud.reserve(points.size());
  for (const auto& p : points)
    cloud.emplace_back(Point(p[0], p[1], p[2]), Kernel::Vector_3(0, 0, 1), cloud.size());
  CGAL::pca_estimate_normals<CGAL::Sequential_tag>(
      cloud, static_cast<unsigned>(options.neighbours),
      CGAL::parameters::point_map(PointMap()).normal_map(NormalMap()));
  CGAL::get_default_random() = CGAL::Random(42);
  Ransac ransac;
  ransac.set_input(cloud);
  ransac.add_shape_factory<PlaneShape>();
  ransac.preprocess();
  Ransac::Parameters parameters;
  parameters.probability = 0.01;
  parameters.min_points = options.minimum;
  parameters.epsilon = 2.0 * options.sigma;
  parameters.normal_threshold = 0.7;
  parameters.cluster_epsilon = 0.08;
  ransac.detect(parameters);
  Labels labels(points.size(), -1);
  std::int32_t region = 0;
  for (const auto& shape : ransac.shapes()) {
    for (const auto i : shape->indices_of_assigned_points()) labels[std::get<2>(cloud[i])] = region;
    ++region;
  }
  return labels;
}

}  // namespace scanchor::peers
