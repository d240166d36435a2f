#pragma once
// How far a target may be for a relation that needs nearness.

#include "reasoning/item.hpp"
#include "reasoning/ontology.hpp"

namespace scanchor {

/// True where a relation that needs nearness is certainly 0, from the boxes alone. 1.5 m is beyond
/// eight standard deviations of every default distance for things whose size is known to 10 cm;
/// others are left to the relation itself.
bool out_of_reach(const Clause& clause, const Item& a, const Item& b);

/// [m] Targets farther from a's box than this, in plan and along one of its axes, are out of reach,
/// unless they reach far; infinity: nothing is.
double reach_of(const Clause& clause, const Item& a);

/// May be in reach of what lies farther away: its ends are not known, or it goes on unseen.
bool reaches_far(const Item& target);

}  // namespace scanchor
