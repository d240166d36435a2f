#include "perception/find_planes.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "perception/bent_planes.hpp"
#include "perception/cell_planes.hpp"
#include "perception/cell_tree.hpp"
#include "perception/chance_planes.hpp"
#include "perception/connect_planes.hpp"
#include "perception/noise.hpp"
#include "perception/paper_planes.hpp"
#include "perception/plane_fit.hpp"
#include "perception/set_aside.hpp"
#include "perception/sheet_planes.hpp"
#include "perception/smooth_planes.hpp"
#include "perception/thin_planes.hpp"

namespace scanchor {

namespace {

struct RegionPart {
  std::int32_t region;
  std::uint32_t count;  // points of the input
  Moments moments;      // of different ones, about the canonical origin
};

// Writes the region of each point of the input, and sums them up in double precision, in blocks of
// the canonical order: the last bit of a plane depends neither on the order of the input nor on who
// took which block.
std::vector<RegionPart> sum_by_region(const PointCloud& cloud, const CanonicalCloud& canonical,
                                      const std::vector<std::int32_t>& region_of,
                                      std::vector<std::int32_t>& plane_of_point) {
  constexpr std::size_t block = 8192, ahead = 32;
  const Eigen::Vector3d origin = canonical.T_cloud_canonical.translation();
  const std::size_t n = region_of.size();
  std::vector<std::vector<RegionPart>> parts((n + block - 1) / block);
  parallel_blocks(n, block, [&](std::size_t begin, std::size_t end) {
    auto& here = parts[begin / block];
    std::size_t last = 0;
    for (std::size_t i = begin; i < end; ++i) {
      // The input lies in another order: its points are far from each other.
      if (i + ahead < n) {
        const auto next = canonical.source[canonical.first[i + ahead]];
        __builtin_prefetch(&cloud.points[next].x());
        __builtin_prefetch(&cloud.points[next].z());  // every fourth lies across two lines
        __builtin_prefetch(&plane_of_point[next], 1);
      }
      const auto region = region_of[i];
      if (region < 0) continue;
      if (here.empty() || here[last].region != region) {
        last = 0;
        while (last < here.size() && here[last].region != region) ++last;
        if (last == here.size()) here.push_back({region, 0, {}});
      }
      RegionPart& part = here[last];
      const Eigen::Vector3d d = cloud.points[canonical.source[canonical.first[i]]] - origin;
      part.moments.add(d.x(), d.y(), d.z());
      for (auto s = canonical.first[i]; s < canonical.first[i + 1]; ++s) {
        plane_of_point[canonical.source[s]] = region;
        ++part.count;
      }
    }
  });
  std::vector<RegionPart> all;
  for (const auto& here : parts) all.insert(all.end(), here.begin(), here.end());
  return all;
}

}  // namespace

void collect_surfaces(const PointCloud& cloud, const PlaneInput& input,
                      const std::vector<std::int32_t>& region_of, Surfaces& surfaces) {
  const auto& canonical = input.cloud;
  std::size_t regions = 0;
  for (const auto region : region_of)
    regions = std::max(regions, static_cast<std::size_t>(region + 1));
  const Eigen::Vector3d origin = canonical.T_cloud_canonical.translation();
  std::vector<Moments> moments(regions);
  std::vector<std::uint32_t> count(regions, 0);
  for (const auto& part : sum_by_region(cloud, canonical, region_of, surfaces.plane_of_point)) {
    const auto r = static_cast<std::size_t>(part.region);
    moments[r].add(part.moments);
    count[r] += part.count;
  }
  const double floor = least_noise(canonical, input.spacing);
  std::vector<Surface> found(regions);
  for (std::size_t r = 0; r < regions; ++r) {
    if (moments[r].n < 3.0) continue;
    std::optional<Eigen::Vector3d> beam;
    if (input.noise_along_beams && surfaces.sensor_positions.size() == 1)
      beam = (origin + moments[r].mean() - surfaces.sensor_positions.front()).normalized();
    const MomentPlane fit = beam ? fit_plane_along(moments[r], *beam) : fit_plane(moments[r]);
    found[r].plane =
        plane_from_moments(moments[r], fit, origin, surfaces.sensor_positions, floor, beam);
    found[r].T_cloud_surface = surface_frame(found[r].plane, fit.axes.col(2));
  }
  // Some 2000 points of a surface, evenly along the canonical order, tell whether it bends.
  std::vector<BendTest> bend(regions);
  std::vector<std::vector<std::uint32_t>> sample(regions);
  const auto take_samples = [&] {
    std::vector<std::uint32_t> left(regions, 0);  // until the next that is taken
    for (std::size_t i = 0; i < region_of.size(); ++i) {
      if (region_of[i] < 0) continue;
      const auto r = static_cast<std::size_t>(region_of[i]);
      if (left[r]-- != 0) continue;
      left[r] = count[r] / 2048;
      sample[r].push_back(canonical.source[canonical.first[i]]);
    }
  };
  std::optional<PlaneMembers> inliers;  // in the input's order: rising
  parallel_blocks(2, 1, [&](std::size_t task, std::size_t) {
    if (task == 0) {
      take_samples();
    } else {
      inliers.emplace(surfaces.plane_of_point, regions);
    }
  });
  parallel_blocks(regions, 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r) {
      const auto axes = found[r].T_cloud_surface.linear();
      for (const auto s : sample[r]) {
        const Eigen::Vector3d d = cloud.points[s] - found[r].plane.centroid;
        bend[r].add(axes.col(0).dot(d), axes.col(1).dot(d), axes.col(2).dot(d));
      }
      found[r].inliers.assign((*inliers)[r].begin(), (*inliers)[r].end());
    }
  });
  std::vector<std::size_t> order;
  for (std::size_t r = 0; r < regions; ++r) {
    if (moments[r].n >= 3.0) order.push_back(r);
  }
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if (found[a].inliers.size() != found[b].inliers.size())
      return found[a].inliers.size() > found[b].inliers.size();
    return found[a].inliers.front() < found[b].inliers.front();
  });
  std::vector<std::int32_t> id_of(regions, -1);
  for (const auto r : order) {
    found[r].id = id_of[r] = static_cast<std::int32_t>(surfaces.surfaces.size());
    found[r].confidence = bend[r].confidence(floor);
    surfaces.surfaces.push_back(std::move(found[r]));
  }
  auto& plane_of_point = surfaces.plane_of_point;
  parallel_blocks(plane_of_point.size(), 16384, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (plane_of_point[i] >= 0)
        plane_of_point[i] = id_of[static_cast<std::size_t>(plane_of_point[i])];
    }
  });
}

PlaneInput plane_input(const PointCloud& cloud, const PerceiveOptions& options,
                       Surfaces& surfaces) {
  surfaces.plane_of_point.assign(cloud.size(), -1);
  for (const auto& pose : cloud.sensor_poses)
    surfaces.sensor_positions.push_back(pose.translation());
  const UsablePoints usable = set_aside(cloud, options.body_radius);
  surfaces.set_aside = usable.set_aside;
  PlaneInput input;
  input.cloud = canonical_cloud(cloud.points, usable.index);
  input.spacing = median_spacing(input.cloud);
  surfaces.point_spacing = input.spacing;
  return input;
}

Surfaces find_planes(const PointCloud& cloud, const PerceiveOptions& options) {
  if (options.method != "default" && options.method != "paper") {
    fail_usage("method \"" + options.method + "\" is neither \"default\" nor \"paper\"");
  }
  Surfaces surfaces;
  PlaneInput input = plane_input(cloud, options, surfaces);
  CellTree tree = cell_tree(input.cloud);
  const double least = least_noise(input.cloud, input.spacing);
  input.sigma = options.noise_sigma > 0.0
                    ? std::max(options.noise_sigma, least)
                    : estimate_noise(input.cloud, tree, input.spacing, surfaces.sensor_positions);
  surfaces.noise_sigma = options.noise_sigma > 0.0 ? options.noise_sigma : input.sigma;

  if (options.method == "paper") {
    input.noise_along_beams = false;
    collect_surfaces(cloud, input, paper_planes(input.cloud, input.sigma, options.paper), surfaces);
    return surfaces;
  }
  std::vector<std::int32_t> region_of_cell;
  BeamNoise noise(input.sigma);
  if (surfaces.sensor_positions.size() == 1) {
    noise = BeamNoise(input.sigma,
                      input.cloud.T_cloud_canonical.inverse() * surfaces.sensor_positions.front());
    see_from(noise.sensor, input.cloud);
  }
  bool bent = false;
  PlaneLabels labels;
  parallel_blocks(2, 1, [&](std::size_t task, std::size_t) {
    if (task == 0) {
      labels = cell_planes(input.cloud, tree, noise, region_of_cell);
    } else {
      bent = estimate_flatness(tree, input.sigma) > bent_from * input.sigma;
    }
  });
  tree.moments = {};  // nobody asks for them from here on, and they are a third of the memory
  std::optional<BeamGrid> grid;
  BesideThinPlanes beside;
  BeamPlaces places;
  if (noise.sensor_known) {  // the grid asks for nothing but the points
    beside.growing = [&] { places = place_beams(input.cloud, noise.sensor); };
    beside.overgrowing = [&] { grid.emplace(std::move(places)); };
  }
  thin_planes(input.cloud, tree, noise, region_of_cell, labels, beside);
  drop_chance_planes(input.cloud, tree, labels);
  split_sheets(input.cloud, labels, noise);
  if (grid) smooth_planes(input.cloud, *grid, labels, noise);
  if (grid) connect_planes(input.cloud, *grid, noise, fewest_points, labels);
  if (bent) join_bent_planes(input.cloud, tree, input.sigma, labels);
  collect_surfaces(cloud, input, labels.of_point, surfaces);
  return surfaces;
}

}  // namespace scanchor
