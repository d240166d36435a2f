#include "reasoning/relation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/math.hpp"
#include "reasoning/angle_relations.hpp"
#include "reasoning/depth_relation.hpp"
#include "reasoning/likelihood.hpp"
#include "reasoning/relation_model.hpp"
#include "reasoning/size_relations.hpp"
#include "reasoning/support_relations.hpp"

namespace scanchor {

namespace {

constexpr double height_softness = 0.03;  // [m] of "bottom", "top", "elevation" limits, at least

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

/// That one of the two goes on towards the other, unseen, by `missing` [m]; `way` is the unit
/// vector from a to b where they are nearest.
double reaches(const Item& a, const Eigen::Vector3d& way, double missing,
               const RelationModel& model) {
  if (a.group) return 0.0;
  double best = 0.0;
  for (int side = 0; side < 4; ++side) {
    const Eigen::Vector3d outwards = (side % 2 == 0 ? 1.0 : -1.0) * (side < 2 ? a.along : a.across);
    const double slope = outwards.dot(way);
    if (slope < 0.3) continue;
    best = std::max(best, goes_on(a, side, 2.0 * (side < 2 ? a.half_length : a.half_width),
                                  missing / slope, model));
  }
  return best;
}

Evidence near(const Item& a, const Item& b, double limit, double softness,
              const RelationModel& model) {
  const bool faces = !a.group && !b.group;
  const Eigen::Vector3d step = faces ? nearest_step(a, b) : Eigen::Vector3d::Zero();
  const double gap = faces ? step.norm() : gap_distance(a, b);
  const double measured = std::hypot(a.edge_sigma, b.edge_sigma);
  double value = upper_likelihood(gap - model.near_short, limit, std::hypot(measured, softness));
  // The matcher leaves out pairs whose boxes are farther apart (Matcher, out_of_reach).
  if (faces && gap > limit && gap < 2.0 * limit + 1.4 && value < 0.95) {
    const Eigen::Vector3d way = step / gap;
    value += (1.0 - value) * model.near_meets *
             (1.0 - (1.0 - reaches(a, way, gap - limit, model)) *
                        (1.0 - reaches(b, -way, gap - limit, model)));
  }
  return {value, gap, measured, "m"};
}

/// Share of the smaller footprint in the larger one, the same whichever is named first.
double smaller_within(const Item& a, const Item& b) {
  const bool first = a.footprint.area() <= b.footprint.area();
  return first ? footprint_overlap(a.footprint, b.footprint)
               : footprint_overlap(b.footprint, a.footprint);
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

Evidence coplanar(const Item& a, const Item& b, double limit, const RelationModel& model) {
  const auto offset = [](const Item& plane, const Item& other) {
    const Eigen::Vector3d d = other.centroid - plane.centroid;
    const double variance = sqr(plane.offset_sigma) + d.dot(plane.normal_covariance * d);
    return std::make_pair(std::abs(plane.normal.dot(d)), variance);
  };
  // The larger one carries the plane; a small patch far away says little about where its plane goes
  // on.
  const bool first = a.area.value >= b.area.value;
  const auto [distance, variance] = first ? offset(a, b) : offset(b, a);
  // Where they lie in one plane, the one whose direction is known better says
  // so as well.
  const auto [distance_other, variance_other] = first ? offset(b, a) : offset(a, b);
  const bool surer = variance_other < variance;
  const auto measured_of = [&](double variance_there, double offset_sigma) {
    return std::sqrt(std::max(0.0, variance_there) + sqr(offset_sigma));
  };
  const double measured = measured_of(variance, first ? b.offset_sigma : a.offset_sigma);
  const double exact_distance = surer ? distance_other : distance;
  const double exact_measured =
      surer ? measured_of(variance_other, first ? a.offset_sigma : b.offset_sigma) : measured;
  // Some parallel faces of rooms lie in one plane to the millimetre (doors of a cabinet, panels,
  // boards of one height); the others are spread at about one a metre and pair. The middle of what
  // goes on in a shadow lies elsewhere, and so off the plane where the two are not quite parallel.
  const Item& smaller = first ? b : a;
  const double open = *std::max_element(smaller.open.begin(), smaller.open.end());
  const double elsewhere = model.hidden_middle * smaller.extension.value * sqr(open) *
                           std::sin(angle_between(a.normal, b.normal));
  double holds = 0.0, all = 0.0;
  for (const double factor : {1.0, model.gross_factor}) {
    const double share = factor > 1.0 ? model.gross_offset_share : 1.0 - model.gross_offset_share;
    const double s = std::hypot(factor * measured, elsewhere, model.plane_softness);
    const double s_exact = std::hypot(factor * exact_measured, elsewhere, model.plane_softness);
    const double exact =
        limit > 0.0 ? share * model.in_one_plane * 2.0 * normal_density(exact_distance, s_exact)
                    : 0.0;
    holds += exact + share * between_likelihood(distance, -limit, limit, s);
    all += exact + share;
  }
  if (holds <= 1e-6 * all) return {0.0, distance, measured, "m"};
  // That they lie in one plane speaks for their being parallel, too.
  const double parallel = parallel_relation(a, b, model).likelihood;
  const double value = parallel * holds / (parallel * all + 1.0 - parallel);
  return {value, distance, measured, "m"};
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
  return {upper_likelihood(turn, radians(45.0),
                           std::hypot(sigma, radians(around.model->bearing_softness))),
          degrees(turn), degrees(sigma), "deg"};
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
    case Feature::members: {
      const double n = static_cast<double>(std::max<std::size_t>(a.members.size(), 1));
      return {n >= range.low && n <= range.high ? 1.0 : 0.0, n, 0.0, "1"};
    }
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
  const RelationModel& model = *around.model;
  switch (term.relation) {
    case Relation::parallel:
      return parallel_relation(a, b, model);
    case Relation::orthogonal:
      return orthogonal_relation(a, b, model);
    default:
      break;
  }
  if (!a.has_shape || !b.has_shape) return {0.0, 0.0, 0.0, ""};
  switch (term.relation) {
    case Relation::above:
      return above_relation(a, b, around);
    case Relation::below:
      return above_relation(b, a, around);
    case Relation::on:
      return on_relation(a, b, around);
    case Relation::supports:
      return on_relation(b, a, around);
    case Relation::inside:
      return inside(a, b);
    case Relation::near: {
      const double limit = term.range.has_high() ? term.range.high : 0.5;
      return near(a, b, limit, model.near_softness * limit, model);
    }
    case Relation::touching:
      return near(a, b, 0.05, 0.02, model);
    case Relation::same_size:
      return same_size_relation(a, b, model);
    case Relation::aligned:
      return aligned_relation(a, b, model);
    case Relation::stacked:
      return stacked(a, b);
    case Relation::coplanar:
      return coplanar(a, b, term.range.has_high() ? term.range.high : 0.03, model);
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
    case Relation::set_back:
      return set_back_relation(term, a, b, around);
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
