#include "reasoning/size_relations.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/math.hpp"
#include "reasoning/angle_relations.hpp"
#include "reasoning/likelihood.hpp"
#include "reasoning/relation_model.hpp"

namespace scanchor {

namespace {

constexpr double same_length = std::log(1.15), same_area = std::log(1.25);
constexpr double aligned_within = 0.15;  // of the smaller of the longer sides

/// [m] Deviation of a side's length. What the outline's area is off by, of the
/// area, says more of the sides than their own two ends do.
double side_sigma(const Item& item, const Quantity& side, const RelationModel& model) {
  const double area = item.area.value > 0.0 ? item.area.sigma / item.area.value : 1.0;
  return std::hypot(side.sigma, model.side_by_area * side.value * area);
}

/// How likely one of two opposite sides goes on in a shadow (goes_on).
double open_share(const Item& item, std::size_t first, const RelationModel& model) {
  return 1.0 - (1.0 - model.shadow_share * sqr(item.open[first])) *
                   (1.0 - model.shadow_share * sqr(item.open[first + 1]));
}

/// The logarithm of the ratio of two lengths as measured, with the deviation of
/// its middle, and how likely the first or the second one goes on unseen: by 1
/// / rate on the average.
struct LogRatio {
  double value, sigma, first_open, second_open, rate;

  /// Density of what was measured where the true ratio is 1.
  [[nodiscard]] double density_of_equal() const {
    return (1.0 - open()) * normal_density(value, sigma) + first_open * shifted_density(-value) +
           second_open * shifted_density(value);
  }
  /// That the true one is within a limit.
  [[nodiscard]] double within(double limit) const {
    return (1.0 - open()) * between_likelihood(value, -limit, limit, sigma) +
           first_open * (shifted_below(limit - value) - shifted_below(-limit - value)) +
           second_open * (shifted_below(limit + value) - shifted_below(-limit + value));
  }

 private:
  [[nodiscard]] double open() const { return first_open + second_open; }
  // Of a normal deviation and an exponential growth together.
  [[nodiscard]] double tail(double x) const {
    return std::exp(std::min(0.5 * sqr(rate * sigma) - rate * x, 300.0)) *
           normal_cdf(x / sigma - rate * sigma);
  }
  [[nodiscard]] double shifted_density(double x) const { return rate * tail(x); }
  [[nodiscard]] double shifted_below(double x) const {
    return std::max(0.0, normal_cdf(x / sigma) - tail(x));
  }
};

LogRatio log_ratio(double value, double sigma, double first_open, double second_open, double rate) {
  const double both = std::max(1.0, first_open + second_open);
  return {value, sigma, first_open / both, second_open / both, rate};
}

/// Variance [m2] of where the middle of an item is along u (unit): half of what
/// its sides' lengths are off, and its plane.
double middle_variance(const Item& item, const Eigen::Vector3d& u, const RelationModel& model) {
  return sqr(u.dot(item.along) * 0.5 * side_sigma(item, item.extension, model)) +
         sqr(u.dot(item.across) * 0.5 * side_sigma(item, item.width, model)) +
         sqr(u.dot(item.normal) * item.offset_sigma);
}

}  // namespace

Evidence same_size_relation(const Item& a, const Item& b, const RelationModel& model) {
  if (a.extension.value <= 0.0 || b.extension.value <= 0.0 || a.area.value <= 0.0 ||
      b.area.value <= 0.0)
    return {0.0, 0.0, 0.0, "1"};
  const double length = std::log(a.extension.value / b.extension.value);
  const double area = std::log(a.area.value / b.area.value);
  // Of sides rather than of areas: what a length is off by, the area is off by
  // as well.
  const double width = area - length;
  const auto of_length = [&](const Item& item) {
    return side_sigma(item, item.extension, model) / item.extension.value;
  };
  const auto of_width = [&](const Item& item) { return item.area.sigma / item.area.value; };
  const double length_sigma = std::hypot(of_length(a), of_length(b), model.size_softness);
  const double width_sigma = std::hypot(of_width(a), of_width(b), model.size_softness);
  const std::array<double, 4> open = {open_share(a, 0, model), open_share(b, 0, model),
                                      open_share(a, 2, model), open_share(b, 2, model)};
  double holds = 0.0, all = 0.0;
  // One face in a few is measured with what it ran together with, or in part:
  // its deviations are several times as large.
  for (const double factor : {1.0, model.misread_factor}) {
    const double share = factor > 1.0 ? model.misread_share : 1.0 - model.misread_share;
    const double rate = model.shadow_rate;
    const LogRatio lengths = log_ratio(length, factor * length_sigma, open[0], open[1], rate);
    const LogRatio widths = log_ratio(width, factor * width_sigma, open[2], open[3], rate);
    const LogRatio areas = log_ratio(area, factor * std::hypot(length_sigma, width_sigma),
                                     std::max(open[0], open[2]), std::max(open[1], open[3]), rate);
    const double twins =
        share * model.twins * lengths.density_of_equal() * widths.density_of_equal();
    holds += twins + share * lengths.within(same_length) * areas.within(same_area);
    all += twins + share;
  }
  const double ratio = a.extension.value / b.extension.value;
  const double sigma = ratio * std::hypot(a.extension.sigma / a.extension.value,
                                          b.extension.sigma / b.extension.value);
  return {std::clamp(holds / all, 0.0, 1.0), ratio, sigma, "1"};
}

Evidence aligned_relation(const Item& a, const Item& b, const RelationModel& model) {
  const double size = std::max(std::min(a.extension.value, b.extension.value), 1e-3);
  const Eigen::Vector3d apart = a.center - b.center;
  const double distance = apart.head<2>().norm() / size;
  const Eigen::Vector3d way = distance * size > 1e-9
                                  ? Eigen::Vector3d(apart.x(), apart.y(), 0.0).normalized()
                                  : Eigen::Vector3d::UnitX();
  const Eigen::Vector3d side(-way.y(), way.x(), 0.0);
  const auto sigma_of = [&](const Eigen::Vector3d& u) {
    return std::sqrt(middle_variance(a, u, model) + middle_variance(b, u, model));
  };
  const bool elongated = a.half_length > 1.3 * a.half_width && b.half_length > 1.3 * b.half_width;
  const double turn = elongated ? angle_between(a.along, b.along) : 0.0;
  const auto turn_of = [](const Item& item) {
    return item.edge_sigma / std::max(item.extension.value, 0.05);
  };
  const double turn_sigma = std::hypot(turn_of(a), turn_of(b), radians(model.turn_softness));
  double holds = 0.0, all = 0.0;
  const auto add = [&](double share, double factor, double s_way, double s_side) {
    // Densities of the measured turn: of parallel sides, and of sides in any
    // direction [1/rad].
    double parallel = 1.0, straight = 1.0, turned = 0.0, hardly = 0.0;
    if (elongated) {
      const double s = factor * turn_sigma;
      parallel = 2.0 * normal_density(turn, s) + 1e-6;
      straight = model.axes_agree * parallel;
      turned = (1.0 - model.axes_agree) * 2.0 / pi;
      hardly = turned * between_likelihood(turn, -angle_tolerance, angle_tolerance, s);
    }
    const double line = model.in_one_line * normal_density(distance, s_way) *
                        normal_density(0.0, s_side) * parallel;
    const double within =
        cone_likelihood(distance, aligned_within, std::sqrt(0.5) * std::hypot(s_way, s_side));
    holds += share * (line + within * (straight + hardly));
    all += share * (line + straight + turned);
  };
  const auto soft = [&](double sigma) { return std::hypot(sigma / size, model.middle_softness); };
  const double s_way = soft(sigma_of(way)), s_side = soft(sigma_of(side));
  // The middle of what goes on in a shadow is not where it seems: half of what
  // is missing off, along the side that does.
  struct OpenSide {
    double share;
    Eigen::Vector3d off;  // [m]
  };
  std::array<OpenSide, 4> open;
  double whole = 1.0, sum = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    const Item& item = k < 2 ? a : b;
    const bool longer = k % 2 == 0;
    open[k] = {open_share(item, longer ? 0 : 2, model),
               (longer ? item.half_length * item.along : item.half_width * item.across) /
                   model.shadow_rate};
    whole *= 1.0 - open[k].share;
    sum += open[k].share;
  }
  const double wide = model.misread_factor;
  add(whole * (1.0 - model.misread_share), 1.0, s_way, s_side);
  add(whole * model.misread_share, wide, wide * s_way, wide * s_side);
  for (const auto& [share, off] : open) {
    if (share > 0.0)
      add((1.0 - whole) * share / sum, 1.0, std::hypot(off.dot(way) / size, s_way),
          std::hypot(off.dot(side) / size, s_side));
  }
  double value = all > 0.0 ? std::clamp(holds / all, 0.0, 1.0) : 0.0;
  // Stacked (S22): two things in one place are not one above the other.
  value *= lower_likelihood(std::abs(a.z - b.z), 0.05,
                            std::hypot(sigma_of(Eigen::Vector3d::UnitZ()), 0.003));
  return {value, distance, sigma_of(way) / size, "1"};
}

}  // namespace scanchor
