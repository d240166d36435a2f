#include "reasoning/background.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace scanchor {

void apply_background(Ontology& ontology, const Background& background) {
  ontology.fitted_on = background.fitted_on;
  ontology.unknown_prior = background.unknown_prior;
  ontology.temperature = background.temperature;
  for (const auto& [name, prior] : background.priors) {
    if (const int c = ontology.find(name); c >= 0) ontology.classes[c].prior = prior;
  }
  for (const auto& rate : background.rates) {
    const int c = ontology.find(rate.class_name);
    if (c < 0) continue;
    for (auto& clause : ontology.classes[c].clauses) {
      if (clause_text(clause) != rate.clause) continue;
      clause.hit_rate = rate.hit_rate;
      clause.background = rate.background;
      clause.counted_weight = rate.weight;
    }
  }
}

namespace {

/// Features, directions, relations, ...; and context apart, since it is counted among candidates.
int kind_of(const Clause& clause) {
  int kind = static_cast<int>(clause.kind);
  if (clause.kind == ClauseKind::rectangular) kind = static_cast<int>(ClauseKind::feature);
  if (clause.kind == ClauseKind::vertical) kind = static_cast<int>(ClauseKind::horizontal);
  return 2 * kind + (clause.usually ? 1 : 0);
}

struct Mean {
  double sum = 0.0, number = 0.0;
  void add(double x) { sum += x, number += 1.0; }
  [[nodiscard]] double or_else(double otherwise) const {
    return number > 0.0 ? sum / number : otherwise;
  }
};

}  // namespace

void fill_uncounted(Ontology& ontology) {
  std::map<int, Mean> weights, hits;
  std::map<std::string, Mean> backgrounds;
  Mean weight, log_prior;
  for (const auto& described : ontology.classes) {
    if (described.prior > 0.0) log_prior.add(std::log(described.prior));
    for (const auto& clause : described.clauses) {
      if (clause.hit_rate < 0.0) continue;
      weights[kind_of(clause)].add(clause.counted_weight);
      weight.add(clause.counted_weight);
      hits[kind_of(clause)].add(clause.hit_rate);
      backgrounds[clause_text(clause)].add(clause.background);
    }
  }
  if (weight.number == 0.0) return;
  for (auto& described : ontology.classes) {
    if (described.prior < 0.0 && log_prior.number > 0.0)
      described.prior = std::exp(log_prior.sum / log_prior.number);
    for (auto& clause : described.clauses) {
      if (clause.hit_rate >= 0.0) continue;
      clause.counted_weight = weights[kind_of(clause)].or_else(weight.or_else(1.0));
      clause.hit_rate = hits[kind_of(clause)].or_else(default_hit_rate(clause));
      clause.background = backgrounds[clause_text(clause)].or_else(default_background(clause));
    }
  }
}

namespace {

/// Share of [low, high] that a range covers, sizes being spread evenly over their logarithm: as
/// many small things as large ones.
double log_share(const Range& range, double low, double high) {
  const double a = std::clamp(range.low, low, high);
  const double b = std::clamp(range.high, low, high);
  return std::clamp(std::log(b / a) / std::log(high / low), 0.02, 0.98);
}

/// What a random surface of a room satisfies, as long as nobody has counted: areas from 0.01 to 30
/// m2, lengths from 0.1 to 6 m.
double feature_share(const Clause& clause) {
  switch (clause.feature) {
    case Feature::area:
      return log_share(clause.range, 0.01, 30.0);
    case Feature::extension:
      return log_share(clause.range, 0.1, 6.0);
    case Feature::width:
    case Feature::height:
      return log_share(clause.range, 0.03, 6.0);
    default:
      return 0.5;
  }
}

/// Heights are spread evenly from the floor to 3 m; never below 0.1, since much of a room is at a
/// few levels.
double level_share(const Range& range) {
  return std::clamp((std::clamp(range.high, 0.0, 3.0) - std::clamp(range.low, 0.0, 3.0)) / 3.0, 0.1,
                    0.98);
}

}  // namespace

double default_hit_rate(const Clause& clause) {
  if (clause.usually) return 0.8;  // "usually" is taken at its word
  switch (clause.kind) {
    case ClauseKind::horizontal:
    case ClauseKind::vertical:
      return 0.99;
    case ClauseKind::feature:
    case ClauseKind::rectangular:
      return 0.97;
    default:
      return 0.95;
  }
}

double default_background(const Clause& clause) {
  // Parallel to a floor 0.4, orthogonal 0.5, above 0.15, on 0.05: assumed shares of the surfaces of
  // a room.
  const auto of_terms = [](const std::vector<RelationTerm>& terms) {
    double product = 1.0;
    for (const auto& term : terms) {
      switch (term.relation) {
        case Relation::parallel:
          product *= 0.4;
          break;
        case Relation::orthogonal:
          product *= 0.5;
          break;
        case Relation::above:
        case Relation::below:
          product *= 0.15;
          break;
        case Relation::on:
        case Relation::supports:
        case Relation::inside:
          product *= 0.05;
          break;
        case Relation::higher:
        case Relation::lower:
          product *= 0.5;
          break;
        case Relation::elevation:
        case Relation::bottom:
        case Relation::top:
          product *= level_share(term.range);
          break;
        default:
          product *= 0.15;
          break;
      }
    }
    return std::max(product, 0.02);
  };
  switch (clause.kind) {
    case ClauseKind::feature:
      return feature_share(clause);
    case ClauseKind::horizontal:
      return 0.4;
    case ClauseKind::vertical:
      return 0.5;
    case ClauseKind::rectangular:
      return 0.5;
    case ClauseKind::extremum:
      return 0.1;
    case ClauseKind::relation:
      return of_terms(clause.relations);
    case ClauseKind::negation:
      return 1.0 - of_terms(clause.relations);
    case ClauseKind::group:
      return 0.02;
  }
  return 0.2;
}

double hit_rate_of(const Clause& clause) {
  return clause.hit_rate >= 0.0 ? clause.hit_rate : default_hit_rate(clause);
}

double background_of(const Clause& clause) {
  return clause.background >= 0.0 ? clause.background : default_background(clause);
}

double prior_of(const Ontology& ontology, int class_index) {
  const double counted = ontology.classes[class_index].prior;
  if (counted >= 0.0) return counted;
  // Half of all surfaces are of described classes, each as likely as another.
  return 0.5 / static_cast<double>(ontology.classes.size());
}

double unknown_prior_of(const Ontology& ontology) {
  return ontology.unknown_prior > 0.0 ? ontology.unknown_prior : 0.5;
}

}  // namespace scanchor
