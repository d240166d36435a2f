#include "reasoning/up.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/math.hpp"
#include "reasoning/up_evidence.hpp"

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

}  // namespace

UpDirection find_up(const Surfaces& surfaces, const std::string& given, double sigma) {
  UpDirection result;
  result.sigma = sigma;
  if (given == "auto") {
    const auto best = up_candidates(surfaces).front();
    result.up = best.up;
    result.upright = best.probability;
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
      const double area = surface.area.value;
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
  if (given != "auto") {
    // Who says where up is means it: it takes a fair amount of furniture to doubt the sign.
    const double odds = up_evidence(surfaces, result.up).score() -
                        up_evidence(surfaces, -result.up).score() + std::log(50.0);
    result.upright = 1.0 / (1.0 + std::exp(-odds));
  }
  return result;
}

}  // namespace scanchor
