#include "reasoning/paper_mode.hpp"

#include <algorithm>
#include <cmath>

#include "reasoning/assign.hpp"
#include "reasoning/background.hpp"
#include "reasoning/corner.hpp"
#include "reasoning/groups.hpp"
#include "reasoning/matcher.hpp"
#include "reasoning/reason.hpp"

namespace scanchor {

namespace {

/// Equation 2, mended (S1, S8, S9, S10): `above` compares the centres of mass only, as the paper
/// does (S20 is left as it is).
Evidence paper_relation(RelationTerm term, const Item& a, const Item& b,
                        const Surrounding& around) {
  if (term.relation == Relation::above) term.relation = Relation::higher;
  if (term.relation == Relation::below) term.relation = Relation::lower;
  return relate(term, a, b, around);
}

/// How far x lies outside its interval, as a share of the limit that it misses (S11, S13).
double miss(double x, const Range& range) {
  if (x < range.low) return (range.low - x) / std::max(std::abs(range.low), 1e-9);
  if (x > range.high) return (x - range.high) / std::max(std::abs(range.high), 1e-9);
  return 0.0;
}

struct PaperMatch {
  Disparity disparity;
  double likelihood = 0.0;  ///< own similarity times Theta, the number that is chained forward
  std::vector<ProofClause> proof;
};

class PaperMatcher {
 public:
  PaperMatcher(const Ontology& described, std::vector<Item> surfaces, const Surrounding& shared)
      : ontology(described),
        items(std::move(surfaces)),
        around(shared),
        likelihood(described.classes.size()) {}

  const Ontology& ontology;
  std::vector<Item> items;
  Surrounding around;
  std::vector<std::vector<double>> likelihood;  ///< of each class and item, 0: not similar

  PaperMatch match(int class_index, std::int32_t id) const {
    const Item& item = items[id];
    PaperMatch result;
    double theta = 1.0;  // S12: the model's Theta is 1
    for (const auto& clause : all_clauses(ontology, class_index)) {
      ProofClause entry;
      entry.text = clause_text(clause);
      entry.target_class = clause.target;
      Evidence evidence;
      double value = 1.0;
      switch (clause.kind) {
        case ClauseKind::feature: {
          evidence = feature(clause.feature, clause.range, item);
          const double d = miss(evidence.measured, clause.range);
          (clause.feature == Feature::area              ? result.disparity.area
           : clause.feature == Feature::rectangularness ? result.disparity.rectangularness
                                                        : result.disparity.extension) += d;
          value = std::max(0.0, 1.0 - d);
          break;
        }
        case ClauseKind::rectangular: {
          // S5: R is a number and not a decision; a description without the word has no clause on
          // R.
          evidence = rectangular(item);
          const double d = 1.0 - item.rectangularness.value;
          result.disparity.rectangularness += d;
          value = std::max(0.0, 1.0 - d);
          break;
        }
        case ClauseKind::group: {
          value = id < static_cast<std::int32_t>(group_value.size()) ? group_value[id] : 0.0;
          evidence = {value, static_cast<double>(item.members.size()), 0.0, "1"};
          for (const auto m : item.members) entry.targets.push_back(m);
          theta *= value;
          break;
        }
        case ClauseKind::relation:
        case ClauseKind::negation: {
          value = related(clause, id, evidence, entry.targets);
          if (!clause.usually)
            theta *= value;  // S16: the conjunction is a product on one shared target
          break;
        }
        default: {
          value = unary(class_index, clause, id, evidence);
          theta *= value;  // S17: orientation and extremum are declared clauses of Theta
        }
      }
      entry.likelihood = value;
      entry.background = 0.0;  // the paper's chain is the case beta = 0
      entry.measured = evidence.measured;
      entry.sigma = evidence.sigma;
      entry.unit = evidence.unit;
      result.proof.push_back(std::move(entry));
    }
    result.disparity.theta = 1.0 - theta;
    const auto& d = result.disparity;
    result.likelihood = std::max(0.0, 1.0 - (d.area + d.extension + d.rectangularness)) * theta;
    return result;
  }

  std::vector<double> group_value;

 private:
  double related(const Clause& clause, std::int32_t id, Evidence& evidence,
                 std::vector<std::int32_t>& targets) const {
    const int target_class = ontology.find(clause.target);
    double best = 0.0;
    double none = 1.0;
    for (std::size_t t = 0; t < likelihood[target_class].size(); ++t) {
      const double b = likelihood[target_class][t];
      if (b <= 0.0 || static_cast<std::int32_t>(t) == id) continue;
      double product = b;  // the chain: 0.8 on a table of 0.5 is 0.4
      Evidence weakest;
      for (std::size_t i = 0; i < clause.relations.size(); ++i) {
        const Evidence e = paper_relation(clause.relations[i], items[id], items[t], around);
        if (i == 0 || e.likelihood < weakest.likelihood) weakest = e;
        product = chained(e.likelihood, product);
      }
      for (const auto& nested : clause.target_clauses)
        product *= said_of_target(target_class, nested, static_cast<std::int32_t>(t));
      none *= 1.0 - product;
      if (targets.empty() || product > best) {
        best = product;
        evidence = weakest;
        targets = {static_cast<std::int32_t>(t)};
      }
    }
    return clause.kind == ClauseKind::negation ? none : best;
  }

  double said_of_target(int class_index, const Clause& clause, std::int32_t id) const {
    Evidence evidence;
    std::vector<std::int32_t> targets;
    switch (clause.kind) {
      case ClauseKind::feature:
        evidence = feature(clause.feature, clause.range, items[id]);
        return std::max(0.0, 1.0 - miss(evidence.measured, clause.range));
      case ClauseKind::rectangular:
        return items[id].rectangularness.value;
      case ClauseKind::relation:
      case ClauseKind::negation:
        return related(clause, id, evidence, targets);
      default:
        return unary(class_index, clause, id, evidence);
    }
  }

  double unary(int class_index, const Clause& clause, std::int32_t id, Evidence& evidence) const {
    const Item& item = items[id];
    const double tolerance = clause.range.has_high() ? clause.range.high : 5.0;
    if (clause.kind == ClauseKind::horizontal) evidence = horizontal(item, around, tolerance);
    if (clause.kind == ClauseKind::vertical) evidence = vertical(item, around, tolerance);
    if (clause.kind == ClauseKind::extremum && clause.extremum == Extremum::cornered) {
      evidence = cornered(items, item, around);
    } else if (clause.kind == ClauseKind::extremum) {
      // S18: "the largest horizontal plane with the lowest z-value": within 10 cm of the lowest
      // rival of the same description.
      double lowest = INFINITY;
      double highest = -INFINITY;
      double largest = 0.0;
      for (const auto& other : items) {
        if (!other.has_shape || other.group || !similar_without_extremum(class_index, other))
          continue;
        lowest = std::min(lowest, other.z);
        highest = std::max(highest, other.z);
        largest = std::max(largest, other.area.value);
      }
      const double z = clause.extremum == Extremum::lowest ? item.z - lowest : highest - item.z;
      const bool holds = clause.extremum == Extremum::largest
                             ? item.area.value >= largest
                             : clause.extremum == Extremum::outermost || z <= 0.10;
      evidence = {holds ? 1.0 : 0.0, clause.extremum == Extremum::largest ? item.area.value : z,
                  item.z_sigma, "m"};
    }
    return evidence.likelihood;
  }

  bool similar_without_extremum(int class_index, const Item& item) const {
    double off = 0.0;
    for (const auto& clause : all_clauses(ontology, class_index)) {
      if (clause.kind == ClauseKind::feature)
        off += miss(feature(clause.feature, clause.range, item).measured, clause.range);
      if (clause.kind == ClauseKind::horizontal) off += 1.0 - horizontal(item, around).likelihood;
      if (clause.kind == ClauseKind::vertical) off += 1.0 - vertical(item, around).likelihood;
    }
    return off < similarity_threshold;
  }
};

}  // namespace

Labelling reason_as_paper(const Surfaces& surfaces, const Ontology& ontology,
                          const ReasonOptions& options, const UpDirection& up) {
  Labelling labelling;
  labelling.mode = "paper";
  labelling.ontology = ontology.name;
  labelling.up = up.up;
  labelling.up_sigma = up.sigma;
  const Eigen::Matrix3d R = levelling(up.up);
  Surrounding around;
  around.up_sigma = up.sigma;
  if (!surfaces.sensor_positions.empty()) around.viewpoint = R * surfaces.sensor_positions.front();

  PaperMatcher paper(ontology, make_items(surfaces, R), around);
  const std::size_t surface_count = paper.items.size();
  // S19: bottom-up in the order of need, so the recursion of Theta ends in the axioms.
  for (const int c : evaluation_order(ontology)) {
    const auto clauses = all_clauses(ontology, c);
    const auto group = std::find_if(clauses.begin(), clauses.end(),
                                    [](const Clause& x) { return x.kind == ClauseKind::group; });
    std::size_t begin = 0;
    if (group != clauses.end()) {
      std::vector<Member> pool;
      const auto& members = paper.likelihood[ontology.find(group->target)];
      for (std::size_t i = 0; i < members.size() && i < surface_count; ++i) {
        if (members[i] > 0.0) pool.push_back({static_cast<std::int32_t>(i), members[i]});
      }
      begin = paper.items.size();
      paper.group_value.resize(begin, 0.0);
      for (auto& found : build_groups(paper.items, pool, *group, around)) {
        const auto id = static_cast<std::int32_t>(paper.items.size());
        paper.items.push_back(make_group(paper.items, std::move(found.members), id));
        paper.group_value.push_back(found.probability);
      }
    }
    auto& own = paper.likelihood[c];
    own.assign(paper.items.size(), 0.0);
    const std::size_t end = group != clauses.end() ? paper.items.size() : surface_count;
    for (std::size_t i = begin; i < end; ++i) {
      const PaperMatch match = paper.match(c, static_cast<std::int32_t>(i));
      if (match.disparity.sum() < similarity_threshold) own[i] = match.likelihood;
    }
  }
  for (const auto& item : paper.items) {
    Entity entity = make_entity(item, R.transpose());
    // S14: of several classes under delta the most likely one is the label; of nearly equal ones
    // that with the longest description, since a few words fit almost everything ("board" fits
    // every desk).
    for (std::size_t c = 0; c < ontology.classes.size(); ++c) {
      const auto& own = paper.likelihood[c];
      if (static_cast<std::size_t>(item.id) < own.size() && own[item.id] > 0.0) {
        entity.classes.push_back({ontology.classes[c].name(), own[item.id]});
      }
    }
    std::stable_sort(entity.classes.begin(), entity.classes.end(),
                     [](const auto& a, const auto& b) { return a.probability > b.probability; });
    entity.label = "unknown";
    if (!entity.classes.empty()) {
      const double best = entity.classes.front().probability;
      std::size_t longest = 0;
      for (const auto& c : entity.classes) {
        const std::size_t length = all_clauses(ontology, ontology.find(c.name)).size();
        if (c.probability < best - options.ambiguity_margin || length <= longest) continue;
        longest = length;
        entity.label = c.name;
        entity.probability = c.probability;
      }
      entity.proof = paper.match(ontology.find(entity.label), item.id).proof;
    } else {
      entity.classes.push_back({"unknown", 1.0});
      entity.probability = 1.0;
    }
    labelling.entities.push_back(std::move(entity));
  }
  for (std::size_t i = 0; i < surface_count; ++i)
    labelling.entity_of_surface.push_back(static_cast<std::int32_t>(i));
  for (auto& entity : labelling.entities) {
    if (entity.members.empty() || entity.label == "unknown") continue;
    for (const auto m : entity.members) {
      if (labelling.entities[m].whole >= 0) continue;
      labelling.entities[m].whole = entity.id;
      labelling.entity_of_surface[m] = entity.id;
      entity.surfaces.push_back(m);
    }
  }
  return labelling;
}

}  // namespace scanchor
