#include "perception/set_aside.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scanchor {
namespace {

// Range of a point from the nearest sensor: in a merged cloud nobody says which sensor saw it.
std::vector<float> ranges_of(const PointCloud& cloud, const std::vector<std::uint32_t>& index) {
  std::vector<float> ranges(index.size());
  for (std::size_t k = 0; k < index.size(); ++k) {
    double nearest2 = std::numeric_limits<double>::infinity();
    for (const auto& pose : cloud.sensor_poses) {
      nearest2 = std::min(nearest2, (cloud.points[index[k]] - pose.translation()).squaredNorm());
    }
    ranges[k] = static_cast<float>(std::sqrt(nearest2));
  }
  return ranges;
}

// The radius of an empty shell around the sensor, or 0.
double find_body(const std::vector<float>& ranges) {
  constexpr double reach = 1.0, gap = 1.25, share = 0.005;
  std::vector<float> near;
  for (const float r : ranges) {
    if (r < reach * gap) near.push_back(r);
  }
  std::sort(near.begin(), near.end());
  const auto least = static_cast<std::size_t>(std::max(20.0, share * static_cast<double>(ranges.size())));
  for (std::size_t i = near.size(); i-- > least;) {
    if (near[i - 1] < reach && near[i] > gap * near[i - 1]) return 0.5 * (near[i - 1] + near[i]);
  }
  // Nothing between the cluster and the end of the search: the shell reaches past it.
  if (near.size() >= least && near.size() < ranges.size() && near.back() < reach) {
    return 0.5 * near.back() * (1.0 + gap);
  }
  return 0.0;
}

// Ranges from here on are the scanner's way of saying "nothing seen"; infinity where it has none.
float out_of_range_from(const std::vector<float>& ranges) {
  if (ranges.empty()) return std::numeric_limits<float>::infinity();
  const float largest = *std::max_element(ranges.begin(), ranges.end());
  const float from = largest * (1.0F - 1e-4F);
  const auto count = std::count_if(ranges.begin(), ranges.end(), [&](float r) { return r >= from; });
  const double least = std::max(20.0, 5e-4 * static_cast<double>(ranges.size()));
  // All points at one range would be a test object on a sphere, not a scanner's limit.
  const bool limit = static_cast<double>(count) >= least && 2 * static_cast<std::size_t>(count) < ranges.size();
  return limit ? from : std::numeric_limits<float>::infinity();
}

}  // namespace

UsablePoints set_aside(const PointCloud& cloud, double body_radius) {
  UsablePoints usable;
  usable.index.reserve(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (cloud.points[i].allFinite()) {
      usable.index.push_back(static_cast<std::uint32_t>(i));
    } else {
      ++usable.set_aside.not_finite;
    }
  }
  if (cloud.sensor_poses.empty() || usable.index.empty()) return usable;
  const auto ranges = ranges_of(cloud, usable.index);
  const float limit = out_of_range_from(ranges);
  usable.body_radius = body_radius < 0.0 ? find_body(ranges) : body_radius;
  const auto body = static_cast<float>(usable.body_radius);
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
