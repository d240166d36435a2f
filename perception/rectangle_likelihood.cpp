#include "perception/rectangle_likelihood.hpp"

#include <algorithm>
#include <cmath>

#include "core/math.hpp"

namespace scanchor {
namespace {

constexpr double wrong = 0.01;       // share of samples that belong to the other side of the edge
constexpr double most = 3.0;         // one point alone proves little
constexpr double other = 1.0 / 4.5;  // density of other faces' points: evenly from -1 to 3.5 sigma
constexpr double lost_share = 0.6;   // of what lies in the plane beyond its points is its own

/// Density of the height of a point of this surface [1/sigma].
double own(double height) { return std::exp(-0.5 * height * height) / std::sqrt(2.0 * pi); }

/// Points of a row are claimed together, so that two of them tell what one does: half the
/// logarithm.
double of_a_row(double p) { return std::sqrt(std::clamp(p, wrong, most)); }

/// P of a point that lies `away` sigma to where the other face goes, claimed by this surface, did
/// it lie beyond the edge.
double strange(double away) {
  return away < -1.0 ? of_a_row(wrong) : of_a_row(other / std::max(own(away), 1e-9));
}

/// The same for a point outside: of this surface, but claimed by another.
double lost(double height) { return of_a_row(lost_share / other * own(height)); }

}  // namespace

SideLikelihood::SideLikelihood(const Side& side, double sigma, const RectangleEvidence& evidence,
                               const Eigen::Vector2d& middle, double direction)
    : sigma_(sigma) {
  const Eigen::Vector2d normal = unit_vector(direction + side.turn);
  const Eigen::Vector2d along(-normal.y(), normal.x());
  const double band = 3.0 * side.gap;
  const double extent = side.high - side.low;
  const double margin = std::min(0.25 * extent, std::max(side.gap, 0.02 * extent));
  const double centre = along.dot(middle);
  const auto take = [&](const std::vector<Eigen::Vector2d>& from,
                        const std::vector<double>& heights, double inwards,
                        std::vector<Sample>& to) {
    for (std::size_t i = 0; i < from.size(); ++i) {
      const Eigen::Vector2d& p = from[i];
      const double t = p.dot(along);
      if (t < side.low + margin || t > side.high - margin) continue;
      const Eigen::Vector2d q = p - middle;
      const double d = q.dot(normal);
      if (d < side.position - inwards || d > side.position + band) continue;
      to.push_back({d, t - centre, heights.empty() ? 0.0 : heights[i]});
    }
  };
  take(evidence.inside, evidence.inside_height, band, inside_);
  take(evidence.outside, evidence.outside_height, 1.25 * side.gap, outside_);
  // A face that begins at the side is seen if it turns away and the sensor stands beyond the side,
  // or if it comes forward: then what is beyond the side is nearer.
  const auto nearer = std::count_if(outside_.begin(), outside_.end(),
                                    [](const Sample& s) { return s.value > 0.0; });
  const bool before = 2 * nearer > static_cast<std::ptrdiff_t>(outside_.size());
  const bool folds = evidence.foot.has_value() && !evidence.inside_height.empty() &&
                     (before || (*evidence.foot - middle).dot(normal) > side.position);
  // Such points make one row of rays, or little more.
  const double row = side.position - 1.25 * side.gap;
  if (evidence.inside_height.empty()) {
    for (auto* samples : {&inside_, &outside_}) {
      for (Sample& s : *samples) s.value = std::log(wrong);
    }
    return;
  }
  for (Sample& s : inside_) {
    s.value =
        std::log(folds && s.across > row ? strange(before ? s.value : -s.value) : of_a_row(wrong));
  }
  for (Sample& s : outside_) s.value = std::log(lost(s.value));
}

void SideLikelihood::set_step(double step) {
  step_ = step;
  // ln P(found inside | the edge lies z bins further out), for z = -window .. window.
  window_ = std::clamp(static_cast<int>(std::ceil(4.0 * sigma_ / step)), 0, side_bins);
  for (int z = -window_; z <= window_; ++z) {
    const double p =
        sigma_ > 0.0 ? normal_cdf(z * step / sigma_) : (z == 0 ? 0.5 : (z > 0 ? 1.0 : 0.0));
    soft_[static_cast<std::size_t>(z + window_)] = std::log(wrong + (1.0 - 2.0 * wrong) * p);
  }
}

double SideLikelihood::operator()(double turn, double start, SideHistogram& likelihood) const {
  const double per_step = 1.0 / step_;
  const int window = window_;
  SideHistogram in{};
  SideHistogram out{};
  SideHistogram astray{};     // ln P of the samples inside, did the edge lie further in
  double astray_total = 0.0;  // also of those beyond the last bin
  double out_near = 0.0;      // before the first bin
  SideHistogram lost{};       // ln P of the samples outside, did the edge lie further out
  double lost_near = 0.0;
  const double c = std::cos(turn);
  const double s = std::sin(turn);
  for (const auto& p : inside_) {
    const double x = (c * p.across + s * p.along - start) * per_step;
    if (x < 0.0) continue;
    astray_total += p.value;
    if (x >= side_bins) continue;
    in[static_cast<std::size_t>(x)] += 1.0;
    astray[static_cast<std::size_t>(x)] += p.value;
  }
  for (const auto& p : outside_) {
    const double x = (c * p.across + s * p.along - start) * per_step;
    if (x < 0.0) {
      out_near += 1.0;
      lost_near += p.value;
    } else if (x < side_bins) {
      out[static_cast<std::size_t>(x)] += 1.0;
      lost[static_cast<std::size_t>(x)] += p.value;
    }
  }
  static const double good = std::log(1.0 - wrong);
  double out_total = out_near;
  for (int k = 0; k < side_bins; ++k) out_total += out[static_cast<std::size_t>(k)];
  // Counts beyond the window by running sums, inside the window one by one.
  double greatest = -1e300;
  SideHistogram prefix_in{};
  SideHistogram prefix_out{};
  SideHistogram prefix_astray{};
  SideHistogram prefix_lost{};
  double a = 0.0, b = out_near, astray_sum = 0.0, lost_sum = lost_near;
  for (std::size_t k = 0; k < side_bins; ++k) {
    prefix_in[k] = a += in[k];
    prefix_out[k] = b += out[k];
    prefix_astray[k] = astray_sum += astray[k];
    prefix_lost[k] = lost_sum += lost[k];
  }
  for (int k = 0; k < side_bins; ++k) {
    const int first = std::max(0, k - window);
    const int last = std::min(side_bins - 1, k + window);
    const auto f = static_cast<std::size_t>(first);
    const auto l = static_cast<std::size_t>(last);
    const double in_below = first > 0 ? prefix_in[f - 1] : 0.0;
    const double in_above = astray_total - prefix_astray[l];
    const double out_below = first > 0 ? prefix_lost[f - 1] : lost_near;
    const double out_above = out_total - prefix_out[l];
    double sum = (in_below + out_above) * good + in_above + out_below;
    for (int j = first; j <= last; ++j) {
      const double i = in[static_cast<std::size_t>(j)];
      const double o = out[static_cast<std::size_t>(j)];
      if (i > 0.0) sum += i * soft_[static_cast<std::size_t>(k - j + window)];
      if (o > 0.0) sum += o * soft_[static_cast<std::size_t>(j - k + window)];
    }
    likelihood[static_cast<std::size_t>(k)] = sum;
    greatest = std::max(greatest, sum);
  }
  constexpr double nothing = -40.0;  // e^-40 beside 1 is lost in rounding
  for (double& l : likelihood) l = l - greatest > nothing ? std::exp(l - greatest) : 0.0;
  return greatest;
}

}  // namespace scanchor
