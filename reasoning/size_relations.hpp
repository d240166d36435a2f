#pragma once
// Relations that compare sizes and middles: same size, vertically aligned.

#include "reasoning/relation.hpp"

namespace scanchor {

/// P(the ratio of the longer sides is at most 1.15 and that of the areas 1.25).
/// Rooms hold many things of one make, of exactly one size; others have any.
Evidence same_size_relation(const Item& a, const Item& b, const RelationModel& model);

/// P(the middles are no farther apart in the plan than 0.15 of the smaller
/// longer side, 5 cm or more in height, and long things lie parallel). Stacked
/// things have their middles on one line and parallel sides, exactly; of others
/// the middles are anywhere.
Evidence aligned_relation(const Item& a, const Item& b, const RelationModel& model);

}  // namespace scanchor
