#pragma once
// Relations of one thing over another: above, on; and how far things go on where they were not
// seen.

#include "reasoning/relation.hpp"

namespace scanchor {

/// Deviation [m] of a difference in height: the up direction is only known to up_sigma.
double height_sigma(const Item& a, const Item& b, const Surrounding& around);

/// How likely a side of a surface is farther out than it was seen, by `beyond` [m] or more; `side`
/// as in Item::open, `length`: of the surface in that direction. Where its outline ends in a
/// shadow, most go on, by about half of what was seen of them; where it ends in the open, a few
/// still do, since thin ends and dark corners give no points.
double goes_on(const Item& item, int side, double length, double beyond,
               const RelationModel& model = relation_model());

/// Height of b below a: of its plane there, since the middle of a floor that leans by a hair is
/// higher or lower. Its upper end where it is not level.
double top_under(const Item& b, const Item& a);

/// Share of a's footprint that lies over b's, b dilated by 5 cm: as in the exact relations of a
/// scene, where upright faces have a footprint 6 cm thick. Footprints of items are dilated by half
/// of 5 cm.
double share_over(const Item& a, const Item& b);

/// [m] between the boxes in the plan, along the axis where they are farther apart; 0: overlap.
double plan_gap(const Item& a, const Item& b);
/// [m] Boxes further apart than that have no footprint in common.
inline constexpr double overlap_thickening = 0.2;
/// Above, below, on and supports are 0 where plan_gap exceeds this: overlap_thickening, or longer
/// where the lower thing may go on in a shadow.
double overlap_reach(const Item& lower);

Evidence above_relation(const Item& a, const Item& b, const Surrounding& around);
Evidence on_relation(const Item& a, const Item& b, const Surrounding& around);
}  // namespace scanchor
