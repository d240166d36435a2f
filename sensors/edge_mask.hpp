#pragma once
// Which beams can have an edge in their footprint: only their sub-rays need tracing.

#include <Eigen/Geometry>
#include <cstdint>
#include <span>
#include <vector>

#include "sensors/kinematics.hpp"
#include "sensors/line_returns.hpp"

namespace scanchor {

/// One byte a beam, lines x beams_per_line, 1 where the footprint may straddle two surfaces. Errs
/// on the side of 1:
/// * the outlines of all faces are drawn into the grid of beams, hidden ones too, as wide as the
/// footprint reaches;
/// * where neighbouring middles met different faces (bodies that go through each other have a
/// crease without an outline), both and
///   all beams within reach are marked.
/// A moving robot has no common viewpoint: then all beams are marked. So they are where tracing all
/// their sub-rays costs less than drawing the outlines (few beams, close together, in a full room).
/// `reach` [half diameters] of the farthest sub-ray. `lines` are the middles as traced.
std::vector<std::uint8_t> straddling_beams(const World& world,
                                           const Eigen::Isometry3d& T_world_sensor,
                                           const LidarOptions& options,
                                           const Kinematics& kinematics, double reach,
                                           std::span<const LineReturns> lines);

}  // namespace scanchor
