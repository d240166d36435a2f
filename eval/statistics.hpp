#pragma once
// Paired comparison of two runs over the same scenes. Everything is recomputed from pooled counts:
// the metric of a bootstrap sample is the metric of the pooled counts of its scenes, not a mean of
// ratios.

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace scanchor {

/// Counts of each scene before and after, and the metric as a function of their sum. All rows
/// equally long.
struct PairedCounts {
  std::string name;
  std::function<double(std::span<const double> sums)> value;
  std::vector<std::vector<double>> before, after;  ///< [scene][count]
  [[nodiscard]] std::size_t scenes() const { return before.size(); }
};

double pooled_value(const PairedCounts& counts, const std::vector<std::vector<double>>& rows);
/// Metric after - metric before, both pooled.
double pooled_difference(const PairedCounts& counts);
/// The same of scene i alone.
double scene_difference(const PairedCounts& counts, std::size_t scene);

/// Of counts; 0 of nothing.
inline double ratio_of(std::int64_t part, std::int64_t whole) {
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
}

struct Interval {
  double low = 0.0, high = 0.0;
};

/// Bias-corrected and accelerated bootstrap interval of the pooled difference over scenes: DiCiccio
/// and Efron, "Bootstrap confidence intervals", Statistical Science 11, 1996, section 2.
/// `confidence` in (0, 1), two-sided. One scene or no spread: a point. Deterministic for a seed and
/// any number of threads.
Interval bca_interval(const PairedCounts& counts, double confidence, int replicates,
                      std::uint64_t seed);
/// The same for the pooled value of one run (`after` of the counts), for curves.
Interval bca_interval_of_value(const PairedCounts& counts, double confidence, int replicates,
                               std::uint64_t seed);

/// One-sided sign-flip (paired permutation) test that the pooled difference is this low or lower by
/// chance: under the null hypothesis before and after of a scene may be exchanged. (1 + hits) / (1
/// + permutations), so never 0.
double sign_flip_p(const PairedCounts& counts, int permutations, std::uint64_t seed);

/// Pooled differences after each of the random exchanges; the same exchanges for every metric of
/// the same scenes.
std::vector<double> flipped_differences(const PairedCounts& counts, int permutations,
                                        std::uint64_t seed);

/// Holm's step-down over several metrics of the same scenes, with the dependence between the
/// metrics taken from the exchanges: Westfall and Young, "Resampling-based multiple testing", 1993,
/// algorithm 2.8 (minP). Holds the error rate of the family as Holm's does, without the price for
/// metrics that rise and fall together. Adjusted one-sided p-values in the order of the input;
/// `single`, if given: those before the adjustment, as sign_flip_p gives them.
std::vector<double> step_down_p(const std::vector<PairedCounts>& metrics, int permutations,
                                std::uint64_t seed, std::vector<double>* single = nullptr);

/// Holm's step-down adjusted p-values (Scandinavian Journal of Statistics 6, 1979), in the order of
/// the input.
std::vector<double> holm_adjust(std::span<const double> p);

/// Share of the error rate `alpha` (one-sided) that look `look` of the planned sample sizes may
/// spend: Lan and DeMets, Biometrika 70, 1983, with O'Brien and Fleming's shape 2 - 2 Phi(z /
/// sqrt(t)). The shares add up to alpha; a single look has all of it.
double look_alpha(std::span<const int> planned, std::size_t look, double alpha);

}  // namespace scanchor
