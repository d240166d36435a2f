#include "reasoning/scene_extent.hpp"

#include <algorithm>
#include <cmath>

#include "reasoning/likelihood.hpp"

namespace scanchor {

namespace {

constexpr double extremum_tolerance = 0.10;  // [m] S18: within 10 cm of the 1st percentile
constexpr double extremum_share = 0.01;

/// Area that is there beyond doubt [m2]: a plane seen at a grazing angle through a gap has an
/// outline of any size, and must not say where the room ends.
double sure_area(const Item& item) {
  return std::max(0.0, item.area.value - 2.0 * item.area.sigma);
}

struct HeightShare {
  double z, area;
};

/// Height below which the given share of the area lies; NAN without area.
double percentile(std::vector<HeightShare> levels, double share) {
  double total = 0.0;
  for (const auto& level : levels) total += level.area;
  std::sort(levels.begin(), levels.end(),
            [](const HeightShare& a, const HeightShare& b) { return a.z < b.z; });
  double below = 0.0;
  for (const auto& level : levels) {
    below += level.area;
    if (below >= share * total) return level.z;
  }
  return levels.empty() ? NAN : levels.back().z;
}

/// Lowest (sign 1) or highest (-1) level of the scene. Floors and ceilings are level (S18): a wall
/// whose outline runs out through a window must not move them. But where walls, most of them, go on
/// beyond all that is level, the end of the walls is it: the floor was not seen, and the tops of
/// desks are none.
double end_level(const std::vector<Item>& items, const std::vector<Evidence>& horizontal,
                 double sign) {
  constexpr double beyond = 0.3;
  std::vector<HeightShare> flat;
  std::vector<HeightShare> upright;
  for (const auto& item : items) {
    const double area = sure_area(item);
    if (!item.has_shape || area <= 0.0) continue;
    const double level = horizontal[static_cast<std::size_t>(item.id)].likelihood;
    if (level > 0.1) flat.push_back({sign * item.z, area * level});
    if (level < 0.1) upright.push_back({sign > 0.0 ? item.z_low : -item.z_high, area});
  }
  const double of_flat = percentile(std::move(flat), extremum_share);
  const double of_walls = percentile(std::move(upright), 0.5);
  if (std::isnan(of_flat) && std::isnan(of_walls)) return 0.0;
  return sign * (std::isnan(of_flat) || of_walls < of_flat - beyond ? of_walls : of_flat);
}

}  // namespace

SceneExtent::SceneExtent(const std::vector<Item>& items, const std::vector<Evidence>& horizontal) {
  low_level_ = end_level(items, horizontal, 1.0);
  high_level_ = end_level(items, horizontal, -1.0);
  double total = 0.0;
  std::vector<std::int32_t> order;
  for (const auto& item : items) {
    if (!item.has_shape || sure_area(item) <= 0.0) continue;
    middle_ += item.center * sure_area(item);
    total += sure_area(item);
    order.push_back(item.id);
  }
  if (total > 0.0) middle_ /= total;
  std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    const double first = sure_area(items[a]);
    const double second = sure_area(items[b]);
    return first != second ? first > second : a < b;
  });
  if (order.size() > 256) order.resize(256);
  for (const auto id : order) {
    const Item& item = items[id];
    largest_.push_back({item.center, item.along * item.half_length, item.across * item.half_width,
                        sure_area(item)});
  }
}

double SceneExtent::outside_share(const Item& a) const {
  Eigen::Vector3d inwards = a.normal;
  if (inwards.dot(middle_ - a.center) < 0.0) inwards = -inwards;
  double behind = 0.0;
  double total = 0.0;
  for (const auto& b : largest_) {
    const double d = inwards.dot(b.center - a.center);
    const double half = std::abs(inwards.dot(b.along)) + std::abs(inwards.dot(b.across));
    const double reach = std::max(half, 1e-3);
    behind += b.area * std::clamp((-extremum_tolerance - (d - reach)) / (2.0 * reach), 0.0, 1.0);
    total += b.area;
  }
  return total > 0.0 ? behind / total : 0.0;
}

Evidence SceneExtent::extremum(Extremum which, const Item& item, const Surrounding& around) const {
  if (!item.has_shape) return {};
  if (which == Extremum::outermost) {
    const double share = outside_share(item);
    return {upper_likelihood(share, 0.02, 0.01), share, 0.0, "1"};
  }
  if (which != Extremum::lowest && which != Extremum::highest) return {};
  const double reach = (item.center - middle_).head<2>().norm();
  const double sigma = std::hypot(item.z_sigma, around.up_sigma * reach);
  const double off = which == Extremum::lowest ? item.z - low_level_ : high_level_ - item.z;
  return {upper_likelihood(off, extremum_tolerance, std::hypot(sigma, 0.02)), off, sigma, "m"};
}

}  // namespace scanchor
