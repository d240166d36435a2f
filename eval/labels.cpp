#include "eval/labels.hpp"

#include <algorithm>
#include <cmath>

#include "eval/overlap.hpp"
#include "eval/statistics.hpp"

namespace scanchor {
namespace {

std::size_t bin_of(double probability, std::size_t bins) {
  // (low, high], the first with 0: as in the published code of Guo et al.
  const double place =
      std::ceil(std::clamp(probability, 0.0, 1.0) * static_cast<double>(bins)) - 1.0;
  return static_cast<std::size_t>(std::max(place, 0.0));
}

void add_bins(std::vector<ReliabilityBin>& to, const std::vector<ReliabilityBin>& from) {
  if (to.size() < from.size()) to.resize(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    to[i].count += from[i].count;
    to[i].right += from[i].right;
    to[i].probability.add(from[i].probability);
  }
}

}  // namespace

void add_to_bins(std::vector<ReliabilityBin>& bins, double probability, bool right) {
  auto& bin = bins[bin_of(probability, bins.size())];
  ++bin.count;
  bin.right += right ? 1 : 0;
  bin.probability.add(probability);
}

void LabelScore::add(const LabelScore& other) {
  things += other.things;
  unknown += other.unknown;
  ambiguous += other.ambiguous;
  unknown_right += other.unknown_right;
  brier_things += other.brier_things;
  brier.add(other.brier);
  add_bins(reliability, other.reliability);
  add_bins(risk, other.risk);
}

LabelScore score_labels(const std::vector<LabelledThing>& things, const Protocol& protocol) {
  LabelScore score;
  score.reliability.resize(static_cast<std::size_t>(protocol.calibration_bins));
  score.risk.resize(LabelScore::risk_bins);
  for (const auto& thing : things) {
    ++score.things;
    double brier = 0;
    bool truth_named = false;
    auto distribution = thing.distribution;
    if (distribution.empty()) distribution = {{thing.label, thing.probability}};
    for (const auto& [id, p] : distribution) {
      const double wanted = id == thing.truth ? 1.0 : 0.0;
      truth_named = truth_named || id == thing.truth;
      brier += (p - wanted) * (p - wanted);
    }
    score.brier.add(truth_named ? brier : brier + 1.0);
    ++score.brier_things;
    if (thing.ambiguous) {
      ++score.ambiguous;
    } else if (thing.label == unlabelled) {
      ++score.unknown;
      score.unknown_right += thing.truth == unlabelled ? 1 : 0;
    } else {
      add_to_bins(score.reliability, thing.probability, thing.label == thing.truth);
      add_to_bins(score.risk, thing.probability, thing.label == thing.truth);
    }
  }
  return score;
}

double expected_calibration_error(const std::vector<ReliabilityBin>& bins) {
  std::int64_t all = 0;
  double error = 0;
  for (const auto& bin : bins) {
    all += bin.count;
    error += std::abs(static_cast<double>(bin.right) - bin.probability.value());
  }
  return all > 0 ? error / static_cast<double>(all) : 0.0;
}

double expected_calibration_error(const LabelScore& score) {
  return expected_calibration_error(score.reliability);
}

double brier_score(const LabelScore& score) {
  return score.brier_things > 0 ? score.brier.value() / static_cast<double>(score.brier_things)
                                : 0.0;
}
double unknown_rate(const LabelScore& score) { return ratio_of(score.unknown, score.things); }
double ambiguous_rate(const LabelScore& score) { return ratio_of(score.ambiguous, score.things); }

std::vector<RiskPoint> risk_coverage(const LabelScore& score) {
  std::vector<RiskPoint> points;
  std::int64_t taken = 0;
  std::int64_t wrong = 0;
  for (std::size_t i = score.risk.size(); i-- > 0;) {
    if (score.risk[i].count == 0) continue;
    taken += score.risk[i].count;
    wrong += score.risk[i].count - score.risk[i].right;
    points.push_back({ratio_of(taken, score.things), ratio_of(wrong, taken),
                      static_cast<double>(i) / static_cast<double>(score.risk.size())});
  }
  return points;
}

double area_under_risk(const LabelScore& score) {
  double area = 0;
  double before = 0;
  for (const auto& point : risk_coverage(score)) {
    area += point.risk * (point.coverage - before);
    before = point.coverage;
  }
  return before > 0 ? area / before : 0.0;
}

std::vector<LabelledThing> labelled_things(const ObjectSummary& summary) {
  std::vector<LabelledThing> things;
  for (const auto& claim : summary.claims) {
    if (claim.status == ClaimStatus::ignored) continue;
    LabelledThing thing;
    thing.truth = claim.thing < 0 ? unlabelled
                                  : summary.things[static_cast<std::size_t>(claim.thing)].class_id;
    thing.label = claim.class_id;
    thing.probability = claim.confidence;
    things.push_back(thing);
  }
  return things;
}

std::vector<LabelledThing> labelled_things(const ScanTruth& truth, const Surfaces& surfaces,
                                           const Labelling& labelling, const Protocol& protocol,
                                           const std::vector<ClassId>& described) {
  const ClassRules rules = class_rules(protocol);
  std::vector<char> has_word(rules.size(), described.empty() ? 1 : 0);
  for (const auto id : described) {
    if (const auto counted = rules.of(id); counted >= 0)
      has_word[static_cast<std::size_t>(counted)] = 1;
  }
  // Which entity a point belongs to, named or not.
  std::vector<std::int32_t> owner(truth.size(), -1);
  for (const auto& surface : surfaces.surfaces) {
    const auto s = static_cast<std::size_t>(surface.id);
    if (s >= labelling.entity_of_surface.size()) continue;
    for (const auto i : surface.inliers) {
      if (i < owner.size()) owner[i] = labelling.entity_of_surface[s];
    }
  }
  std::vector<std::int32_t> counted(truth.size(), -1);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const bool ignored = std::binary_search(truth.ignored_instances.begin(),
                                            truth.ignored_instances.end(), truth.instance[i]);
    if (!ignored) counted[i] = rules.of(truth.class_id[i]);
  }
  struct Laid {
    std::int64_t points = 0, with_truth = 0, most = 0;
    std::int32_t truth = -1;
  };
  std::vector<Laid> laid(labelling.entities.size());
  for (const auto& cell : overlap_table(counted, owner)) {
    if (cell.predicted < 0 || static_cast<std::size_t>(cell.predicted) >= laid.size()) continue;
    auto& entry = laid[static_cast<std::size_t>(cell.predicted)];
    entry.points += cell.points;
    if (cell.truth < 0) continue;
    entry.with_truth += cell.points;
    if (cell.points <= entry.most) continue;
    entry.most = cell.points;
    entry.truth = cell.truth;
  }
  std::vector<LabelledThing> things;
  for (std::size_t e = 0; e < laid.size(); ++e) {
    const auto& entry = laid[e];
    if (entry.points < protocol.plane_min_points || 2 * entry.with_truth < entry.points) continue;
    const Entity& entity = labelling.entities[e];
    LabelledThing thing;
    const bool mostly = static_cast<double>(entry.most) >
                        protocol.object_purity * static_cast<double>(entry.with_truth);
    if (mostly && has_word[static_cast<std::size_t>(entry.truth)]) thing.truth = entry.truth;
    const auto counted_class = [&](const std::string& label) {
      const auto id = class_of_label(label);
      return id ? std::max(rules.of(*id), unlabelled) : unlabelled;
    };
    thing.ambiguous = entity.label == "ambiguous";
    thing.label = counted_class(entity.label);
    thing.probability = std::clamp(entity.probability, 0.0, 1.0);
    for (const auto& word : entity.classes) {
      const auto id = counted_class(word.name);
      const auto found = std::find_if(thing.distribution.begin(), thing.distribution.end(),
                                      [&](const auto& p) { return p.first == id; });
      if (found == thing.distribution.end()) {
        thing.distribution.emplace_back(id, std::clamp(word.probability, 0.0, 1.0));
      } else {
        found->second = std::min(1.0, found->second + std::clamp(word.probability, 0.0, 1.0));
      }
    }
    things.push_back(std::move(thing));
  }
  return things;
}

}  // namespace scanchor
