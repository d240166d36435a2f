#include "perception/rectangle_fit.hpp"

#include <algorithm>
#include <cmath>

#include "core/math.hpp"
#include "perception/rectangle_sides.hpp"
#include "perception/shape_common.hpp"

namespace scanchor {
namespace {

constexpr int directions = 13;   // directions that are tried at once
constexpr int closer_looks = 3;  // each looks closer at where the one before found weight

/// A normal distribution over four sigma to either side of the middle.
SideHistogram normal_bins() {
  SideHistogram h;
  double total = 0.0;
  for (std::size_t b = 0; b < side_bins; ++b) {
    const double z = 8.0 * (static_cast<double>(b) + 0.5) / side_bins - 4.0;
    total += h[b] = std::exp(-0.5 * z * z);
  }
  for (double& x : h) x /= total;
  return h;
}

/// [m] of a side where nothing beyond it was seen, so that only the outline tells. Each sample's
/// phase leaves gap^2 / 12; as far as the raw outline wavers by as much the phases differ along the
/// side and average out.
double outline_sigma(const RectangleSide& side, double noise) {
  const double whole = side.gap * side.gap / 12.0;
  const double wavering = std::min(whole, side.waver * side.waver);
  const double runs = std::max(1.0, 0.5 * (side.high - side.low) / side.gap);
  return std::sqrt(std::max(0.1 * whole, whole - wavering) + (wavering + noise * noise) / runs);
}

/// Mean and central 95 % of a distribution over bins of width `step` that begin at `start`.
Measured summarize(const std::vector<double>& weight, double start, double step) {
  double total = 0.0;
  double mean = 0.0;
  for (std::size_t i = 0; i < weight.size(); ++i) {
    total += weight[i];
    mean += weight[i] * (static_cast<double>(i) + 0.5);
  }
  const auto quantile = [&](double q) {
    double sum = 0.0;
    for (std::size_t i = 0; i < weight.size(); ++i) {
      if (sum + weight[i] >= q * total && weight[i] > 0.0) {
        return start + step * (static_cast<double>(i) + (q * total - sum) / weight[i]);
      }
      sum += weight[i];
    }
    return start + step * static_cast<double>(weight.size());
  };
  return {start + step * mean / total, quantile(0.025), quantile(0.975), false};
}

/// Adds an independent normal error; half-widths add in squares.
void widen(Measured& m, double variance) {
  const double half = 1.959963984540054 * std::sqrt(variance);
  m.low = m.value - std::hypot(m.value - m.low, half);
  m.high = m.value + std::hypot(m.high - m.value, half);
}

/// Of the samples just beyond a side, the share that lies so near the plane that the first row of
/// either surface may have been counted to the other.
double contact_share(const RectangleSide& side, const RectangleEvidence& evidence, double direction,
                     const Eigen::Vector2d& middle) {
  constexpr double near = 5.0;  // [sigma]
  const Eigen::Vector2d normal = unit_vector(direction + side.turn);
  const Eigen::Vector2d along(-normal.y(), normal.x());
  std::size_t beyond = 0;
  std::size_t in_reach = 0;
  for (std::size_t i = 0; i < evidence.outside_height.size(); ++i) {
    const Eigen::Vector2d& p = evidence.outside[i];
    if (std::abs((p - middle).dot(normal) - side.position) > 1.5 * side.gap ||
        p.dot(along) < side.low || p.dot(along) > side.high)
      continue;
    ++beyond;
    in_reach += std::abs(evidence.outside_height[i]) < near ? 1 : 0;
  }
  return beyond == 0 ? 0.0 : static_cast<double>(in_reach) / static_cast<double>(beyond);
}

double variance_of(const Measured& m) {
  const double sigma = (m.high - m.low) / (2.0 * 1.959963984540054);
  return sigma * sigma;
}

}  // namespace

RectangleFit fit_rectangle(const RectangleEvidence& evidence) {
  RectangleFit fit;
  if (evidence.edges.empty()) return fit;
  const double direction = main_direction(evidence.edges);
  std::array<RectangleSide, 4> sides;
  for (int k = 0; k < 4; ++k) {
    sides[static_cast<std::size_t>(k)].turn = 0.5 * pi * k;
    guess_side(evidence.edges, direction, sides[static_cast<std::size_t>(k)]);
  }
  // From the frame's origin to the middle of the first guess.
  const Eigen::Vector2d u = unit_vector(direction);
  const Eigen::Vector2d v(-u.y(), u.x());
  const Eigen::Vector2d middle = 0.5 * (sides[0].position - sides[2].position) * u +
                                 0.5 * (sides[1].position - sides[3].position) * v;
  for (RectangleSide& side : sides) side.position -= middle.dot(unit_vector(direction + side.turn));
  for (std::size_t k = 0; k < 4; ++k) {  // a side is as long as its neighbours are apart
    const Eigen::Vector2d normal = unit_vector(direction + sides[k].turn);
    const double centre = middle.dot(Eigen::Vector2d(-normal.y(), normal.x()));
    sides[k].low = centre - sides[(k + 3) % 4].position;
    sides[k].high = centre + sides[(k + 1) % 4].position;
    if (sides[k].gap <= 0.0) sides[k].gap = std::max(1e-6, 0.01 * (sides[k].high - sides[k].low));
  }

  std::vector<SideLikelihood> likelihoods;
  for (const RectangleSide& side : sides)
    likelihoods.emplace_back(side, evidence.sigma, evidence, middle, direction);
  std::array<bool, 4> known{};
  for (std::size_t k = 0; k < 4; ++k) known[k] = !sides[k].censored && likelihoods[k].informed();

  // Directions: as far as the ends of the longest known side may lie apart by its gap.
  double reach = radians(8.0);
  for (std::size_t k = 0; k < 4; ++k) {
    if (known[k])
      reach = std::min(reach, 2.0 * sides[k].gap / std::max(1e-9, sides[k].high - sides[k].low));
  }
  struct Trial {
    double turn, weight;
    std::array<SideHistogram, 4> side;
  };
  std::array<Trial, directions> trials;
  double first_turn = -reach;
  double last_turn = reach;
  std::array<double, 4> start{};
  std::array<double, 4> step{};
  for (std::size_t k = 0; k < 4; ++k) {
    const double half =
        known[k] ? 2.0 * sides[k].gap : 4.0 * outline_sigma(sides[k], evidence.sigma);
    start[k] = sides[k].position - half;
    step[k] = 2.0 * half / side_bins;
  }
  static const SideHistogram unknown = normal_bins();
  double total = 0.0;
  for (int round = 0; round < closer_looks; ++round) {
    for (std::size_t k = 0; k < 4; ++k)
      likelihoods[k].look_at(start[k], step[k], 0.5 * (first_turn + last_turn),
                             0.5 * (last_turn - first_turn));
    double greatest = -1e300;
    for (int t = 0; t < directions; ++t) {
      Trial& trial = trials[static_cast<std::size_t>(t)];
      trial.turn = first_turn + (last_turn - first_turn) * (t + 0.5) / directions;
      trial.weight = 0.0;
      for (std::size_t k = 0; k < 4; ++k) {
        SideHistogram& h = trial.side[k];
        if (!known[k]) {
          h = unknown;
          continue;
        }
        trial.weight += likelihoods[k](trial.turn, h);
        double sum = 0.0;
        for (const double x : h) sum += x;
        for (double& x : h) x /= sum;
        trial.weight += std::log(sum);
      }
      greatest = std::max(greatest, trial.weight);
    }
    total = 0.0;
    for (Trial& trial : trials) total += trial.weight = std::exp(trial.weight - greatest);
    if (round + 1 == closer_looks) break;
    // Closer: what holds all but a thousandth of the weight, and one step more to either side.
    constexpr double small = 1e-3;
    std::size_t first = 0;
    std::size_t last = directions - 1;
    while (trials[first].weight < small) ++first;
    while (trials[last].weight < small) --last;
    const double turn_step = (last_turn - first_turn) / directions;
    const double old_first = first_turn;
    first_turn = old_first + turn_step * (static_cast<double>(first) - 1.0);
    last_turn = old_first + turn_step * (static_cast<double>(last) + 2.0);
    for (std::size_t k = 0; k < 4; ++k) {
      if (!known[k]) continue;
      SideHistogram sum{};
      double most = 0.0;
      for (std::size_t b = 0; b < side_bins; ++b) {
        for (const Trial& trial : trials) sum[b] += trial.weight * trial.side[k][b];
        most = std::max(most, sum[b]);
      }
      std::size_t from = 0;
      std::size_t to = side_bins - 1;
      while (sum[from] < small * most) ++from;
      while (sum[to] < small * most) --to;
      const double width = step[k] * (static_cast<double>(to - from) + 3.0);
      start[k] += step[k] * (static_cast<double>(from) - 1.0);
      step[k] = width / side_bins;
    }
  }
  double mean_turn = 0.0;
  std::array<double, 4> mean_position{};
  for (const Trial& trial : trials) {
    mean_turn += trial.weight * trial.turn;
    for (std::size_t k = 0; k < 4; ++k) {
      for (std::size_t b = 0; b < side_bins; ++b)
        mean_position[k] += trial.weight * trial.side[k][b] * (static_cast<double>(b) + 0.5);
    }
  }
  mean_turn /= total;
  for (std::size_t k = 0; k < 4; ++k)
    mean_position[k] = start[k] + step[k] * mean_position[k] / total;

  // Width along each axis: the sum of two opposite positions.
  std::array<Measured, 2> size;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double step_a = step[axis];
    const double step_b = step[axis + 2];
    const double fine = std::min(step_a, step_b);
    std::vector<double> sum(static_cast<std::size_t>(side_bins * (step_a + step_b) / fine) + 2,
                            0.0);
    // Of the two positions together, over all directions.
    std::array<SideHistogram, side_bins> both;
    std::array<bool, side_bins> any{};
    for (const Trial& trial : trials) {
      if (trial.weight < 1e-4) continue;
      for (std::size_t i = 0; i < side_bins; ++i) {
        const double p = trial.weight * trial.side[axis][i];
        if (p < 1e-7) continue;
        if (!any[i]) both[i].fill(0.0);
        any[i] = true;
        for (std::size_t j = 0; j < side_bins; ++j) both[i][j] += p * trial.side[axis + 2][j];
      }
    }
    SideHistogram place;  // of the other position
    for (std::size_t j = 0; j < side_bins; ++j)
      place[j] = (static_cast<double>(j) + 0.5) * step_b / fine;
    for (std::size_t i = 0; i < side_bins; ++i) {
      if (!any[i]) continue;
      const double a = (static_cast<double>(i) + 0.5) * step_a / fine;
      for (std::size_t j = 0; j < side_bins; ++j)
        sum[static_cast<std::size_t>(a + place[j])] += both[i][j];
    }
    size[axis] = summarize(sum, start[axis] + start[axis + 2], fine);
    size[axis].value = mean_position[axis] + mean_position[axis + 2];
    if (evidence.plane_variance) {
      const Eigen::Vector2d outwards = unit_vector(direction + mean_turn + sides[axis].turn);
      const double variance =
          evidence.plane_variance(middle - mean_position[axis + 2] * outwards,
                                  middle + mean_position[axis] * outwards, outwards);
      widen(size[axis], variance);
    }
    const auto wrong_row = [&](std::size_t k) {
      constexpr double wrong_rows = 0.1;  // of sides that touch another surface: one in ten
      return wrong_rows * contact_share(sides[k], evidence, direction, middle) * sides[k].gap *
             sides[k].gap;
    };
    widen(size[axis], wrong_row(axis) + wrong_row(axis + 2));
    size[axis].low -= sides[axis].loose + sides[axis + 2].loose;
    // Opposite sides of a sliver may cross within their error: no size is below nothing, and a
    // single row of samples may be as broad as the gaps to both its sides.
    if (size[axis].value < fine) {
      size[axis].value = fine;
      size[axis].high = std::max(size[axis].high, sides[axis].gap + sides[axis + 2].gap);
    }
    size[axis].low = std::clamp(size[axis].low, 0.0, size[axis].value);
    size[axis].high = std::max(size[axis].high, size[axis].value);
    size[axis].at_least = sides[axis].censored || sides[axis + 2].censored;
  }

  const double angle = direction + mean_turn;
  const Eigen::Vector2d low(-mean_position[2], -mean_position[3]);
  const Eigen::Vector2d high(mean_position[0], mean_position[1]);
  fit.rectangle = rectangle_from_sides(angle, low, high);
  fit.rectangle.center += middle;
  const bool swapped = size[1].value > size[0].value;
  fit.rectangle.length = swapped ? size[1] : size[0];
  fit.rectangle.width = swapped ? size[0] : size[1];
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t from = swapped ? (k + 1) % 4 : k;  // the frame turned by a right angle
    fit.support[k] = sides[from].support;
    fit.censored[k] = sides[from].censored;
  }
  for (const RectangleSide& side : sides) fit.loose_area += side.loose_area;
  const double area = size[0].value * size[1].value;
  const double sigma = std::sqrt(size[1].value * size[1].value * variance_of(size[0]) +
                                 size[0].value * size[0].value * variance_of(size[1]));
  fit.area = {area, std::max(0.0, area - 1.959963984540054 * sigma),
              area + 1.959963984540054 * sigma, size[0].at_least || size[1].at_least};
  return fit;
}

}  // namespace scanchor
