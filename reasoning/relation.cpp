#include "reasoning/relation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/math.hpp"
#include "reasoning/likelihood.hpp"

namespace scanchor {

namespace {

constexpr double angle_tolerance = radians(5.0);
constexpr double angle_softness = radians(1.0);
constexpr double height_softness = 0.03;  // [m] of "bottom", "top", "elevation" limits, at least

double sqr(double x) { return x * x; }

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), std::abs(a.dot(b)));
}

Evidence parallel(const Item& a, const Item& b) {
  const double theta = angle_between(a.normal, b.normal);
  const double measured = std::sqrt(sqr(a.tilt_sigma) + sqr(b.tilt_sigma));
  const double s = std::sqrt(sqr(measured) + sqr(angle_softness));
  return {cone_likelihood(theta, angle_tolerance, s), degrees(theta), degrees(measured), "deg"};
}

Evidence orthogonal(const Item& a, const Item& b) {
  const double off = 0.5 * pi - angle_between(a.normal, b.normal);
  // Only the tilts within the plane of both normals change the angle.
  const double variance =
      b.normal.dot(a.normal_covariance * b.normal) + a.normal.dot(b.normal_covariance * a.normal);
  const double s = std::sqrt(std::max(0.0, variance) + sqr(angle_softness));
  return {between_likelihood(off, -angle_tolerance, angle_tolerance, s), 90.0 - degrees(off),
          degrees(std::sqrt(std::max(0.0, variance))), "deg"};
}

/// Deviation of a difference in height over a horizontal distance: the up direction is only known
/// to up_sigma.
double height_sigma(const Item& a, const Item& b, const Surrounding& around) {
  const double distance = (a.center - b.center).head<2>().norm();
  return std::sqrt(sqr(a.z_sigma) + sqr(b.z_sigma) + sqr(around.up_sigma * distance));
}

/// Share of a's footprint that lies over b's, thickened by 5 cm.
double share_over(const Item& a, const Item& b) {
  Footprint wider = b.footprint;
  wider.u *= 1.0 + 0.05 / std::max(wider.u.norm(), 0.05);
  wider.v *= 1.0 + 0.05 / std::max(wider.v.norm(), 0.05);
  const double area = a.footprint.area();
  return area > 0.0 ? footprint_overlap(a.footprint, wider) * std::min(area, wider.area()) / area
                    : 0.0;
}

/// A wall is over the desk that stands at it by a corner only: what counts is how much of the upper
/// one lies over the lower one, as in the exact relations of a scene.
double overlap_likelihood(const Item& a, const Item& b) {
  const double overlap = share_over(a, b);
  return overlap > 0.0 ? lower_likelihood(overlap, 0.3, 0.1)
                       : 0.0;  // nothing in common is certain, not three deviations
}

Evidence above(const Item& a, const Item& b, const Surrounding& around) {
  const double measured = height_sigma(a, b, around);
  const double s = std::hypot(measured, 0.01);
  const double clearance = a.z_low - b.z_high;
  // Middle above middle makes above(a, b) + above(b, a) <= 1 hold for two things at one height.
  const double heights =
      lower_likelihood(clearance, -0.05, s) * lower_likelihood(a.z - b.z, 0.0, s);
  const double value = heights > 1e-6 ? heights * overlap_likelihood(a, b) : 0.0;
  return {value, clearance, measured, "m"};
}

Evidence on(const Item& a, const Item& b, const Surrounding& around) {
  const double measured = height_sigma(a, b, around);
  const double s = std::hypot(measured, 0.01);
  const double gap = a.z_low - b.z_high;
  double value = between_likelihood(gap, -0.03, 0.15, s);
  if (value > 1e-6) value *= horizontal(b, around).likelihood * overlap_likelihood(a, b);
  return {value, gap, measured, "m"};
}

Evidence inside(const Item& a, const Item& b) {
  const double common = share_over(a, b);
  const double low = std::max(a.z_low, b.z_low - 0.05);
  const double high = std::min(a.z_high, b.z_high + 0.05);
  const double length = a.z_high - a.z_low;
  const double heights =
      length > 0.01 ? std::clamp((high - low) / length, 0.0, 1.0) : (high >= low ? 1.0 : 0.0);
  const double share = common * heights;
  return {lower_likelihood(share, 0.8, 0.1), share, 0.0, "1"};
}

Evidence near(const Item& a, const Item& b, double limit, double softness) {
  const double gap = gap_distance(a, b);
  const double measured = std::hypot(a.extension.sigma, b.extension.sigma);
  return {upper_likelihood(gap, limit, std::hypot(measured, softness)), gap, measured, "m"};
}

/// Likelihood that two sizes are the same within a factor; the smaller one may be cut by a shadow.
double same(const Quantity& a, const Quantity& b, double factor) {
  if (a.value <= 0.0 || b.value <= 0.0) return 0.0;
  const double limit = std::log(factor);
  const double s = std::sqrt(sqr(a.sigma / a.value) + sqr(b.sigma / b.value) + sqr(0.05));
  const double ratio = std::log(a.value / b.value);
  double value = between_likelihood(ratio, -limit, limit, s);
  const double hidden = ratio < 0.0 ? a.hidden : b.hidden;
  if (hidden > 0.0) {
    const double k = (1.0 - hidden) / hidden;
    value += (1.0 - value) * std::exp(-k * std::max(0.0, std::abs(ratio) - limit));
  }
  return value;
}

Evidence same_size(const Item& a, const Item& b) {
  const double value = same(a.extension, b.extension, 1.15) * same(a.area, b.area, 1.25);
  const double ratio = b.extension.value > 0.0 ? a.extension.value / b.extension.value : 0.0;
  const double sigma = ratio * std::hypot(a.extension.sigma / std::max(a.extension.value, 1e-9),
                                          b.extension.sigma / std::max(b.extension.value, 1e-9));
  return {value, ratio, sigma, "1"};
}

/// Share of the smaller footprint in the larger one, the same whichever is named first.
double smaller_within(const Item& a, const Item& b) {
  const bool first = a.footprint.area() <= b.footprint.area();
  return first ? footprint_overlap(a.footprint, b.footprint)
               : footprint_overlap(b.footprint, a.footprint);
}

Evidence aligned(const Item& a, const Item& b) {
  const double size = std::max(std::min(a.extension.value, b.extension.value), 1e-3);
  const double distance = (a.center - b.center).head<2>().norm() / size;
  const double measured = std::sqrt(sqr(a.extension.sigma) + sqr(b.extension.sigma)) / size;
  double value = upper_likelihood(distance, 0.15, std::hypot(measured, 0.05));
  // The middle of what is left of a shadowed board is not its own; that the smaller one lies within
  // the other's outline remains.
  const double hidden =
      std::max({a.area.hidden, b.area.hidden, a.extension.hidden, b.extension.hidden});
  if (hidden > 0.0 && value < 0.9) {
    value = std::max(value, 0.9 * lower_likelihood(smaller_within(a, b), 0.6, 0.1));
  }
  // Stacked (S22): two things in one place are not one above the other.
  value *= lower_likelihood(std::abs(a.z - b.z), 0.05,
                            std::sqrt(sqr(a.z_sigma) + sqr(b.z_sigma) + sqr(0.01)));
  const bool elongated = a.half_length > 1.3 * a.half_width && b.half_length > 1.3 * b.half_width;
  if (elongated && value > 1e-6) {
    const double turn = angle_between(a.along, b.along);
    value *= between_likelihood(turn, -radians(10.0), radians(10.0), radians(3.0));
  }
  return {value, distance, measured, "1"};
}

/// One over the other like boards, drawers or boxes. Shadows and what lies on them cut such things
/// short, so neither their middles nor their sizes have to agree: the smaller one lies within the
/// footprint of the other.
Evidence stacked(const Item& a, const Item& b) {
  const double within = smaller_within(a, b);
  const double apart = lower_likelihood(std::abs(a.z - b.z), 0.05,
                                        std::sqrt(sqr(a.z_sigma) + sqr(b.z_sigma) + sqr(0.01)));
  return {lower_likelihood(within, 0.6, 0.1) * apart, within, 0.0, "1"};
}

Evidence coplanar(const Item& a, const Item& b, double limit) {
  const auto offset = [](const Item& plane, const Item& other) {
    const Eigen::Vector3d d = other.centroid - plane.centroid;
    const double variance = sqr(plane.offset_sigma) + d.dot(plane.normal_covariance * d);
    return std::make_pair(std::abs(plane.normal.dot(d)), variance);
  };
  // The larger one carries the plane; a small patch far away says little about where its plane goes
  // on.
  const bool first = a.area.value >= b.area.value;
  const auto [distance, variance] = first ? offset(a, b) : offset(b, a);
  const double other = first ? b.offset_sigma : a.offset_sigma;
  const double measured = std::sqrt(std::max(0.0, variance) + sqr(other));
  const double flat = between_likelihood(distance, -limit, limit, std::hypot(measured, 0.01));
  return {flat > 1e-6 ? flat * parallel(a, b).likelihood : 0.0, distance, measured, "m"};
}

Evidence sideways(Relation relation, const Item& a, const Item& b, const Surrounding& around) {
  if (!around.viewpoint)
    return {0.5, 0.0, 0.0, ""};  // without a point to look from, neither yes nor no
  Eigen::Vector2d forward = (b.center - *around.viewpoint).head<2>();
  const Eigen::Vector2d offset = (a.center - b.center).head<2>();
  if (forward.norm() < 1e-9 || offset.norm() < 1e-9) return {0.0, 0.0, 0.0, "deg"};
  forward.normalize();
  const Eigen::Vector2d left(-forward.y(), forward.x());
  Eigen::Vector2d wanted = left;
  if (relation == Relation::right_of) wanted = -left;
  if (relation == Relation::in_front_of) wanted = -forward;
  if (relation == Relation::behind) wanted = forward;
  const double turn = std::acos(std::clamp(wanted.dot(offset.normalized()), -1.0, 1.0));
  const double sigma = std::hypot(a.extension.sigma, b.extension.sigma) / offset.norm();
  return {upper_likelihood(turn, radians(45.0), std::hypot(sigma, radians(5.0))), degrees(turn),
          degrees(sigma), "deg"};
}

Evidence height_above(const RelationTerm& term, const Item& a, const Item& b,
                      const Surrounding& around) {
  const double x = (term.relation == Relation::bottom ? a.z_low
                    : term.relation == Relation::top  ? a.z_high
                                                      : a.z) -
                   b.z;
  const double measured = height_sigma(a, b, around);
  const auto soft = [&](double limit) {
    return std::isfinite(limit)
               ? std::sqrt(sqr(measured) + sqr(std::max(height_softness, 0.05 * std::abs(limit))))
               : 1.0;
  };
  double at_most = upper_likelihood(x, term.range.high, soft(term.range.high));
  double at_least = lower_likelihood(x, term.range.low, soft(term.range.low));
  // An end in the shadow: the true lower end may be lower, the true upper end higher (Beta(1, k)
  // share of the height hidden).
  const double hidden = a.height.hidden;
  const double height = std::max(a.height.value, 0.02);
  if (hidden > 0.0 && term.relation == Relation::bottom && x > term.range.high) {
    at_most += (1.0 - at_most) *
               std::pow(height / (height + x - term.range.high), (1.0 - hidden) / hidden);
  }
  if (hidden > 0.0 && term.relation == Relation::top && x < term.range.low) {
    at_least += (1.0 - at_least) *
                std::pow(height / (height + term.range.low - x), (1.0 - hidden) / hidden);
  }
  return {std::clamp(at_most + at_least - 1.0, 0.0, 1.0), x, measured, "m"};
}

}  // namespace

Evidence horizontal(const Item& a, const Surrounding& around, double tolerance_deg) {
  const double theta = angle_between(a.normal, Eigen::Vector3d::UnitZ());
  const double measured = std::hypot(a.tilt_sigma, around.up_sigma);
  return {cone_likelihood(theta, radians(tolerance_deg), std::hypot(measured, angle_softness)),
          degrees(theta), degrees(measured), "deg"};
}

Evidence vertical(const Item& a, const Surrounding& around, double tolerance_deg) {
  const double off = 0.5 * pi - angle_between(a.normal, Eigen::Vector3d::UnitZ());
  const double variance = std::max(0.0, a.normal_covariance(2, 2)) + sqr(around.up_sigma);
  const double tolerance = radians(tolerance_deg);
  return {between_likelihood(off, -tolerance, tolerance, std::sqrt(variance + sqr(angle_softness))),
          90.0 - degrees(off), degrees(std::sqrt(variance)), "deg"};
}

Evidence feature(Feature which, const Range& range, const Item& a) {
  if (!a.has_shape) return {0.0, 0.0, 0.0, ""};
  Quantity q;
  double softness = 0.05;
  const char* unit = "1";
  switch (which) {
    case Feature::area:
      q = a.area;
      softness = 0.15;
      unit = "m2";
      break;
    case Feature::extension:
      q = a.extension;
      softness = 0.10;
      unit = "m";
      break;
    case Feature::width:
      q = a.width;
      softness = 0.10;
      unit = "m";
      break;
    case Feature::height:
      q = a.height;
      softness = 0.10;
      unit = "m";
      break;
    case Feature::rectangularness:
      q = a.rectangularness;
      break;
    case Feature::elongation:
      q.value = a.extension.value / std::max(a.width.value, 1e-3);
      q.sigma = q.value * std::hypot(a.extension.sigma / a.extension.value,
                                     a.width.sigma / std::max(a.width.value, 1e-3));
      break;
  }
  const auto soft = [&](double limit) {
    return std::isfinite(limit) ? std::hypot(q.sigma, softness * limit) : 1.0;
  };
  const double at_most = censored_likelihood(q.value, -INFINITY, range.high, soft(range.high), 0.0);
  const double at_least =
      censored_likelihood(q.value, range.low, INFINITY, soft(range.low), q.hidden);
  return {std::clamp(at_most + at_least - 1.0, 0.0, 1.0), q.value, q.sigma, unit};
}

Evidence rectangular(const Item& a) {
  if (!a.has_shape) return {0.0, 0.0, 0.0, ""};
  const auto& r = a.rectangularness;
  return {censored_likelihood(r.value, 0.8, INFINITY, std::hypot(r.sigma, 0.07), r.hidden), r.value,
          r.sigma, "1"};
}

Evidence relate(const RelationTerm& term, const Item& a, const Item& b, const Surrounding& around) {
  switch (term.relation) {
    case Relation::parallel:
      return parallel(a, b);
    case Relation::orthogonal:
      return orthogonal(a, b);
    default:
      break;
  }
  if (!a.has_shape || !b.has_shape) return {0.0, 0.0, 0.0, ""};
  switch (term.relation) {
    case Relation::above:
      return above(a, b, around);
    case Relation::below:
      return above(b, a, around);
    case Relation::on:
      return on(a, b, around);
    case Relation::supports:
      return on(b, a, around);
    case Relation::inside:
      return inside(a, b);
    case Relation::near: {
      const double limit = term.range.has_high() ? term.range.high : 0.5;
      return near(a, b, limit, 0.1 * limit);
    }
    case Relation::touching:
      return near(a, b, 0.05, 0.02);
    case Relation::same_size:
      return same_size(a, b);
    case Relation::aligned:
      return aligned(a, b);
    case Relation::stacked:
      return stacked(a, b);
    case Relation::coplanar:
      return coplanar(a, b, term.range.has_high() ? term.range.high : 0.03);
    case Relation::higher:
    case Relation::lower: {
      const double sigma = height_sigma(a, b, around);
      const double dz = term.relation == Relation::higher ? a.z - b.z : b.z - a.z;
      return {lower_likelihood(dz, 0.0, std::max(sigma, 1e-9)), dz, sigma, "m"};
    }
    case Relation::elevation:
    case Relation::bottom:
    case Relation::top:
      return height_above(term, a, b, around);
    case Relation::left_of:
    case Relation::right_of:
    case Relation::in_front_of:
    case Relation::behind:
      return sideways(term.relation, a, b, around);
    default:
      return {};
  }
}

}  // namespace scanchor
