#include "reasoning/fit_weights.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace scanchor {
namespace {

constexpr int most_steps = 60;
constexpr double settled = 1e-6;

// Offsets first, then weights, as one vector.
FittedWeights unpack(const Eigen::VectorXd& x, std::size_t classes) {
  const auto at = static_cast<Eigen::Index>(classes);
  return {std::vector<double>(x.data(), x.data() + at),
          std::vector<double>(x.data() + at, x.data() + x.size())};
}

class Problem {
 public:
  Problem(const std::vector<WeighedExample>& examples, const FittedWeights& start,
          double offset_strength, double weight_strength)
      : examples_(examples), classes_(start.offset.size()) {
    const auto count = static_cast<Eigen::Index>(classes_ + start.weight.size());
    prior_.resize(count);
    precision_.resize(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const auto k = static_cast<std::size_t>(i);
      prior_[i] = k < classes_ ? start.offset[k] : start.weight[k - classes_];
      precision_[i] = k < classes_ ? offset_strength : weight_strength;
    }
  }
  [[nodiscard]] const Eigen::VectorXd& prior() const { return prior_; }
  [[nodiscard]] bool is_weight(Eigen::Index i) const {
    return static_cast<std::size_t>(i) >= classes_;
  }

  [[nodiscard]] double loss(const Eigen::VectorXd& x) const {
    const FittedWeights weights = unpack(x, classes_);
    double sum = 0.5 * ((x - prior_).array().square() * precision_.array()).sum();
    for (const auto& example : examples_)
      sum -= std::log(std::max(shares_of(example, weights)[right(example)], 1e-300));
    return sum;
  }

  void derive(const Eigen::VectorXd& x, Eigen::VectorXd& gradient, Eigen::MatrixXd& hessian) const {
    const FittedWeights weights = unpack(x, classes_);
    gradient = (x - prior_).cwiseProduct(precision_);
    hessian.setZero(x.size(), x.size());
    hessian.diagonal() = precision_;
    std::vector<Entry> mean, own;
    for (const auto& example : examples_) {
      const std::vector<double> shares = shares_of(example, weights);
      const std::size_t truth = right(example);
      mean.clear();
      for (std::size_t k = 0; k < example.candidates.size(); ++k) {
        features(example.candidates[k], own);
        for (const auto& [i, value] : own) {
          gradient[i] += (shares[k] - (k == truth ? 1.0 : 0.0)) * value;
          mean.push_back({i, shares[k] * value});
        }
        outer(own, shares[k], hessian);
      }
      outer(mean, -1.0, hessian);
    }
  }

 private:
  struct Entry {
    Eigen::Index index;
    double value;
  };
  void features(const WeighedExample::Candidate& candidate, std::vector<Entry>& own) const {
    own.clear();
    own.push_back({candidate.class_index, 1.0});
    for (const auto& term : candidate.terms)
      own.push_back({static_cast<Eigen::Index>(classes_) + term.parameter, term.evidence});
  }
  static void outer(const std::vector<Entry>& v, double factor, Eigen::MatrixXd& sum) {
    for (const auto& a : v) {
      for (const auto& b : v) sum(a.index, b.index) += factor * a.value * b.value;
    }
  }
  static std::size_t right(const WeighedExample& example) {
    for (std::size_t k = 0; k < example.candidates.size(); ++k) {
      if (example.candidates[k].class_index == example.truth) return k;
    }
    return example.candidates.size();
  }

  const std::vector<WeighedExample>& examples_;
  std::size_t classes_;
  Eigen::VectorXd prior_, precision_;
};

// Newton's direction among the parameters that are not held at zero.
Eigen::VectorXd direction(const Problem& problem, const Eigen::VectorXd& x,
                          const Eigen::VectorXd& gradient, const Eigen::MatrixXd& hessian) {
  std::vector<Eigen::Index> free;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    if (!problem.is_weight(i) || x[i] > 0.0 || gradient[i] < 0.0) free.push_back(i);
  }
  const Eigen::MatrixXd part = hessian(free, free);
  const Eigen::VectorXd step = part.ldlt().solve(-gradient(free));
  Eigen::VectorXd whole = Eigen::VectorXd::Zero(x.size());
  for (std::size_t k = 0; k < free.size(); ++k) whole[free[k]] = step[static_cast<Eigen::Index>(k)];
  return whole;
}

}  // namespace

std::vector<double> shares_of(const WeighedExample& example, const FittedWeights& weights) {
  std::vector<double> shares;
  double top = 0.0;
  for (const auto& candidate : example.candidates) {
    double score = weights.offset[static_cast<std::size_t>(candidate.class_index)];
    for (const auto& term : candidate.terms)
      score += weights.weight[static_cast<std::size_t>(term.parameter)] * term.evidence;
    top = std::max(top, score);
    shares.push_back(score);
  }
  shares.push_back(0.0);
  double all = 0.0;
  for (double& share : shares) all += share = std::exp(share - top);
  for (double& share : shares) share /= all;
  return shares;
}

FittedWeights fit_weights(const std::vector<WeighedExample>& examples, const FittedWeights& start,
                          double offset_strength, double weight_strength) {
  const Problem problem(examples, start, offset_strength, weight_strength);
  Eigen::VectorXd x = problem.prior(), gradient;
  Eigen::MatrixXd hessian;
  double loss = problem.loss(x);
  for (int step = 0; step < most_steps; ++step) {
    problem.derive(x, gradient, hessian);
    const Eigen::VectorXd along = direction(problem, x, gradient, hessian);
    double length = 1.0, change = 0.0;
    for (; length > 1e-6; length *= 0.5) {
      Eigen::VectorXd next = x + length * along;
      for (Eigen::Index i = 0; i < next.size(); ++i) {
        if (problem.is_weight(i)) next[i] = std::max(next[i], 0.0);
      }
      const double there = problem.loss(next);
      if (there > loss) continue;
      change = (next - x).cwiseAbs().maxCoeff();
      x = next;
      loss = there;
      break;
    }
    if (change < settled) break;
  }
  return unpack(x, start.offset.size());
}

}  // namespace scanchor
