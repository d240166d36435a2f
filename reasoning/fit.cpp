#include "reasoning/fit.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/math.hpp"
#include "reasoning/item.hpp"
#include "reasoning/matcher.hpp"
#include "reasoning/up.hpp"

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

constexpr int offset_steps = 200;
constexpr double offset_strength = 1.0;  // examples that hold a prior where it was counted

struct ClauseCount {
  Count hit, background;
};

Matcher match(const Ontology& ontology, const TrainingScene& scene, const ReasonOptions& options) {
  const UpDirection up = find_up(scene.surfaces, options.up, radians(options.up_sigma_deg));
  const Eigen::Matrix3d R = levelling(up.up);
  Surrounding around;
  around.up_sigma = up.sigma;
  if (!scene.surfaces.sensor_positions.empty())
    around.viewpoint = R * scene.surfaces.sensor_positions.front();
  Matcher matcher(ontology, make_items(scene.surfaces, R), around);
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
      const std::int32_t first = item.group ? item.members.front() : item.id;
      const std::string& name = scene.classes[static_cast<std::size_t>(first)];
      int best = -1;
      if (item.group) {
        const int whole = ontology.find(name);
        const bool same = std::all_of(
            item.members.begin(), item.members.end(),
            [&](std::int32_t m) { return scene.classes[static_cast<std::size_t>(m)] == name; });
        if (same && whole >= 0 && matcher.is_group_class(whole)) best = whole;
      } else if (const int whole = name.empty() ? -1 : ontology.find(name); whole >= 0) {
        double most = -1.0;
        for (std::size_t c = 0; c < ontology.classes.size(); ++c) {
          const bool own = static_cast<int>(c) == whole;
          if (!own && ontology.classes[c].part_of != ontology.classes[whole].name()) continue;
          if (own && matcher.is_group_class(whole)) continue;
          double fit = own ? 1.0 : 0.9;  // in doubt it is the thing itself
          for (const auto& clause : matcher.clauses(static_cast<int>(c))) {
            if (clause.usually || !clause.target.empty() || clause.kind == ClauseKind::extremum)
              continue;
            fit *= matcher.evaluate(static_cast<int>(c), clause, item.id).value;
          }
          if (fit > most) {
            most = fit;
            best = static_cast<int>(c);
          }
        }
      }
      of_item.push_back(best);
    }
  }
  std::vector<int> of_item;
};

/// One item with the classes it may be taken for.
struct Example {
  std::vector<double> scores;  // log likelihood ratios, without prior and temperature
  std::vector<int> class_of;
  int truth;
};

/// Probabilities of an example's classes, in their order, and of none of them.
struct Shares {
  std::vector<double> of_class;
  double of_none;
};

Shares shares_of(const Example& example, const std::vector<double>& log_prior, double log_none,
                 double temperature) {
  std::vector<double> s(example.scores.size());
  double top = log_none;
  for (std::size_t k = 0; k < s.size(); ++k) {
    s[k] =
        log_prior[static_cast<std::size_t>(example.class_of[k])] + temperature * example.scores[k];
    top = std::max(top, s[k]);
  }
  const double none = std::exp(log_none - top);
  double all = none;
  for (double& share : s) all += share = std::exp(share - top);
  for (double& share : s) share /= all;
  return {std::move(s), none / all};
}

}  // namespace

Background fit_backgrounds(const Ontology& ontology, const std::vector<TrainingScene>& scenes,
                           const ReasonOptions& options, const std::string& fitted_on) {
  if (scenes.empty()) fail_data("fit", "", "there is no training scene");
  const std::size_t classes = ontology.classes.size();
  Ontology current = ontology;
  Background background;
  // Beliefs in targets depend on the rates and the rates on the beliefs: three rounds settle them
  // to the second digit.
  for (int round = 0; round < 3; ++round) {
    std::vector<std::vector<ClauseCount>> counts(classes);
    for (std::size_t c = 0; c < classes; ++c) counts[c].resize(ontology.classes[c].clauses.size());
    std::vector<double> members(classes, 0.0);
    double total = 0.0;
    double unknown = 0.0;
    std::vector<Example> examples;
    for (std::size_t s = 0; s < scenes.size(); ++s) {
      const auto& scene = scenes[s];
      if (scene.classes.size() != scene.surfaces.surfaces.size()) {
        fail_data("fit", "scene " + std::to_string(s),
                  "has " + std::to_string(scene.surfaces.surfaces.size()) + " surfaces and " +
                      std::to_string(scene.classes.size()) + " classes");
      }
      const Matcher matcher = match(current, scene, options);
      const Truth truth(current, matcher, scene);
      for (const auto& item : matcher.items()) {
        const int is = truth.of_item[static_cast<std::size_t>(item.id)];
        total += 1.0;
        (is >= 0 ? members[static_cast<std::size_t>(is)] : unknown) += 1.0;
        Example example;
        example.truth = is;
        for (std::size_t c = 0; c < classes; ++c) {
          if (matcher.is_group_class(static_cast<int>(c)) != item.group) continue;
          const auto& own = current.classes[c].clauses;
          const bool member = is == static_cast<int>(c);
          // Legs and edges of a desk are the desk's and meet nothing that is said of it. A class is
          // taught by what may be taken for it: what passes its required clauses.
          if (member && matcher.belief(static_cast<int>(c), item.id) <= 0.0) continue;
          for (std::size_t i = 0; i < own.size(); ++i) {
            const double value = matcher.evaluate(static_cast<int>(c), own[i], item.id).value;
            auto& count = member ? counts[c][i].hit : counts[c][i].background;
            count.sum += value;
            count.number += 1.0;
          }
        }
        for (std::size_t c = 0; c < classes; ++c) {
          for (const auto& candidate : matcher.candidates(static_cast<int>(c))) {
            if (candidate.item != item.id) continue;
            example.scores.push_back(
                (candidate.score - std::log(prior_of(current, static_cast<int>(c)))) /
                current.temperature);
            example.class_of.push_back(static_cast<int>(c));
          }
        }
        examples.push_back(std::move(example));
      }
    }
    background = Background{};
    background.fitted_on = fitted_on;
    background.unknown_prior = std::clamp((unknown + 1.0) / (total + 2.0), 0.01, 0.99);
    for (std::size_t c = 0; c < classes; ++c) {
      background.priors.emplace_back(ontology.classes[c].name(),
                                     std::max(members[c], 0.001 * total) / std::max(total, 1.0));
      for (std::size_t i = 0; i < counts[c].size(); ++i) {
        Clause clause = ontology.classes[c].clauses[i];
        clause.hit_rate = clause.background = -1.0;
        background.rates.push_back(
            {ontology.classes[c].name(), clause_text(clause),
             counts[c][i].hit.rate(default_hit_rate(clause), 10.0),
             counts[c][i].background.rate(default_background(clause), 10.0)});
      }
    }
    // Clauses of one class are not independent; one exponent for all likelihood ratios makes up for
    // it. It is the one with the smallest log loss, by golden section.
    std::vector<double> offset(classes);
    for (std::size_t c = 0; c < classes; ++c) offset[c] = std::log(background.priors[c].second);
    const double none = std::log(background.unknown_prior);
    const auto loss = [&](double temperature) {
      double sum = 0.0;
      for (const auto& example : examples) {
        const Shares shares = shares_of(example, offset, none, temperature);
        double right = example.truth < 0 ? shares.of_none : 0.0;
        for (std::size_t k = 0; k < shares.of_class.size(); ++k) {
          if (example.class_of[k] == example.truth) right = shares.of_class[k];
        }
        sum -= std::log(std::max(right, 1e-3));
      }
      return sum;
    };
    double low = 0.2;
    double high = 1.5;
    for (int step = 0; step < 24; ++step) {
      const double a = high - (high - low) * 0.6180339887;
      const double b = low + (high - low) * 0.6180339887;
      (loss(a) < loss(b) ? high : low) = loss(a) < loss(b) ? b : a;
    }
    background.temperature = 0.5 * (low + high);
    // Priors are counted among all surfaces, but only candidates are ever weighed, and clauses that
    // say nearly the same make some classes louder than others. So each class's prior is scaled
    // until it is expected as often among its candidates as it is there: the maximum of the
    // likelihood of the labels (logistic regression with one offset a class).
    for (int step = 0; step < offset_steps; ++step) {
      std::vector<double> there(classes, 0.0);
      std::vector<double> expected(classes, 0.0);
      for (const auto& example : examples) {
        const Shares shares = shares_of(example, offset, none, background.temperature);
        for (std::size_t k = 0; k < shares.of_class.size(); ++k) {
          const auto c = static_cast<std::size_t>(example.class_of[k]);
          expected[c] += shares.of_class[k];
          if (example.class_of[k] == example.truth) there[c] += 1.0;
        }
      }
      for (std::size_t c = 0; c < classes; ++c) {
        offset[c] += std::log((there[c] + offset_strength) / (expected[c] + offset_strength));
      }
    }
    // Only their ratios matter.
    double sum = std::exp(none);
    for (const double o : offset) sum += std::exp(o);
    background.unknown_prior = std::exp(none) / sum;
    for (std::size_t c = 0; c < classes; ++c) {
      background.priors[c].second = std::max(std::exp(offset[c]) / sum, 1e-9);
    }
    apply_background(current, background);
  }
  return background;
}

}  // namespace scanchor
