#include "perception/find_planes.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "perception/cell_planes.hpp"
#include "perception/cell_tree.hpp"
#include "perception/noise.hpp"
#include "perception/paper_planes.hpp"
#include "perception/plane_fit.hpp"
#include "perception/set_aside.hpp"
#include "perception/thin_planes.hpp"

namespace scanchor {

void collect_surfaces(const PointCloud& cloud, const PlaneInput& input,
                      const std::vector<std::int32_t>& region_of, Surfaces& surfaces) {
  std::int32_t regions = 0;
  for (const auto region : region_of) regions = std::max(regions, region + 1);
  std::vector<std::vector<std::uint32_t>> inliers(static_cast<std::size_t>(regions));
  const auto& canonical = input.cloud;
  for (std::size_t i = 0; i < region_of.size(); ++i) {
    if (region_of[i] < 0) continue;
    auto& list = inliers[static_cast<std::size_t>(region_of[i])];
    for (auto s = canonical.first[i]; s < canonical.first[i + 1]; ++s) list.push_back(canonical.source[s]);
  }
  // Sums run over the canonical order, so that the last bit of a plane does not depend on the order of the input; only then are
  // the indices sorted.
  const double floor = least_noise(canonical, input.spacing);
  for (auto& list : inliers) {
    if (list.size() < 3) continue;
    Surface surface;
    surface.plane = fit_plane(cloud.points, list, surfaces.sensor_positions, floor);
    surface.T_cloud_surface = surface_frame(surface.plane, cloud.points, list);
    surface.confidence = plane_confidence(surface.plane, cloud.points, list, floor);
    std::sort(list.begin(), list.end());
    surface.inliers = std::move(list);
    surfaces.surfaces.push_back(std::move(surface));
  }
  std::sort(surfaces.surfaces.begin(), surfaces.surfaces.end(), [](const Surface& a, const Surface& b) {
    if (a.inliers.size() != b.inliers.size()) return a.inliers.size() > b.inliers.size();
    return a.inliers.front() < b.inliers.front();
  });
  for (std::size_t s = 0; s < surfaces.surfaces.size(); ++s) {
    surfaces.surfaces[s].id = static_cast<std::int32_t>(s);
    for (const auto i : surfaces.surfaces[s].inliers) {
      surfaces.plane_of_point[i] = static_cast<std::int32_t>(s);
    }
  }
}

Surfaces find_planes(const PointCloud& cloud, const PerceiveOptions& options) {
  if (options.method != "default" && options.method != "paper") {
    fail_usage("method \"" + options.method + "\" is neither \"default\" nor \"paper\"");
  }
  Surfaces surfaces;
  surfaces.plane_of_point.assign(cloud.size(), -1);
  for (const auto& pose : cloud.sensor_poses) surfaces.sensor_positions.push_back(pose.translation());
  const UsablePoints usable = set_aside(cloud, options.body_radius);
  surfaces.set_aside = usable.set_aside;

  PlaneInput input;
  input.cloud = canonical_cloud(cloud.points, usable.index);
  input.spacing = median_spacing(input.cloud);
  const CellTree tree = cell_tree(input.cloud);
  const double least = least_noise(input.cloud, input.spacing);
  input.sigma = options.noise_sigma > 0.0
                    ? std::max(options.noise_sigma, least)
                    : estimate_noise(input.cloud, tree, input.spacing, surfaces.sensor_positions);
  surfaces.noise_sigma = options.noise_sigma > 0.0 ? options.noise_sigma : input.sigma;
  surfaces.point_spacing = input.spacing;

  if (options.method == "paper") {
    collect_surfaces(cloud, input, paper_planes(input.cloud, input.sigma, PaperOptions{}), surfaces);
    return surfaces;
  }
  std::vector<std::int32_t> region_of_cell;
  PlaneLabels labels = cell_planes(input.cloud, tree, input.sigma, region_of_cell);
  thin_planes(input.cloud, tree, input.sigma, region_of_cell, labels);
  collect_surfaces(cloud, input, labels.of_point, surfaces);
  return surfaces;
}

}  // namespace scanchor
