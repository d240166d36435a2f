#include "reasoning/fit.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/error.hpp"
#include "reasoning/fit_weights.hpp"
#include "reasoning/item.hpp"
#include "reasoning/levelled.hpp"
#include "reasoning/matcher.hpp"

namespace scanchor {

namespace {

struct Count {
  double sum = 0.0;
  double number = 0.0;
  /// Towards the documented default with the weight of `strength` examples, so that rare classes do
  /// not claim certainty.
  [[nodiscard]] double rate(double standard, double strength) const {
    return std::clamp((sum + strength * standard) / (number + strength), 0.002, 0.998);
  }
};

// A class or a clause with few examples stays near what is usual: its share of all surfaces, and
// half of what a clause would say if it were independent of its neighbours.
constexpr double offset_prior = 0.1;
constexpr double weight_prior = 10.0;
constexpr double usual_weight = 0.5;

struct ClauseCount {
  Count hit, background;
};

Matcher match(const Ontology& ontology, const TrainingScene& scene, const ReasonOptions& options) {
  const Levelled levelled = level(scene.surfaces, options);
  Matcher matcher(ontology, make_items(scene.surfaces, levelled.R_level_cloud), levelled.around);
  matcher.run();
  return matcher;
}

/// What an item truly is: its class's index, -1 for none that is described. Parts are told from
/// their wholes by being nearer to the part's own features (all clauses that name no target) than
/// to those of the whole.
class Truth {
 public:
  Truth(const Ontology& ontology, const Matcher& matcher, const TrainingScene& scene) {
    for (const auto& item : matcher.items()) {
      const std::string name = item.group ? name_of_most(matcher, item, scene.classes)
                                          : scene.classes[static_cast<std::size_t>(item.id)];
      of_item.push_back(name.empty() ? -1 : nearest(ontology, matcher, ontology.find(name), item));
    }
  }
  std::vector<int> of_item;

 private:
  /// Of the thing itself and its parts the one whose features the item has most; of the kinds of
  /// that the one whose own words, relations too, hold best, where they hold rather than not.
  static int nearest(const Ontology& ontology, const Matcher& matcher, int whole,
                     const Item& item) {
    int best = -1;
    double most = -1.0;
    for (std::size_t c = 0; whole >= 0 && c < ontology.classes.size(); ++c) {
      const int index = static_cast<int>(c);
      const bool own = index == whole;
      if (matcher.is_group_class(index) != item.group) continue;
      if (!own && ontology.classes[c].part_of != ontology.classes[whole].name()) continue;
      if (item.group && matcher.belief(index, item.id) <= 0.0) continue;  // made for another class
      double fit = own ? 1.0 : 0.9;  // in doubt it is the thing itself
      for (const auto& clause : matcher.clauses(index)) {
        if (clause.usually || !clause.target.empty() || clause.kind == ClauseKind::extremum)
          continue;
        fit *= matcher.evaluate(index, clause, item.id).value;
      }
      if (fit > most) {
        most = fit;
        best = index;
      }
    }
    return best < 0 ? best : kind_of(ontology, matcher, best, item);
  }

  static int kind_of(const Ontology& ontology, const Matcher& matcher, int whole,
                     const Item& item) {
    int best = whole;
    double most = 0.5;
    for (std::size_t c = 0; c < ontology.classes.size(); ++c) {
      const auto& description = ontology.classes[c];
      const int index = static_cast<int>(c);
      if (description.parent != ontology.classes[whole].name() ||
          matcher.is_group_class(index) != item.group || matcher.belief(index, item.id) <= 0.0)
        continue;
      double fit = 1.0;
      for (const auto& clause : description.clauses) {
        if (!clause.usually) fit *= matcher.evaluate(index, clause, item.id).value;
      }
      if (fit > most) {
        most = fit;
        best = index;
      }
    }
    return best == whole ? whole : kind_of(ontology, matcher, best, item);
  }
};

/// Where the clauses of the classes stand among the weights, which are in the order of the rates:
/// class by class, own clauses only. Those of a parent are its own: what is
/// counted for it holds for its kinds.
class Parameters {
 public:
  explicit Parameters(const Ontology& ontology) {
    for (const auto& description : ontology.classes) {
      first_.push_back(count_);
      count_ += static_cast<std::int32_t>(description.clauses.size());
    }
    for (std::size_t c = 0; c < ontology.classes.size(); ++c) {
      auto& own = of_class_.emplace_back();  // in the order of all_clauses
      for (const int k : with_parents(ontology, static_cast<int>(c))) {
        const auto owner = static_cast<std::size_t>(k);
        for (std::size_t i = 0; i < ontology.classes[owner].clauses.size(); ++i)
          own.push_back(first_[owner] + static_cast<std::int32_t>(i));
      }
    }
  }
  [[nodiscard]] std::int32_t count() const { return count_; }
  [[nodiscard]] const std::vector<std::int32_t>& of_class(std::size_t c) const {
    return of_class_[c];
  }

 private:
  std::vector<std::int32_t> first_;
  std::vector<std::vector<std::int32_t>> of_class_;
  std::int32_t count_ = 0;
};

/// What one round over the training scenes counts.
struct Counts {
  std::vector<std::vector<ClauseCount>> clauses;
  std::vector<double> members;
  double total = 0.0;
  double unknown = 0.0;
};

void count_item(int is, Counts& counts) {
  counts.total += 1.0;
  (is >= 0 ? counts.members[static_cast<std::size_t>(is)] : counts.unknown) += 1.0;
}

void count_clauses(const Ontology& ontology, const Matcher& matcher, const Item& item, int is,
                   Counts& counts) {
  for (std::size_t c = 0; c < ontology.classes.size(); ++c) {
    const int index = static_cast<int>(c);
    if (matcher.is_group_class(index) != item.group) continue;
    const auto& own = ontology.classes[c].clauses;
    const bool member = is == index;
    const bool candidate = matcher.belief(index, item.id) > 0.0;
    // Legs and edges of a desk are the desk's and meet nothing that is said of it. A class is
    // taught by what may be taken for it: what passes its required clauses.
    if ((member || item.group) && !candidate) continue;
    for (std::size_t i = 0; i < own.size(); ++i) {
      // Context is asked only of what passes the required clauses.
      if (own[i].usually && !candidate) continue;
      auto& count = member ? counts.clauses[c][i].hit : counts.clauses[c][i].background;
      count.sum += matcher.evaluate(index, own[i], item.id).value;
      count.number += 1.0;
    }
  }
}

Background rates_of(const Ontology& ontology, const Counts& counts) {
  Background background;
  background.unknown_prior = std::clamp((counts.unknown + 1.0) / (counts.total + 2.0), 0.01, 0.99);
  for (std::size_t c = 0; c < ontology.classes.size(); ++c) {
    background.priors.emplace_back(
        ontology.classes[c].name(),
        std::max(counts.members[c], 0.001 * counts.total) / std::max(counts.total, 1.0));
    for (std::size_t i = 0; i < counts.clauses[c].size(); ++i) {
      Clause clause = ontology.classes[c].clauses[i];
      clause.hit_rate = clause.background = -1.0;
      background.rates.push_back(
          {ontology.classes[c].name(), clause_text(clause),
           counts.clauses[c][i].hit.rate(default_hit_rate(clause), 10.0),
           counts.clauses[c][i].background.rate(default_background(clause), 10.0), 1.0});
    }
  }
  return background;
}

/// What the clauses of every candidate class say about an item, with the rates of `ontology`.
WeighedExample weigh(const Ontology& ontology, const Parameters& parameters, const Matcher& matcher,
                     const Item& item, int is) {
  WeighedExample example;
  example.truth = is;
  for (std::size_t c = 0; c < ontology.classes.size(); ++c) {
    const int index = static_cast<int>(c);
    if (matcher.belief(index, item.id) <= 0.0) continue;
    WeighedExample::Candidate candidate{static_cast<std::int32_t>(index), {}};
    const auto& clauses = matcher.clauses(index);
    for (std::size_t i = 0; i < clauses.size(); ++i) {
      const double value = matcher.evaluate(index, clauses[i], item.id).value;
      candidate.terms.push_back(
          {parameters.of_class(c)[i], clauses[i].weight * evidence_of(clauses[i], value)});
    }
    example.candidates.push_back(std::move(candidate));
  }
  return example;
}

}  // namespace

std::string name_of_most(const Matcher& matcher, const Item& group,
                         const std::vector<std::string>& classes) {
  std::map<std::string, double> area;
  double all = 0.0;
  for (const auto m : group.members) {
    const double own = matcher.items()[static_cast<std::size_t>(m)].area.value;
    area[classes[static_cast<std::size_t>(m)]] += own;
    all += own;
  }
  for (const auto& [name, own] : area) {
    if (2.0 * own > all) return name;
  }
  return "";
}

Background fit_backgrounds(const Ontology& ontology, const std::vector<TrainingScene>& scenes,
                           const ReasonOptions& options, const std::string& fitted_on) {
  if (scenes.empty()) fail_data("fit", "", "there is no training scene");
  for (std::size_t s = 0; s < scenes.size(); ++s) {
    if (scenes[s].classes.size() == scenes[s].surfaces.surfaces.size()) continue;
    fail_data("fit", "scene " + std::to_string(s),
              "has " + std::to_string(scenes[s].surfaces.surfaces.size()) + " surfaces and " +
                  std::to_string(scenes[s].classes.size()) + " classes");
  }
  const std::size_t classes = ontology.classes.size();
  const Parameters parameters(ontology);
  Ontology current = ontology;
  Background background;
  // Beliefs in targets depend on what was counted, and that on the beliefs: two rounds settle the
  // rates to the second digit, two more the weights.
  for (int round = 0; round < 4; ++round) {
    const bool weighing = round >= 2;
    Counts counts;
    counts.members.assign(classes, 0.0);
    for (const auto& description : ontology.classes)
      counts.clauses.emplace_back(description.clauses.size());
    std::vector<WeighedExample> examples;
    for (const auto& scene : scenes) {
      const Matcher matcher = match(current, scene, options);
      const Truth truth(current, matcher, scene);
      for (const auto& item : matcher.items()) {
        const int is = truth.of_item[static_cast<std::size_t>(item.id)];
        count_item(is, counts);
        if (weighing) {
          examples.push_back(weigh(current, parameters, matcher, item, is));
        } else {
          count_clauses(current, matcher, item, is, counts);
        }
      }
    }
    Background counted = rates_of(current, counts);
    if (weighing) counted.rates = background.rates;  // those that were weighed
    background = std::move(counted);
    background.fitted_on = fitted_on;
    if (weighing) {
      FittedWeights start;
      const double none = std::log(background.unknown_prior);
      for (const auto& [name, share] : background.priors)
        start.offset.push_back(std::log(share) - none);
      start.weight.assign(static_cast<std::size_t>(parameters.count()), usual_weight);
      const FittedWeights fitted = fit_weights(examples, start, offset_prior, weight_prior);
      // Only the ratios of the priors matter.
      double sum = 1.0;
      for (const double o : fitted.offset) sum += std::exp(o);
      background.unknown_prior = 1.0 / sum;
      for (std::size_t c = 0; c < classes; ++c)
        background.priors[c].second = std::max(std::exp(fitted.offset[c]) / sum, 1e-9);
      for (std::size_t i = 0; i < background.rates.size(); ++i)
        background.rates[i].weight = fitted.weight[i];
    }
    apply_background(current, background);
  }
  return background;
}

}  // namespace scanchor
