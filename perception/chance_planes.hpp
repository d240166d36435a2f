#pragma once
// Points without any order have planes by chance. Whether a plane is more than that is asked a
// contrario: A. Desolneux, L. Moisan and J.-M. Morel, "Meaningful alignments", IJCV 40, 2000.

#include "perception/cell_planes.hpp"

namespace scanchor {

/// Logarithm of a bound on the probability that of `total` points at least `inside` lie in a part
/// of the room for them that is `share` of it (W. Hoeffding, JASA 58, 1963). 0 where they are no
/// more than that.
double log_chance(double inside, double total, double share);

/// Takes the labels off planes that would be expected by chance: over its own footprint a slab
/// three times as thick must not hold points as if they were spread through it; its fuller side
/// counts for both. The same is asked of the middle half of the slab, so that a second sheet close
/// behind is not held against the first. The largest plane
/// first; points of planes that stand are explained and speak against no other. Less than one false
/// plane is expected in a cloud, for as many trials as the tree has cells.
void drop_chance_planes(const CanonicalCloud& cloud, const CellTree& tree, PlaneLabels& labels);

}  // namespace scanchor
