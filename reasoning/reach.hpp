#pragma once
// How far a target may be for a relation that needs nearness.

#include "reasoning/item.hpp"
#include "reasoning/ontology.hpp"

namespace scanchor {

struct RelationModel;

/// True where a relation that needs nearness is certainly 0, from the boxes alone. 1.5 m is beyond
/// eight standard deviations of every default distance for things whose size is known to 10 cm;
/// others are left to the relation itself.
bool out_of_reach(const Clause& clause, const Item& a, const Item& b);

/// [m] Targets farther from a's box than this, in plan and along one of its axes, are out of reach,
/// unless they reach far; infinity: nothing is.
double reach_of(const Clause& clause, const Item& a);

/// May be in reach of what lies farther away: its ends are not known, or it goes on unseen.
bool reaches_far(const Item& target);

/// No less than the product of a clause's relations; by boxes alone, so that most of what is too
/// far to be the best target need not be measured. What is not near yet may be said to be, where
/// it may go on unseen: at most RelationModel::near_meets.
double at_most(const Clause& clause, const Item& a, const Item& b, const RelationModel& model);

}  // namespace scanchor
