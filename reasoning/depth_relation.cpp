#include "reasoning/depth_relation.hpp"

#include <algorithm>
#include <cmath>

#include "core/math.hpp"
#include "reasoning/angle_relations.hpp"
#include "reasoning/likelihood.hpp"

namespace scanchor {

namespace {

constexpr double most_turned = 20.0;     // [deg]
constexpr double turn_softness = 3.0;    // [deg]
constexpr double depth_softness = 0.01;  // [m]

}  // namespace

Evidence set_back_relation(const RelationTerm& term, const Item& a, const Item& b,
                           const Surrounding& around) {
  if (!around.viewpoint) return {0.5, 0.0, 0.0, ""};
  const bool faces_it = b.normal.dot(*around.viewpoint - b.centroid) >= 0.0;
  const Eigen::Vector3d towards = faces_it ? b.normal : Eigen::Vector3d(-b.normal);
  const Eigen::Vector3d d = a.centroid - b.centroid;
  const double depth = -towards.dot(d);
  const double measured = std::sqrt(sqr(a.offset_sigma) + sqr(b.offset_sigma) +
                                    std::max(0.0, d.dot(b.normal_covariance * d)));
  const auto soft = [&](double limit) {
    return std::hypot(measured, std::max(depth_softness, 0.05 * std::abs(limit)));
  };
  double value = 1.0;
  if (term.range.has_low()) value *= lower_likelihood(depth, term.range.low, soft(term.range.low));
  if (term.range.has_high())
    value *= upper_likelihood(depth, term.range.high, soft(term.range.high));
  const double turn_sigma = std::hypot(turn_softness, degrees(a.tilt_sigma), degrees(b.tilt_sigma));
  value *= upper_likelihood(degrees(angle_between(a.normal, b.normal)), most_turned, turn_sigma);
  return {value, depth, measured, "m"};
}

}  // namespace scanchor
