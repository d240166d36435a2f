#include "reasoning/support_relations.hpp"

#include <algorithm>
#include <cmath>

#include "core/math.hpp"
#include "reasoning/likelihood.hpp"
#include "reasoning/relation_model.hpp"

namespace scanchor {

namespace {

constexpr double held_margin = 0.025;  // [m] that footprints of items hold
constexpr double level_cosine = 0.94;  // normals this near to vertical: 20 degrees
constexpr double unseen_reach = 0.35;  // of its length that a thing is taken to go on unseen
constexpr double level_past = 0.04;    // level faces reach past a level one hardly ever (GapPrior)

bool is_level(const Item& item) { return !item.group && std::abs(item.normal.z()) > level_cosine; }

/// A footprint whose sides are moved out by `by` [m].
Footprint resized(Footprint foot, double by) {
  const double u = foot.u.norm(), v = foot.v.norm();
  if (u > 1e-6) foot.u *= std::max(0.01, u + by) / u;
  if (v > 1e-6) foot.v *= std::max(0.01, v + by) / v;
  return foot;
}

/// `far_share`, `far_rate`: of sides that were seen to end.
double goes_on(const Item& item, int side, double length, double beyond, const RelationModel& model,
               double far_share, double far_rate) {
  if (beyond <= 0.0) return 1.0;
  const double x = beyond / std::max(length, 0.05);
  const double hidden = model.shadow_share * sqr(item.open[static_cast<std::size_t>(side)]);
  return hidden * std::exp(-model.shadow_rate * x) +
         (1.0 - hidden) * (model.end_share * std::exp(-model.end_rate * x) +
                           far_share * std::exp(-far_rate * x));
}

/// A wall is over the desk that stands at it by a corner only: what counts is how much of the upper
/// one lies over the lower one, as in the exact relations of a scene. The lower one may go on below
/// the upper one where it was not seen.
double overlap_likelihood(const Item& a, const Item& b, const RelationModel& model) {
  const double overlap = share_over(a, b);
  double value = overlap > 0.0 ? lower_likelihood(overlap, 0.3, model.overlap_softness)
                               : 0.0;  // nothing in common is certain, not three deviations
  if (value > 0.95 || !is_level(b)) return value;
  // Where the middle of a is in b's plane, straight below.
  Eigen::Vector3d d = a.center - b.center;
  d.z() = -d.head<2>().dot(b.normal.head<2>()) / b.normal.z();
  const double x = d.dot(b.along), y = d.dot(b.across);
  const double past_x = std::abs(x) - b.half_length, past_y = std::abs(y) - b.half_width;
  // No farther than the boxes say (plan_gap).
  if (std::hypot(std::max(0.0, past_x), std::max(0.0, past_y)) > overlap_reach(b)) return value;
  const auto reaches = [&](int side, double length, double past) {
    return goes_on(b, side, length, past, model, model.carrier_far_share, model.carrier_far_rate);
  };
  const double covered = reaches(x > 0.0 ? 0 : 1, 2.0 * b.half_length, past_x) *
                         reaches(y > 0.0 ? 2 : 3, 2.0 * b.half_width, past_y);
  // Nothing stands beyond the end of a floor: that there is something speaks for the floor going
  // on, and the more, the larger it is.
  const double odds = 1.0 + model.carries * b.area.value;
  if (covered < 1.0) value += (1.0 - value) * covered * odds / (covered * odds + 1.0 - covered);
  return value;
}

/// How gaps between the lower end of a thing and a level face below its middle
/// are spread, against a metre somewhere above it: in contact and on feet or a
/// plinth [m], and a metre past it.
struct GapPrior {
  double contact, feet, past;
};

struct GapLikelihoods {
  double on, above;  // gap within -3 .. 15 cm; at least -5 cm
};

/// The lower end of a is measured `gap` above a level face, with deviation s; it may go on
/// downwards unseen, or what was taken for its lower end belongs to something else.
GapLikelihoods gap_likelihoods(const Item& a, double gap, double s, const RelationModel& model) {
  const bool longer = std::abs(a.along.z()) > std::abs(a.across.z());
  const double slope = longer ? a.along.z() : a.across.z();
  const bool upright = !a.group && std::abs(slope) > 0.3;
  const GapPrior prior =
      upright || a.group ? GapPrior{model.upright_contact, model.upright_feet, model.upright_past}
                         : GapPrior{0.0, model.level_feet, level_past};
  const int side = (longer ? 0 : 2) + (slope > 0.0 ? 1 : 0);
  const double length =
      std::max(0.05, 2.0 * (longer ? a.half_length : a.half_width) * std::abs(slope));
  const double hidden =
      upright ? model.shadow_share * sqr(a.open[static_cast<std::size_t>(side)]) : 0.0;
  const double tail = upright ? model.tail_share * (1.0 - hidden) : 0.0;
  const double foreign = upright ? model.foreign_share : 0.0;
  const double core = 1.0 - hidden - tail - foreign;
  const double foreign_scale = model.foreign_scale;
  const double hidden_rate = model.shadow_rate / length, tail_rate = model.end_rate / length;
  const auto measured_at = [&](double off) {  // density of measuring the end `off` above the truth
    double d = core * normal_density(off, s);
    if (off > 0.0)
      d += hidden * hidden_rate * std::exp(-hidden_rate * off) +
           tail * tail_rate * std::exp(-tail_rate * off);
    if (off < 0.0) d += foreign * std::exp(off / foreign_scale) / foreign_scale;
    return d;
  };
  // That the true end is above t.
  const auto above_t = [&](double t) {
    double p = core * lower_likelihood(gap, t, s);
    if (gap > t)
      p += foreign + hidden * (1.0 - std::exp(-hidden_rate * (gap - t))) +
           tail * (1.0 - std::exp(-tail_rate * (gap - t)));
    else
      p += foreign * std::exp((gap - t) / foreign_scale);
    return p;
  };
  const double contact = prior.contact * measured_at(gap);
  double feet = 0.0;
  for (const double t : {0.04, 0.085, 0.13}) feet += prior.feet / 3.0 * measured_at(gap - t);
  if (!upright) feet = prior.feet / 0.13 * between_likelihood(gap, 0.0, 0.15, s);
  const double higher = above_t(0.15);
  const double lower = prior.past * (1.0 - above_t(-0.03));
  const double all = contact + feet + higher + lower;
  if (all <= 0.0) return {0.0, gap > -0.05 ? 1.0 : 0.0};
  return {(contact + feet) / all, (contact + feet + higher) / all};
}

}  // namespace

double plan_gap(const Item& a, const Item& b) {
  return std::max({0.0, a.box.min().x() - b.box.max().x(), b.box.min().x() - a.box.max().x(),
                   a.box.min().y() - b.box.max().y(), b.box.min().y() - a.box.max().y()});
}

double overlap_reach(const Item& lower) {
  const double open = *std::max_element(lower.open.begin(), lower.open.end());
  return overlap_thickening +
         (is_level(lower) && open > 0.3 ? unseen_reach * lower.extension.value : 0.0);
}

double height_sigma(const Item& a, const Item& b, const Surrounding& around) {
  const double distance = (a.center - b.center).head<2>().norm();
  return std::sqrt(sqr(a.z_sigma) + sqr(b.z_sigma) + sqr(around.up_sigma * distance));
}

double goes_on(const Item& item, int side, double length, double beyond,
               const RelationModel& model) {
  return goes_on(item, side, length, beyond, model, model.far_share, model.far_rate);
}

double top_under(const Item& b, const Item& a) {
  if (!is_level(b)) return b.z_high;
  const Eigen::Vector2d d = (a.center - b.center).head<2>();
  return b.center.z() - b.normal.head<2>().dot(d) / b.normal.z();
}

double share_over(const Item& a, const Item& b) {
  const auto own = [](const Item& item) {
    return item.group ? -held_margin
                      : (std::abs(item.normal.z()) < 0.09 ? 0.03 : 0.0) - held_margin;
  };
  const Footprint upper = resized(a.footprint, own(a));
  const Footprint lower = resized(b.footprint, own(b) + 0.05);
  const double area = upper.area();
  return area > 0.0 ? footprint_overlap(upper, lower) * std::min(area, lower.area()) / area : 0.0;
}

Evidence above_relation(const Item& a, const Item& b, const Surrounding& around) {
  const double measured = height_sigma(a, b, around);
  const RelationModel& model = *around.model;
  const double s = std::hypot(measured, model.end_softness);
  const double clearance = a.z_low - top_under(b, a);
  // Middle above middle makes above(a, b) + above(b, a) <= 1 hold for two things at one height.
  double heights = lower_likelihood(a.z - b.z, 0.0, s);
  if (heights > 1e-6)
    heights *= is_level(b) ? gap_likelihoods(a, clearance, s, model).above
                           : lower_likelihood(clearance, -0.05, s);
  const double value = heights > 1e-6 ? heights * overlap_likelihood(a, b, model) : 0.0;
  return {value, clearance, measured, "m"};
}

Evidence on_relation(const Item& a, const Item& b, const Surrounding& around) {
  const double measured = height_sigma(a, b, around);
  const RelationModel& model = *around.model;
  const double s = std::hypot(measured, model.end_softness);
  const double gap = a.z_low - top_under(b, a);
  double value = lower_likelihood(a.z - b.z, 0.0, s);
  if (value > 1e-6) value *= gap_likelihoods(a, gap, s, model).on;
  if (value > 1e-6) value *= overlap_likelihood(a, b, model);
  if (value > 1e-6) value *= horizontal(b, around).likelihood;
  return {value, gap, measured, "m"};
}

}  // namespace scanchor
