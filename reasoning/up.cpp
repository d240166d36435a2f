#include "reasoning/up.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/math.hpp"

namespace scanchor {

namespace {

constexpr double softness = radians(0.7);  // floors and walls of buildings are not exact either
constexpr double smallest_area = 0.3;  // [m2] that a surface needs to say something about gravity

std::optional<Eigen::Vector3d> parse_direction(const std::string& text) {
  Eigen::Vector3d v;
  const char* p = text.c_str();
  for (int i = 0; i < 3; ++i) {
    char* end = nullptr;
    v[i] = std::strtod(p, &end);
    if (end == p) return std::nullopt;
    p = end;
    while (*p == ' ') ++p;
    if (i < 2 && *p++ != ',') return std::nullopt;
  }
  if (*p != '\0' || !v.allFinite() || v.norm() < 1e-9) return std::nullopt;
  return v.normalized();
}

double area_of(const Surface& surface) { return surface.area.value; }

/// Area that is within about 3 degrees of parallel or orthogonal to the direction, flat parts
/// counted by their heights as well.
double support(const Surfaces& surfaces, const Eigen::Vector3d& up) {
  double sum = 0.0;
  for (const auto& surface : surfaces.surfaces) {
    if (area_of(surface) < smallest_area) continue;
    const double c = std::abs(surface.plane.normal.dot(up));
    const double off = std::min(std::acos(std::min(1.0, c)), std::asin(std::min(1.0, c)));
    sum += area_of(surface) * std::exp(-0.5 * off * off / (radians(3.0) * radians(3.0)));
  }
  return sum;
}

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

/// Furniture stands on the floor and ends below the ceiling, and the tops among it lie in the lower
/// half of the room, where they are seen from above. The sign of the sum says whether the direction
/// or its opposite is up; about two units a square metre. Boards of high racks are seen from below
/// and speak against it, so what stands weighs more than what lies.
double upright_evidence(const Surfaces& surfaces, const Eigen::Vector3d& up) {
  double low = INFINITY;
  double high = -INFINITY;
  for (const auto& surface : surfaces.surfaces) {
    if (area_of(surface) < smallest_area || std::abs(surface.plane.normal.dot(up)) < 0.97) continue;
    const double z = up.dot(surface.plane.centroid);
    low = std::min(low, z);
    high = std::max(high, z);
  }
  const bool seen_from_somewhere = !surfaces.sensor_positions.empty();
  double evidence = 0.0;
  for (const auto& surface : surfaces.surfaces) {
    const double c = surface.plane.normal.dot(up);
    if (area_of(surface) < 0.05) continue;
    if (std::abs(c) < 0.1 && high - low > 1.8) {
      const auto [bottom, top] = reach(surface, up);
      // What is taller may be a wall, of which the other part is hidden. Each thing has one voice:
      // the many small ones stand, while the large ones among those that hang are pieces of walls.
      if (top - bottom > 0.45 * (high - low)) continue;
      const double voice = std::min(1.0, area_of(surface) / 0.15);
      if (bottom < low + 0.2 && top < high - 0.4) evidence += voice;
      if (top > high - 0.2 && bottom > low + 0.4) evidence -= voice;
    }
    if (std::abs(c) < 0.97) continue;
    const double z = up.dot(surface.plane.centroid);
    // The lowest and the highest planes are floor and ceiling either way round; real ones come in
    // pieces at several heights.
    const double rim = std::max(0.15, 0.12 * (high - low));
    if (z < low + rim || z > high - rim) continue;
    const double weight = std::min(1.0, area_of(surface));
    if (seen_from_somewhere) {
      evidence += (c > 0.0 ? 1.5 : -1.5) * weight;
    } else if (high - low > 1.8) {
      evidence += (z < 0.5 * (low + high) ? 1.0 : -1.0) * weight;
    }
  }
  return evidence;
}

/// What frames usually are (ROS REP 103): bodies and maps have z up; optical frames look along z
/// and have y down. A frame in which everything lies in front of the origin, in a cone of 60
/// degrees about z, is an optical one. A room's three directions have the same support but for what
/// is hidden, so a little decides: 1 along the usual up direction (within 8 degrees), -1 against
/// it, else 0.
double usual_frame(const Surfaces& surfaces, const Eigen::Vector3d& trial) {
  const bool optical =
      std::all_of(surfaces.surfaces.begin(), surfaces.surfaces.end(), [](const Surface& surface) {
        const Eigen::Vector3d& c = surface.plane.centroid;
        return c.z() > 0.0 && c.head<2>().norm() < 1.7320508 * c.z();
      });
  const double along = optical ? -trial.y() : trial.z();
  return std::abs(along) > std::cos(radians(8.0)) ? (along > 0.0 ? 1.0 : -1.0) : 0.0;
}

}  // namespace

UpDirection find_up(const Surfaces& surfaces, const std::string& given, double sigma) {
  UpDirection result;
  result.sigma = sigma;
  if (given == "auto") {
    // Three directions are enough: gravity is the normal of some large surface, or across two of
    // them.
    std::vector<Eigen::Vector3d> trials;
    std::vector<const Surface*> large;
    for (const auto& surface : surfaces.surfaces) {
      if (area_of(surface) >= smallest_area) large.push_back(&surface);
    }
    std::stable_sort(large.begin(), large.end(),
                     [](const auto* a, const auto* b) { return area_of(*a) > area_of(*b); });
    if (large.size() > 24) large.resize(24);
    for (std::size_t i = 0; i < large.size(); ++i) {
      trials.push_back(large[i]->plane.normal);
      for (std::size_t j = 0; j < i && j < 6; ++j) {
        const Eigen::Vector3d across = large[i]->plane.normal.cross(large[j]->plane.normal);
        if (across.norm() > 0.5) trials.push_back(across.normalized());
      }
    }
    // A room has three such directions; up is the one with furniture on one side. Area decides
    // first, then furniture.
    double best = -1.0;
    for (const auto& trial : trials) {
      const double value =
          support(surfaces, trial) * (1.0 + 0.15 * std::abs(usual_frame(surfaces, trial))) +
          std::abs(upright_evidence(surfaces, trial));
      if (value > best + 1e-9) {
        best = value;
        result.up = trial;
      }
    }
    // The usual sign is worth two square metres of table tops.
    if (upright_evidence(surfaces, result.up) + 2.0 * usual_frame(surfaces, result.up) < 0.0)
      result.up = -result.up;
    result.sigma = radians(5.0);
  } else {
    const auto direction = parse_direction(given);
    if (!direction) fail_usage("up direction '" + given + "' is neither \"x,y,z\" nor \"auto\"");
    result.up = *direction;
  }

  // Gauss-Newton on the two tilts, with a prior of the given deviation; Cauchy weights let
  // furniture that leans fall out.
  const double gate = std::max(radians(8.0), 3.0 * result.sigma);
  const Eigen::Vector3d start = result.up;
  Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
  for (int iteration = 0; iteration < 12; ++iteration) {
    const Eigen::Vector3d up = result.up;
    const Eigen::Vector3d e1 = up.unitOrthogonal();
    const Eigen::Vector3d e2 = up.cross(e1);
    const double prior = 1.0 / (result.sigma > 0.0 ? sigma * sigma + 1e-12 : 1e-12);
    information = Eigen::Matrix2d::Identity() *
                  (given == "auto" ? 1.0 / (radians(5.0) * radians(5.0)) : prior);
    Eigen::Vector2d gradient =
        information * Eigen::Vector2d(e1.dot(start - up), e2.dot(start - up));
    int supports = 0;
    for (const auto& surface : surfaces.surfaces) {
      const double area = area_of(surface);
      if (area < smallest_area) continue;
      const Eigen::Vector3d& n = surface.plane.normal;
      const double c = n.dot(up);
      const auto& covariance = surface.plane.normal_covariance;
      // Small things lean more than large ones: the softness falls with the size, down to that of
      // buildings.
      const double soft = softness * std::max(1.0, 1.0 / std::sqrt(area));
      if (std::abs(c) > std::cos(gate)) {
        const Eigen::Vector3d d = (c > 0.0 ? n : Eigen::Vector3d(-n)) - up;
        const Eigen::Vector2d r(e1.dot(d), e2.dot(d));
        const double variance = 0.5 * covariance.trace() + soft * soft;
        const double w = 1.0 / (1.0 + r.squaredNorm() / (4.0 * variance)) / variance;
        information += Eigen::Matrix2d::Identity() * w;
        gradient += r * w;
        ++supports;
      } else if (std::abs(c) < std::sin(gate)) {
        Eigen::Vector2d j(n.dot(e1), n.dot(e2));  // d(n.up)/d(tilt)
        const double variance = std::max(0.0, up.dot(covariance * up)) + soft * soft;
        const double w = 1.0 / (1.0 + c * c / (4.0 * variance)) / variance;
        information += j * j.transpose() * w;
        gradient -= j * c * w;
        ++supports;
      }
    }
    result.supports = supports;
    const Eigen::Vector2d step = information.ldlt().solve(gradient);
    result.up = (up + e1 * step.x() + e2 * step.y()).normalized();
    if (step.norm() < 1e-9) break;
  }
  result.sigma = std::sqrt(0.5 * information.inverse().trace());
  // One reading of the world is an even bet against "the cloud is upside down" only with a fair
  // amount of furniture.
  const double evidence = upright_evidence(surfaces, result.up);
  result.upright = 1.0 / (1.0 + std::exp(-(evidence + std::log(50.0))));
  return result;
}

}  // namespace scanchor
