#pragma once
// Between which values a clause holds: what "why not" and the closest miss of a question name.

#include <cmath>

#include "reasoning/ontology.hpp"

namespace scanchor {

/// In the unit of the clause's evidence; open where no one number decides.
struct Limits {
  double low = -INFINITY;
  double high = INFINITY;
};

Limits limits_of(const RelationTerm& term);
/// Of a clause without a target; open for relations and negations.
Limits limits_of(const Clause& clause);

}  // namespace scanchor
