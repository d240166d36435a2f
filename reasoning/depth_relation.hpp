#pragma once
// How far something stands behind the plane of another, seen from the sensor: a pane in the
// thickness of its wall, the back of an alcove.

#include "reasoning/item.hpp"
#include "reasoning/ontology.hpp"
#include "reasoning/relation.hpp"

namespace scanchor {

/// Likelihood that the middle of `a` lies within the term's range [m] behind the plane of `b`, with
/// the two turned by at most 20 degrees: a sash stands ajar, a neighbouring wall does not count.
/// What hangs on a wall lies before its plane and has a negative depth. The deviation is that of
/// both planes, of b's direction over the way from its middle, and 5 % of the limit or 1 cm.
/// Without a position to look from neither yes nor no (0.5): a plane has no front then.
Evidence set_back_relation(const RelationTerm& term, const Item& a, const Item& b,
                           const Surrounding& around);

}  // namespace scanchor
