#pragma once
// How loud each clause and each class may be: multinomial logistic regression over the candidates
// of training scenes.

#include <cstdint>
#include <vector>

namespace scanchor {

/// One item with the classes it may be taken for.
struct WeighedExample {
  struct Term {
    std::int32_t parameter;  ///< which weight
    double evidence;         ///< log likelihood ratio that it multiplies
  };
  struct Candidate {
    std::int32_t class_index;
    std::vector<Term> terms;
  };
  std::vector<Candidate> candidates;
  std::int32_t truth = -1;  ///< class index; one that is no candidate, or -1: none of them
};

/// ln p(class k | example) = offset_k + sum of weight x evidence - ln(sum over candidates and
/// none).
struct FittedWeights {
  std::vector<double> offset;  ///< one a class; none of them has 0
  std::vector<double> weight;  ///< one a parameter, never negative
};

/// Probabilities of the example's candidates in their order, and of none of them as the last.
std::vector<double> shares_of(const WeighedExample& example, const FittedWeights& weights);

/// Maximum of the likelihood of the truths with a normal prior of mean `start` and precision
/// `offset_strength` and `weight_strength` [examples], weights kept at or above 0. The problem is
/// convex; solved by projected Newton steps (D. P. Bertsekas, SIAM J. Control 20, 1982) until a
/// step changes nothing beyond 1e-6. Deterministic.
FittedWeights fit_weights(const std::vector<WeighedExample>& examples, const FittedWeights& start,
                          double offset_strength, double weight_strength);

}  // namespace scanchor
