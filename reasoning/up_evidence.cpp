#include "reasoning/up_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/math.hpp"

namespace scanchor {

namespace {

constexpr double large_area = 0.3;   // [m2] of what may be a floor, a wall or a ceiling
constexpr double voice_area = 0.05;  // [m2] that has a voice
constexpr double full_voice = 0.15;  // [m2]
const double level_limit = std::cos(radians(14.0));
const double usual_odds = std::log(20.0);  // frames with z up are the rule

/// Lowest and highest point of a surface's rectangle along a direction [m].
std::pair<double, double> reach(const Surface& surface, const Eigen::Vector3d& up) {
  const auto& r = surface.rectangle;
  const double c = std::cos(r.angle);
  const double s = std::sin(r.angle);
  const Eigen::Matrix3d axes = surface.T_cloud_surface.linear();
  const double half = 0.5 * std::abs(up.dot(axes * Eigen::Vector3d(c, s, 0.0))) * r.length.value +
                      0.5 * std::abs(up.dot(axes * Eigen::Vector3d(-s, c, 0.0))) * r.width.value;
  const double middle =
      up.dot(surface.T_cloud_surface * Eigen::Vector3d(r.center.x(), r.center.y(), 0.0));
  return {middle - half, middle + half};
}

/// What frames usually are (ROS REP 103): bodies and maps have z up; optical frames look along z
/// and have y down. A frame in which everything lies in front of the origin, in a cone of 60
/// degrees about z, is an optical one.
Eigen::Vector3d usual_up(const Surfaces& surfaces) {
  const bool optical =
      std::all_of(surfaces.surfaces.begin(), surfaces.surfaces.end(), [](const Surface& surface) {
        const Eigen::Vector3d& c = surface.plane.centroid;
        return c.z() > 0.0 && c.head<2>().norm() < 1.7320508 * c.z();
      });
  return optical ? Eigen::Vector3d(-Eigen::Vector3d::UnitY()) : Eigen::Vector3d::UnitZ();
}

/// One of each two that lie within 10 degrees of each other, or of each other's opposite.
std::vector<Eigen::Vector3d> axes_of(const Surfaces& surfaces, const Eigen::Vector3d& usual) {
  std::vector<const Surface*> large;
  for (const auto& surface : surfaces.surfaces) {
    if (surface.area.value >= large_area) large.push_back(&surface);
  }
  std::stable_sort(large.begin(), large.end(),
                   [](const auto* a, const auto* b) { return a->area.value > b->area.value; });
  if (large.size() > 24) large.resize(24);
  std::vector<Eigen::Vector3d> axes;
  const auto add = [&](const Eigen::Vector3d& axis) {
    const bool known = std::any_of(axes.begin(), axes.end(), [&](const Eigen::Vector3d& other) {
      return std::abs(other.dot(axis)) > std::cos(radians(10.0));
    });
    if (!known) axes.push_back(axis);
  };
  for (std::size_t i = 0; i < large.size(); ++i) {
    add(large[i]->plane.normal);
    for (std::size_t j = 0; j < i && j < 6; ++j) {
      const Eigen::Vector3d across = large[i]->plane.normal.cross(large[j]->plane.normal);
      if (across.norm() > 0.5) add(across.normalized());
    }
  }
  add(usual);
  return axes;
}

}  // namespace

double UpEvidence::score() const {
  return 1.0 * aligned + 0.4 * standing - 1.5 * hanging + 1.0 * tops - 0.5 * undersides +
         (height_of_room ? 1.2 : 0.0) + (sensor_height ? 1.9 : 0.0);
}

UpEvidence up_evidence(const Surfaces& surfaces, const Eigen::Vector3d& up) {
  UpEvidence evidence;
  double low = INFINITY;
  double high = -INFINITY;
  for (const auto& surface : surfaces.surfaces) {
    if (surface.area.value < large_area || std::abs(surface.plane.normal.dot(up)) < level_limit)
      continue;
    const double z = up.dot(surface.plane.centroid);
    low = std::min(low, z);
    high = std::max(high, z);
  }
  const double height = high - low;
  // Floors and ceilings of real rooms come in pieces at several heights.
  const double rim = std::max(0.15, 0.12 * height);
  for (const auto& surface : surfaces.surfaces) {
    const double area = surface.area.value;
    if (area < voice_area) continue;
    const double c = surface.plane.normal.dot(up);
    const double off =
        std::min(std::acos(std::min(1.0, std::abs(c))), std::asin(std::min(1.0, std::abs(c))));
    const double voice = std::min(1.0, area / full_voice);
    evidence.aligned += voice * std::exp(-0.5 * off * off / (radians(3.0) * radians(3.0)));
    if (std::abs(c) < 0.1) {
      const auto [bottom, top] = reach(surface, up);
      // What is taller may be a wall, of which the other part is hidden.
      if (top - bottom > 0.45 * height) continue;
      if (bottom < low + 0.2 && top < high - 0.4) evidence.standing += voice;
      if (top > high - 0.2 && bottom > low + 0.4) evidence.hanging += voice;
    }
    const double z = up.dot(surface.plane.centroid);
    if (std::abs(c) > level_limit && z > low + rim && z < high - rim)
      (c > 0.0 ? evidence.tops : evidence.undersides) += std::min(1.0, area);
  }
  evidence.height_of_room = height > 2.0 && height < 4.0;
  if (!surfaces.sensor_positions.empty()) {
    const double above = up.dot(surfaces.sensor_positions.front()) - low;
    evidence.sensor_height = above > 0.2 && above < 2.0;
  }
  return evidence;
}

std::vector<UpCandidate> up_candidates(const Surfaces& surfaces) {
  const Eigen::Vector3d usual = usual_up(surfaces);
  struct Scored {
    Eigen::Vector3d up;
    double score;
  };
  std::vector<Scored> scored;
  for (const Eigen::Vector3d& axis : axes_of(surfaces, usual)) {
    for (const double sign : {1.0, -1.0}) {
      const Eigen::Vector3d up = sign * axis;
      const double frame = up.dot(usual) > std::cos(radians(10.0)) ? usual_odds : 0.0;
      scored.push_back({up, up_evidence(surfaces, up).score() + frame});
    }
  }
  std::stable_sort(scored.begin(), scored.end(),
                   [](const auto& a, const auto& b) { return a.score > b.score; });
  std::vector<UpCandidate> candidates;
  double sum = 0.0;
  for (const auto& [up, score] : scored) {
    candidates.push_back({up, std::exp(score - scored.front().score)});
    sum += candidates.back().probability;
  }
  for (auto& candidate : candidates) candidate.probability /= sum;
  return candidates;
}

}  // namespace scanchor
