#pragma once
// Relations between things or faces, said against true.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "eval/fixed_sum.hpp"

namespace scanchor {

/// "a is `relation` b". Symmetric relations are given once, with a < b.
struct NamedRelation {
  std::string relation;       ///< "on", "parallel", ...
  std::int32_t a = 0, b = 0;  ///< instances or faces of the truth
  bool holds = true;        ///< in the truth; a list of truths may hold pairs for which it does not
  bool borderline = false;  ///< near the limit of the definition: counted apart
  double probability = 1.0;  ///< of a claim that it holds
  auto operator<=>(const NamedRelation&) const = default;
};

struct RelationCounts {
  std::int64_t right = 0, wrong = 0, missed = 0;  ///< TP, FP, FN
  std::int64_t judged = 0;                        ///< pairs with a probability
  FixedSum brier;
  [[nodiscard]] double precision() const;
  [[nodiscard]] double recall() const;
  void add(const RelationCounts& other);
  friend bool operator==(const RelationCounts&, const RelationCounts&) = default;
};

struct RelationScore {
  std::map<std::string, RelationCounts> clear;
  std::map<std::string, RelationCounts> borderline;
  void add(const RelationScore& other);
  friend bool operator==(const RelationScore&, const RelationScore&) = default;
};

/// A claim of probability at least `threshold` says that the relation holds. A pair that the truth
/// does not list does not hold, and is clear. Claims of a relation that the truth never lists are
/// left out (the truth does not know it). Duplicates count once.
RelationScore score_relations(std::vector<NamedRelation> truth, std::vector<NamedRelation> claims,
                              double threshold = 0.5);

}  // namespace scanchor
