#include "perception/set_aside.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/parallel.hpp"

namespace scanchor {
namespace {

// Range of a point from the nearest sensor: in a merged cloud nobody says which sensor saw it.
std::vector<float> ranges_of(const PointCloud& cloud, const std::vector<std::uint32_t>& index) {
  std::vector<float> ranges(index.size());
  parallel_blocks(index.size(), 16384, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      double nearest2 = std::numeric_limits<double>::infinity();
      for (const auto& pose : cloud.sensor_poses) {
        nearest2 = std::min(nearest2, (cloud.points[index[k]] - pose.translation()).squaredNorm());
      }
      ranges[k] = static_cast<float>(std::sqrt(nearest2));
    }
  });
  return ranges;
}

// The radius of the scanner's own body: of a cluster of near returns with a shell around it that is
// empty but for mixed pixels. 0: none.
double find_body(const std::vector<float>& ranges) {
  constexpr double reach = 1.0;  // of a body with nothing at all around it
  constexpr double reach_veiled =
      0.5;  // of one with a veil of mixed pixels between its edges and the room
  constexpr double gap = 1.25, share = 0.005, veil = 0.05;
  std::vector<float> near;
  for (const float r : ranges) {
    if (r < reach * gap) near.push_back(r);
  }
  std::sort(near.begin(), near.end());
  const auto least =
      static_cast<std::size_t>(std::max(20.0, share * static_cast<double>(ranges.size())));
  double radius = 0.0;
  std::size_t fewest = 0, end = 0;  // `end`: first return beyond the shell around the first i
  for (std::size_t i = least; i <= near.size() && i < ranges.size() && near[i - 1] < reach; ++i) {
    while (end < near.size() && near[end] <= gap * near[i - 1]) ++end;
    const std::size_t between = end - i;
    const bool shell =
        between == 0 || (near[i - 1] < reach_veiled &&
                         static_cast<double>(between) <= veil * static_cast<double>(i));
    if (!shell) {
      if (radius > 0.0) break;  // the first gap ends: what follows is the room
      continue;
    }
    if (radius > 0.0 && between >= fewest) continue;
    radius = 0.5 * near[i - 1] * (1.0 + gap);
    fewest = between;
    if (between == 0) break;
  }
  return radius;
}

// Ranges from here on are the scanner's way of saying "nothing seen"; infinity where it has none.
float out_of_range_from(const std::vector<float>& ranges) {
  if (ranges.empty()) return std::numeric_limits<float>::infinity();
  const float largest = *std::max_element(ranges.begin(), ranges.end());
  const float from = largest * (1.0F - 1e-4F);
  const auto count =
      std::count_if(ranges.begin(), ranges.end(), [&](float r) { return r >= from; });
  const double least = std::max(20.0, 5e-4 * static_cast<double>(ranges.size()));
  // All points at one range would be a test object on a sphere, not a scanner's limit.
  const bool limit =
      static_cast<double>(count) >= least && 2 * static_cast<std::size_t>(count) < ranges.size();
  return limit ? from : std::numeric_limits<float>::infinity();
}

// Indices of the points that are numbers.
std::vector<std::uint32_t> finite_points(const PointCloud& cloud) {
  constexpr std::size_t block = 16384;
  std::vector<std::vector<std::uint32_t>> found(cloud.size() / block + 1);
  parallel_blocks(cloud.size(), block, [&](std::size_t begin, std::size_t end) {
    auto& here = found[begin / block];
    here.reserve(end - begin);
    for (std::size_t i = begin; i < end; ++i) {
      const Eigen::Vector3d& p = cloud.points[i];
      const double zero = 0.0 * p.x() + 0.0 * p.y() + 0.0 * p.z();  // else no number
      if (zero == 0.0) here.push_back(static_cast<std::uint32_t>(i));
    }
  });
  if (found.size() == 1) return std::move(found.front());
  std::vector<std::uint32_t> all;
  all.reserve(cloud.size());
  for (const auto& here : found) all.insert(all.end(), here.begin(), here.end());
  return all;
}

}  // namespace

UsablePoints set_aside(const PointCloud& cloud, double body_radius) {
  UsablePoints usable;
  usable.index = finite_points(cloud);
  usable.set_aside.not_finite = cloud.size() - usable.index.size();
  if (cloud.sensor_poses.empty() || usable.index.empty()) return usable;
  const auto ranges = ranges_of(cloud, usable.index);
  const float limit = out_of_range_from(ranges);
  usable.body_radius = body_radius < 0.0 ? find_body(ranges) : body_radius;
  const auto body = static_cast<float>(usable.body_radius);
  if (body <= 0.0F && !(limit < std::numeric_limits<float>::infinity())) return usable;
  std::size_t kept = 0;
  for (std::size_t k = 0; k < ranges.size(); ++k) {
    if (ranges[k] >= limit) {
      ++usable.set_aside.out_of_range;
    } else if (ranges[k] < body) {
      ++usable.set_aside.scanner_body;
    } else {
      usable.index[kept++] = usable.index[k];
    }
  }
  usable.index.resize(kept);
  return usable;
}

}  // namespace scanchor
