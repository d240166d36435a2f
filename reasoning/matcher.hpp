#pragma once
// From items and descriptions to beliefs: candidates by their own features, then relations in the
// order of need, then groups.

#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "reasoning/item.hpp"
#include "reasoning/ontology.hpp"
#include "reasoning/plan_grid.hpp"
#include "reasoning/relation.hpp"
#include "reasoning/scene_extent.hpp"
#include "reasoning/unary_index.hpp"

namespace scanchor {

/// A clause held against one entity.
struct ClauseValue {
  double value = 0.0;                 ///< [0, 1], the belief in the target included
  Evidence evidence;                  ///< of the weakest of its relations
  std::int32_t target = -1;           ///< item that it was satisfied on best; -1: none
  std::vector<std::int32_t> members;  ///< of a group clause
};

/// An entity that passed the required clauses of a class.
struct Candidate {
  std::int32_t item = 0;
  double score = 0.0;   ///< ln of prior x likelihood ratios, S_c of reasoning.md 2.4
  double belief = 0.0;  ///< [0, 1] class against unknown, no coupling between classes: what
                        ///< relations of others build on
  double fit = 1.0;  ///< [0, 1] product of the required clauses: that the whole description holds;
                     ///< what groups build on
};

/// A required clause below this rules the class out (the threshold of arc consistency,
/// reasoning.md 2.8).
inline constexpr double required_gate = 0.05;

/// ln of P(value | class) / P(value | anything else) for a clause with hit rate alpha and
/// background beta.
double log_likelihood_ratio(double value, double hit_rate, double background);

/// The same with the rates of the clause, before its weight; groups count finds only.
double evidence_of(const Clause& clause, double value);

class Matcher {
 public:
  /// `items` are surfaces; groups are appended as they are found.
  Matcher(const Ontology& ontology, std::vector<Item> items, const Surrounding& around);

  /// All beliefs. Two passes: required clauses in the order of need, then the `usually` clauses on
  /// the beliefs of the first.
  void run();

  [[nodiscard]] const std::vector<Item>& items() const { return items_; }
  [[nodiscard]] std::size_t surface_count() const { return surface_count_; }
  /// Of one class, by rising item.
  [[nodiscard]] const std::vector<Candidate>& candidates(int class_index) const {
    return candidates_[class_index];
  }
  [[nodiscard]] double belief(int class_index, std::int32_t item) const;
  [[nodiscard]] const std::vector<Clause>& clauses(int class_index) const {
    return clauses_[class_index];
  }
  /// The words of one of the clauses above, or of one nested in it.
  [[nodiscard]] const std::string& text_of(const Clause& clause) const;
  [[nodiscard]] bool is_group_class(int class_index) const {
    return group_clause_[class_index] >= 0;
  }

  /// One clause of a class held against an item, with its evidence; after run().
  [[nodiscard]] ClauseValue evaluate(int class_index, const Clause& clause,
                                     std::int32_t item) const;

 private:
  struct Target {
    double belief;
    std::int32_t item;
    double fit;
  };
  /// Targets of one belief and one geometry: what holds of the first holds of all.
  struct Run {
    double belief;
    std::int32_t first;
    std::int32_t second;  ///< -1: there is none
    std::int32_t count;
  };
  [[nodiscard]] ClauseValue evaluate_unary(const Clause& clause, std::int32_t item) const;
  [[nodiscard]] ClauseValue evaluate_relation(const Clause& clause, std::int32_t item) const;
  [[nodiscard]] double restriction(const Clause& clause, std::int32_t target) const;
  [[nodiscard]] int target_class(const Clause& clause) const;
  [[nodiscard]] ClauseValue evaluate_largest(int class_index, std::int32_t item) const;
  [[nodiscard]] const Evidence& corner_of(std::int32_t item) const;
  void evaluate_class(int class_index);
  void evaluate_context(int class_index);
  std::vector<std::int32_t> find_groups(const Clause& clause);
  void publish(int class_index);

  const Ontology& ontology_;
  std::vector<Item> items_;
  Surrounding around_;
  std::size_t surface_count_ = 0;
  std::vector<std::vector<Clause>> clauses_;
  std::vector<int> group_clause_;
  std::unordered_map<std::string, int> class_of_name_;  ///< looked up, never walked through
  UnaryIndex index_;
  std::vector<std::vector<Candidate>> candidates_;
  std::vector<std::vector<Target>> targets_;                   ///< of a class, falling belief
  std::vector<std::vector<Run>> runs_;                         ///< the same, twins as one
  std::vector<PlanGrid> grids_;                                ///< of the boxes of many runs
  std::vector<std::int32_t> twin_;                             ///< first item of this geometry
  std::vector<Evidence> horizontal_, vertical_, rectangular_;  ///< of each surface
  mutable std::vector<std::optional<Evidence>> cornered_;      ///< of each item, once asked for
  mutable std::map<std::pair<const Clause*, std::int32_t>, double>
      restrictions_;  ///< of own clauses and their targets, kept while running
  mutable std::unordered_map<const Clause*, std::string> texts_;  ///< once asked for
  bool running_ = false;
  std::vector<double> group_value_;  ///< P(enough members) of each item, groups only
  SceneExtent extent_;
};

}  // namespace scanchor
