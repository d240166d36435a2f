#pragma once
// Scores as a person reads them.

#include <string>
#include <vector>

#include "apps/command.hpp"
#include "eval/score.hpp"

namespace scanchor::apps {

/// Class, there, found, missed, wrong, precision and recall, with a line for the sum; what did not
/// count below.
void print_objects(const Common& common, const ObjectScore& score);

/// Relations between planes, clear and borderline cases apart; nothing where none were scored.
void print_relations(const Common& common, const RelationScore& score);

/// The metrics without those by class, then the table above.
void print_score(const Common& common, const Score& score, const Protocol& protocol);

struct MethodScore {
  std::string name;
  Score score;
  double seconds = 0;  ///< of the method itself, over all scans
  std::string cost;    ///< time by stage and memory in words; empty: not measured
};

/// Several methods on the same scans, one a line.
void print_methods(const Common& common, const std::vector<MethodScore>& methods,
                   const Protocol& protocol);

}  // namespace scanchor::apps
