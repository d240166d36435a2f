#include "eval/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/math.hpp"
#include "core/parallel.hpp"
#include "core/random.hpp"

namespace scanchor {
namespace {

using Rows = std::vector<std::vector<double>>;

// The counts are sums of many terms in another order: what differs by rounding only is a tie, and
// ties count as hits.
constexpr double slack = 1e-12;

void add_to(std::vector<double>& sums, const std::vector<double>& row, double sign) {
  for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += sign * row[k];
}

std::vector<double> sum_of(const Rows& rows) {
  std::vector<double> sums(rows.empty() ? 0 : rows.front().size(), 0.0);
  for (const auto& row : rows) add_to(sums, row, 1.0);
  return sums;
}

// The statistic from pooled sums: of the difference, or of `after` alone.
double statistic(const PairedCounts& counts, const std::vector<double>& before,
                 const std::vector<double>& after, bool difference) {
  return counts.value(after) - (difference ? counts.value(before) : 0.0);
}

Interval bca(const PairedCounts& counts, double confidence, int replicates, std::uint64_t seed,
             bool difference) {
  const std::size_t n = counts.after.size();
  const auto all_before = sum_of(counts.before);
  const auto all_after = sum_of(counts.after);
  const double estimate = statistic(counts, all_before, all_after, difference);
  if (n < 2 || replicates < 2) return {estimate, estimate};
  std::vector<double> sample(static_cast<std::size_t>(replicates));
  const CounterRandom random(stream_seed(seed, "bootstrap"));
  parallel_blocks(sample.size(), 250, [&](std::size_t begin, std::size_t end) {
    std::vector<double> before(all_before.size()), after(all_after.size());
    for (std::size_t b = begin; b < end; ++b) {
      std::fill(before.begin(), before.end(), 0.0);
      std::fill(after.begin(), after.end(), 0.0);
      for (std::size_t i = 0; i < n; i += 4) {
        // Four draws from the words of one counter; 32 bits times n, shifted, is uniform to n /
        // 2^32.
        const auto words = random.words(b, static_cast<std::uint32_t>(i));
        for (std::size_t j = i; j < std::min(i + 4, n); ++j) {
          const auto drawn = static_cast<std::size_t>(std::uint64_t{words[j - i]} * n >> 32U);
          if (difference) add_to(before, counts.before[drawn], 1.0);
          add_to(after, counts.after[drawn], 1.0);
        }
      }
      sample[b] = statistic(counts, before, after, difference);
    }
  });
  std::sort(sample.begin(), sample.end());
  // Bias: where the estimate stands among the replicates, ties counted half.
  const auto below = static_cast<double>(std::lower_bound(sample.begin(), sample.end(), estimate) -
                                         sample.begin());
  const auto upto = static_cast<double>(std::upper_bound(sample.begin(), sample.end(), estimate) -
                                        sample.begin());
  const double count = static_cast<double>(replicates);
  const double share = std::clamp(0.5 * (below + upto) / count, 0.5 / count, 1.0 - 0.5 / count);
  const double z0 = normal_quantile(share);
  // Acceleration, by the jackknife.
  std::vector<double> jackknife(n);
  for (std::size_t i = 0; i < n; ++i) {
    auto before = all_before;
    auto after = all_after;
    if (difference) add_to(before, counts.before[i], -1.0);
    add_to(after, counts.after[i], -1.0);
    jackknife[i] = statistic(counts, before, after, difference);
  }
  const double mean =
      std::accumulate(jackknife.begin(), jackknife.end(), 0.0) / static_cast<double>(n);
  double square = 0, cube = 0;
  for (const double value : jackknife) {
    const double d = mean - value;
    square += d * d;
    cube += d * d * d;
  }
  const double a = square > 0 ? cube / (6.0 * std::pow(square, 1.5)) : 0.0;
  const auto bound = [&](double level) {
    const double z = normal_quantile(level);
    const double moved = normal_cdf(z0 + (z0 + z) / (1.0 - a * (z0 + z)));
    const double place = std::clamp(moved * (count + 1.0) - 1.0, 0.0, count - 1.0);
    const auto low = static_cast<std::size_t>(place);
    const std::size_t high = std::min(low + 1, sample.size() - 1);
    return sample[low] + (place - static_cast<double>(low)) * (sample[high] - sample[low]);
  };
  return {bound(0.5 * (1.0 - confidence)), bound(0.5 * (1.0 + confidence))};
}

}  // namespace

double pooled_value(const PairedCounts& counts, const Rows& rows) {
  return counts.value(sum_of(rows));
}

double pooled_difference(const PairedCounts& counts) {
  return pooled_value(counts, counts.after) - pooled_value(counts, counts.before);
}

double scene_difference(const PairedCounts& counts, std::size_t scene) {
  return counts.value(counts.after[scene]) - counts.value(counts.before[scene]);
}

Interval bca_interval(const PairedCounts& counts, double confidence, int replicates,
                      std::uint64_t seed) {
  return bca(counts, confidence, replicates, seed, true);
}

Interval bca_interval_of_value(const PairedCounts& counts, double confidence, int replicates,
                               std::uint64_t seed) {
  return bca(counts, confidence, replicates, seed, false);
}

std::vector<double> flipped_differences(const PairedCounts& counts, int permutations,
                                        std::uint64_t seed) {
  const std::size_t n = counts.scenes();
  const CounterRandom random(stream_seed(seed, "sign flip"));
  std::vector<double> differences(static_cast<std::size_t>(std::max(permutations, 0)));
  const auto all_before = sum_of(counts.before);
  const auto all_after = sum_of(counts.after);
  parallel_blocks(differences.size(), 250, [&](std::size_t begin, std::size_t end) {
    std::vector<double> before, after;
    for (std::size_t p = begin; p < end; ++p) {
      before = all_before;
      after = all_after;
      for (std::size_t i = 0; i < n; i += 32) {
        const std::uint32_t bits = random.words(p, static_cast<std::uint32_t>(i / 32))[0];
        for (std::size_t j = i; j < std::min(i + 32, n); ++j) {
          if (!(bits >> (j - i) & 1U)) continue;
          for (std::size_t k = 0; k < before.size(); ++k) {
            const double change = counts.after[j][k] - counts.before[j][k];
            before[k] += change;
            after[k] -= change;
          }
        }
      }
      differences[p] = statistic(counts, before, after, true);
    }
  });
  return differences;
}

double sign_flip_p(const PairedCounts& counts, int permutations, std::uint64_t seed) {
  const double observed = pooled_difference(counts);
  const auto differences = flipped_differences(counts, permutations, seed);
  const auto hits = std::count_if(differences.begin(), differences.end(),
                                  [&](double d) { return d <= observed + slack; });
  return static_cast<double>(hits + 1) / static_cast<double>(differences.size() + 1);
}

std::vector<double> step_down_p(const std::vector<PairedCounts>& metrics, int permutations,
                                std::uint64_t seed, std::vector<double>* single) {
  const std::size_t many = metrics.size();
  // For each metric the p-value that each exchange would have had, the observed one first.
  std::vector<std::vector<double>> p(many);
  for (std::size_t k = 0; k < many; ++k) {
    auto values = flipped_differences(metrics[k], permutations, seed);
    values.insert(values.begin(), pooled_difference(metrics[k]));
    auto sorted = values;
    std::sort(sorted.begin(), sorted.end());
    for (const double value : values) {
      const auto upto =
          std::upper_bound(sorted.begin(), sorted.end(), value + slack) - sorted.begin();
      p[k].push_back(static_cast<double>(upto) / static_cast<double>(sorted.size()));
    }
  }
  if (single) {
    single->clear();
    for (const auto& own : p) single->push_back(own[0]);
  }
  std::vector<std::size_t> order(many);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return p[a][0] < p[b][0]; });
  std::vector<double> adjusted(many);
  std::vector<double> least(static_cast<std::size_t>(std::max(permutations, 0)) + 1, 1.0);
  for (std::size_t rank = many; rank-- > 0;) {
    const auto& own = p[order[rank]];
    for (std::size_t b = 0; b < least.size(); ++b) least[b] = std::min(least[b], own[b]);
    const auto hits =
        std::count_if(least.begin(), least.end(), [&](double value) { return value <= own[0]; });
    adjusted[order[rank]] = static_cast<double>(hits) / static_cast<double>(least.size());
  }
  for (std::size_t rank = 1; rank < many; ++rank) {
    adjusted[order[rank]] = std::max(adjusted[order[rank]], adjusted[order[rank - 1]]);
  }
  return adjusted;
}

std::vector<double> holm_adjust(std::span<const double> p) {
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return p[a] < p[b]; });
  std::vector<double> adjusted(p.size());
  double running = 0;
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    running =
        std::max(running, std::min(1.0, static_cast<double>(p.size() - rank) * p[order[rank]]));
    adjusted[order[rank]] = running;
  }
  return adjusted;
}

double look_alpha(std::span<const int> planned, std::size_t look, double alpha) {
  const auto spent = [&](std::size_t i) {
    if (i + 1 >= planned.size()) return alpha;
    const double t = static_cast<double>(planned[i]) / static_cast<double>(planned.back());
    return 2.0 - 2.0 * normal_cdf(normal_quantile(1.0 - 0.5 * alpha) / std::sqrt(t));
  };
  return spent(look) - (look > 0 ? spent(look - 1) : 0.0);
}

}  // namespace scanchor
