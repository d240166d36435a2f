#include "perception/rectangle_likelihood.hpp"

#include <algorithm>
#include <cmath>

#include "core/math.hpp"

namespace scanchor {
namespace {

constexpr double wrong_share = 0.01;  // share of samples that belong to the other side of the edge
constexpr double most = 3.0;          // one point alone proves little
constexpr double other_density =
    1.0 / 4.5;                      // density of other faces' points: evenly from -1 to 3.5 sigma
constexpr double lost_share = 0.6;  // of what lies in the plane beyond its points is its own

/// Density of the height of a point of this surface [1/sigma].
double own(double height) { return std::exp(-0.5 * height * height) / std::sqrt(2.0 * pi); }

/// Points of a row are claimed together, so that two of them tell what one does: half the
/// logarithm.
double of_a_row(double p) { return std::sqrt(std::clamp(p, wrong_share, most)); }

/// P of a point that lies `away` sigma to where the other face goes, claimed by this surface, did
/// it lie beyond the edge.
double strange(double away) {
  return away < -1.0 ? of_a_row(wrong_share) : of_a_row(other_density / std::max(own(away), 1e-9));
}

/// The same for a point outside: of this surface, but claimed by another.
double lost(double height) { return of_a_row(lost_share / other_density * own(height)); }

}  // namespace

SideLikelihood::SideLikelihood(const RectangleSide& side, double sigma,
                               const RectangleEvidence& evidence, const Eigen::Vector2d& middle,
                               double direction)
    : sigma_(sigma) {
  const Eigen::Vector2d normal = unit_vector(direction + side.turn);
  const Eigen::Vector2d along(-normal.y(), normal.x());
  const double band = 3.0 * side.gap;
  const double extent = side.high - side.low;
  const double margin = std::min(0.25 * extent, std::max(side.gap, 0.02 * extent));
  const double centre = along.dot(middle);
  const auto take = [&](const std::vector<Eigen::Vector2d>& from,
                        const std::vector<double>& heights, double inwards, Samples& to) {
    for (std::size_t i = 0; i < from.size(); ++i) {
      const Eigen::Vector2d& p = from[i];
      const double t = p.dot(along);
      if (t < side.low + margin || t > side.high - margin) continue;
      const Eigen::Vector2d q = p - middle;
      const double d = q.dot(normal);
      if (d < side.position - inwards || d > side.position + band) continue;
      to.across.push_back(d);
      to.along.push_back(t - centre);
      to.value.push_back(heights.empty() ? 0.0 : heights[i]);
    }
  };
  take(evidence.inside, evidence.inside_height, band, inside_);
  take(evidence.outside, evidence.outside_height, 1.25 * side.gap, outside_);
  // A face that begins at the side is seen if it turns away and the sensor stands beyond the side,
  // or if it comes forward: then what is beyond the side is nearer.
  const auto nearer = std::count_if(outside_.value.begin(), outside_.value.end(),
                                    [](double height) { return height > 0.0; });
  const bool before = 2 * nearer > static_cast<std::ptrdiff_t>(outside_.value.size());
  const bool folds = evidence.foot.has_value() && !evidence.inside_height.empty() &&
                     (before || (*evidence.foot - middle).dot(normal) > side.position);
  // Such points make one row of rays, or little more.
  const double row = side.position - 1.25 * side.gap;
  if (evidence.inside_height.empty()) {
    for (auto* samples : {&inside_, &outside_})
      std::fill(samples->value.begin(), samples->value.end(), std::log(wrong_share));
    return;
  }
  for (std::size_t i = 0; i < inside_.value.size(); ++i) {
    double& value = inside_.value[i];
    value = std::log(folds && inside_.across[i] > row ? strange(before ? value : -value)
                                                      : of_a_row(wrong_share));
  }
  for (double& value : outside_.value) value = std::log(lost(value));
}

void SideLikelihood::narrow(const Samples& all, double turn, double most_turn, double low,
                            double high, Samples& near, Bin& before, Bin& after) {
  for (auto* values : {&near.across, &near.along, &near.value}) values->clear();
  before = after = {};
  const double c = std::cos(turn);
  const double s = std::sin(turn);
  for (std::size_t i = 0; i < all.value.size(); ++i) {
    const double x = c * all.across[i] + s * all.along[i];
    // A turn moves a sample by no more than its distance from the middle.
    const double moved = most_turn * (std::abs(all.across[i]) + std::abs(all.along[i]));
    if (x + moved < low || x - moved > high) {
      Bin& bin = x < low ? before : after;
      bin.count += 1.0;
      bin.value += all.value[i];
      continue;
    }
    near.across.push_back(all.across[i]);
    near.along.push_back(all.along[i]);
    near.value.push_back(all.value[i]);
  }
}

void SideLikelihood::look_at(double start, double step, double turn, double most_turn) {
  start_ = start;
  step_ = step;
  Bin none;
  const double margin = 0.01 * step, end = start + side_bins * step;
  narrow(inside_, turn, most_turn, start - margin, end + margin, near_inside_, none, beyond_);
  narrow(outside_, turn, most_turn, start - margin, end + margin, near_outside_, before_, none);
  // ln P(found inside | the edge lies z bins further out), for z = -window .. window.
  window_ = std::clamp(static_cast<int>(std::ceil(4.0 * sigma_ / step)), 0, side_bins);
  for (int z = -window_; z <= window_; ++z) {
    const double p =
        sigma_ > 0.0 ? normal_cdf(z * step / sigma_) : (z == 0 ? 0.5 : (z > 0 ? 1.0 : 0.0));
    soft_[static_cast<std::size_t>(z + window_)] =
        std::log(wrong_share + (1.0 - 2.0 * wrong_share) * p);
  }
}

SideLikelihood::Bins SideLikelihood::sort(const Samples& samples, double c, double s) const {
  const double per_step = 1.0 / step_;
  Bins bins{};
  constexpr std::size_t at_once = 64;
  std::array<int, at_once> bin{};
  const std::size_t count = samples.value.size();
  for (std::size_t first = 0; first < count; first += at_once) {
    const std::size_t n = std::min(at_once, count - first);
    const double* across = samples.across.data() + first;
    const double* along = samples.along.data() + first;
    for (std::size_t i = 0; i < n; ++i) {
      const double x = (c * across[i] + s * along[i] - start_) * per_step;
      bin[i] = static_cast<int>(std::min(std::max(x, -1.0), double(side_bins)) + 1.0);
    }
    for (std::size_t i = 0; i < n; ++i) {
      Bin& b = bins[static_cast<std::size_t>(bin[i])];
      b.count += 1.0;
      b.value += samples.value[first + i];
    }
  }
  return bins;
}

double SideLikelihood::operator()(double turn, SideHistogram& likelihood) const {
  const int window = window_;
  const double c = std::cos(turn);
  const double s = std::sin(turn);
  // ln P of the samples inside, did the edge lie further in, also of those beyond the last bin; and
  // of the samples outside, did it lie further out, also of those before the first.
  const Bins in = sort(near_inside_, c, s);
  const Bins out = sort(near_outside_, c, s);
  // Sums up to a bin: counts[k + 1] holds those of bins 0 .. k.
  std::array<double, side_bins + 1> in_sum, out_sum, astray_sum, lost_sum;
  in_sum[0] = astray_sum[0] = 0.0;
  out_sum[0] = before_.count + out[0].count;
  lost_sum[0] = before_.value + out[0].value;
  for (std::size_t k = 0; k < side_bins; ++k) {
    in_sum[k + 1] = in_sum[k] + in[k + 1].count;
    astray_sum[k + 1] = astray_sum[k] + in[k + 1].value;
    out_sum[k + 1] = out_sum[k] + out[k + 1].count;
    lost_sum[k + 1] = lost_sum[k] + out[k + 1].value;
  }
  const double astray_total = astray_sum[side_bins] + in[side_bins + 1].value + beyond_.value;
  const double out_total = out_sum[side_bins];
  static const double good = std::log(1.0 - wrong_share);
  // Counts beyond the window by running sums, inside the window one by one.
  double greatest = -1e300;
  for (int k = 0; k < side_bins; ++k) {
    const int first = std::max(0, k - window);
    const int last = std::min(side_bins - 1, k + window);
    const auto f = static_cast<std::size_t>(first);
    const auto l = static_cast<std::size_t>(last) + 1;
    double sum =
        (in_sum[f] + out_total - out_sum[l]) * good + astray_total - astray_sum[l] + lost_sum[f];
    for (int j = first; j <= last; ++j) {
      sum += in[static_cast<std::size_t>(j) + 1].count *
             soft_[static_cast<std::size_t>(k - j + window)];
      sum += out[static_cast<std::size_t>(j) + 1].count *
             soft_[static_cast<std::size_t>(j - k + window)];
    }
    likelihood[static_cast<std::size_t>(k)] = sum;
    greatest = std::max(greatest, sum);
  }
  constexpr double nothing = -40.0;  // e^-40 beside 1 is lost in rounding
  for (double& l : likelihood) l = l - greatest > nothing ? std::exp(l - greatest) : 0.0;
  return greatest;
}

}  // namespace scanchor
