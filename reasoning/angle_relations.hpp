#pragma once
// Relations of directions: parallel, orthogonal, horizontal, vertical.

#include "core/math.hpp"
#include "reasoning/relation.hpp"

namespace scanchor {

/// [rad] of "parallel" and "orthogonal".
inline constexpr double angle_tolerance = radians(5.0);

/// Between lines, 0 .. pi / 2 [rad].
double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// P(the angle is within 5 degrees of 0, of 90), given how it was measured and how often faces of
/// rooms are parallel, at right angles, or anything: things that are nearly parallel mostly are
/// parallel, and a strip whose direction is hardly known is so as often as any.
Evidence parallel_relation(const Item& a, const Item& b,
                           const RelationModel& model = relation_model());
Evidence orthogonal_relation(const Item& a, const Item& b,
                             const RelationModel& model = relation_model());

}  // namespace scanchor
