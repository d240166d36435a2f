#pragma once
// Planes that grew from two seeds and are one.

#include <cstdint>
#include <vector>

#include "perception/cell_planes.hpp"

namespace scanchor {

/// Would one plane do for both? The squares may grow by what three freed parameters take up
/// (chi-square, 0.1 %) and by a tenth of the smaller one's noise, for surfaces that are no
/// mathematical planes.
bool same_plane(const GrownPlane& a, const GrownPlane& b, const BeamNoise& noise);

/// As same_plane, both pieces know their plane well enough at the other's place (half a sigma) that
/// it is no accident, and the gap between them is at most half the extent of the smaller one: for
/// pieces that do not touch, like a floor on both sides of a shadow.
bool surely_same_plane(const GrownPlane& a, const GrownPlane& b, const BeamNoise& noise);

/// The same without a bound on the gap.
bool lie_in_one_plane(const GrownPlane& a, const GrownPlane& b, const BeamNoise& noise);

/// Logarithm of the chance that two different planes, whose heights differ by up to +-12 cm and
/// whose slopes by up to +-0.12, as evenly spread, pass same_plane's test: small where both are
/// known so well that agreeing is no accident.
double log_chance_agreement(const GrownPlane& a, const GrownPlane& b);

/// Joins `pairs` (of indices into `planes`, i < j, rising) for which the test holds, the planes
/// updated as it goes. Returns for each plane the one it went into (itself: stays; always a smaller
/// number). Joined planes keep their last state.
std::vector<std::int32_t> join_planes(
    const std::vector<std::pair<std::int32_t, std::int32_t>>& pairs, const BeamNoise& noise,
    bool (*same)(const GrownPlane&, const GrownPlane&, const BeamNoise&),
    std::vector<GrownPlane>& planes);

}  // namespace scanchor
