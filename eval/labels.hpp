#pragma once
// Whether a stated probability means what it says. Expected calibration error: Naeini, Cooper,
// Hauskrecht, AAAI 2015, and Guo et al., ICML 2017, equation 3; Brier, Monthly Weather Review 78,
// 1950 (the sum over classes); risk against coverage: El-Yaniv and Wiener, JMLR 11, 2010.

#include <cstdint>
#include <utility>
#include <vector>

#include "eval/evaluate.hpp"
#include "eval/fixed_sum.hpp"
#include "eval/objects.hpp"

namespace scanchor {

/// One label with its probability, and what it lies on.
struct LabelledThing {
  std::int32_t truth =
      unlabelled;  ///< class of the truth; unlabelled: something that the method has no word for
  std::int32_t label = unlabelled;  ///< class said; unlabelled: "unknown"
  bool ambiguous = false;    ///< two classes were too near to choose; label holds the likelier
  double probability = 1.0;  ///< of `label`
  std::vector<std::pair<std::int32_t, double>>
      distribution;  ///< class (unlabelled: unknown) and probability; empty: only `label`
};

struct ReliabilityBin {
  std::int64_t count = 0;
  std::int64_t right = 0;
  FixedSum probability;
  friend bool operator==(const ReliabilityBin&, const ReliabilityBin&) = default;
};

/// Counts a statement in its bin; bins of equal width, (low, high], the first one with 0.
void add_to_bins(std::vector<ReliabilityBin>& bins, double probability, bool right);

struct LabelScore {
  static constexpr std::size_t risk_bins = 100;
  std::int64_t things = 0;  ///< labels that count, unknown and ambiguous ones too
  std::int64_t unknown = 0;
  std::int64_t ambiguous = 0;
  std::int64_t unknown_right = 0;  ///< "unknown" of something that has no word
  std::int64_t brier_things = 0;   ///< labels with a distribution, or all where none has
  FixedSum brier;
  std::vector<ReliabilityBin>
      reliability;                   ///< of the labels that name a class; equal width, (low, high]
  std::vector<ReliabilityBin> risk;  ///< the same in 100 bins, for risk against coverage
  void add(const LabelScore& other);
  friend bool operator==(const LabelScore&, const LabelScore&) = default;
};

LabelScore score_labels(const std::vector<LabelledThing>& things, const Protocol& protocol);

/// Sum over bins of (share of the labels) x |share right - mean probability|, in [0, 1].
double expected_calibration_error(const std::vector<ReliabilityBin>& bins);
double expected_calibration_error(const LabelScore& score);
/// Mean of sum over classes (p - [class is the truth])^2, in [0, 2].
double brier_score(const LabelScore& score);
double unknown_rate(const LabelScore& score);
double ambiguous_rate(const LabelScore& score);

/// Labels taken by falling probability: share taken, share of these that are wrong. Unknown things
/// are never taken.
struct RiskPoint {
  double coverage, risk, probability;  ///< lowest probability taken
};
std::vector<RiskPoint> risk_coverage(const LabelScore& score);
/// Mean risk over the coverage reached: 0 best.
double area_under_risk(const LabelScore& score);

/// The labels of a scan: one a claim of `summary`, truth = class of the thing that most of it lies
/// on. With a labelling also the entities that were left unknown or ambiguous, laid on the truth by
/// their points.
std::vector<LabelledThing> labelled_things(const ScanTruth& truth, const Surfaces& surfaces,
                                           const Labelling& labelling, const Protocol& protocol,
                                           const std::vector<ClassId>& described);
std::vector<LabelledThing> labelled_things(const ObjectSummary& summary);

}  // namespace scanchor
