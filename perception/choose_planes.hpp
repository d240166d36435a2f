#pragma once
// The last word at the level of points: each point of the pool chooses between the planes around
// it.

#include "perception/point_pool.hpp"

namespace scanchor {

/// `label`: plane of each pool point, -1 none; `fixed`: moments of the points that do not choose, a
/// plane. A point takes the plane with the least   r^2 / (2 s^2) + ln s - ln(votes)   among those
/// within 3 s, where r is its distance, s the plane's scatter and the votes are the points in its
/// own and the neighbouring leaves that chose it before: iterated conditional modes (J. Besag, "On
/// the statistical analysis of dirty pictures", JRSS B 48, 1986). After each round the planes
/// follow their points.
void choose_planes(const PointPool& pool, const BeamNoise& noise, const std::vector<Moments>& fixed,
                   int rounds, std::vector<GrownPlane>& planes, std::vector<std::int32_t>& label);

}  // namespace scanchor
