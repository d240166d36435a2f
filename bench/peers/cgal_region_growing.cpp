// CGAL's region growing on a point set (Shape_detection package), with its own sorting of seeds.
// Maximum distance 3 sigma, maximum angle 40 degrees, k = 20 for growing and 24 for normals: the
// best of twelve settings.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Shape_detection/Region_growing/Region_growing.h>
#include <CGAL/Shape_detection/Region_growing/Region_growing_on_point_set.h>
#include <CGAL/pca_estimate_normals.h>
#include <CGAL/property_map.h>

#include <iterator>

#include "bench/peers/peer.hpp"

namespace scanchor::peers {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using PointWithNormal = std::pair<Point, Kernel::Vector_3>;
using PointMap = CGAL::First_of_pair_property_map<PointWithNormal>;
using NormalMap = CGAL::Second_of_pair_property_map<PointWithNormal>;
using Cloud = std::vector<PointWithNormal>;
using Query = CGAL::Shape_detection::Point_set::K_neighbor_query<Kernel, Cloud, PointMap>;
using Region =
    CGAL::Shape_detection::Point_set::Least_squares_plane_fit_region<Kernel, Cloud, PointMap,
                                                                     NormalMap>;
using Sorting = CGAL::Shape_detection::Point_set::Least_squares_plane_fit_sorting<Kernel, Cloud,
                                                                                  Query, PointMap>;
using Growing = CGAL::Shape_detection::Region_growing<Cloud, Query, Region, Sorting::Seed_map>;

}  // namespace

Labels cgal_region_growing(const Points& points, const PeerOptions& options) {
  Cloud cloud;
  cloud.reserve(points.size());
  for (const auto& p : points)
    cloud.emplace_back(Point(p[0], p[1], p[2]), Kernel::Vector_3(0, 0, 1));
  CGAL::pca_estimate_normals<CGAL::Sequential_tag>(
      cloud, static_cast<unsigned>(options.neighbours),
      CGAL::parameters::point_map(PointMap()).normal_map(NormalMap()));
  Query query(cloud, 20);
  Region region(cloud, 3.0 * options.sigma, 40.0, options.minimum);
  Sorting sorting(cloud, query);
  sorting.sort();
  Growing growing(cloud, query, region, sorting.seed_map());
  std::vector<std::vector<std::size_t>> regions;
  growing.detect(std::back_inserter(regions));
  Labels labels(points.size(), -1);
  for (std::size_t r = 0; r < regions.size(); ++r) {
    for (const auto i : regions[r]) labels[i] = static_cast<std::int32_t>(r);
  }
  return labels;
}

}  // namespace scanchor::peers
