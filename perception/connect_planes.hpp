#pragma once
// One surface hangs together as far as the sensor could see: what lies in one plane but has a view
// through between is two things, and what a nearer thing covers may be one.

#include "perception/beam_grid.hpp"
#include "perception/cell_planes.hpp"

namespace scanchor {

/// Splits planes where beams passed between their pieces, and joins pieces of one plane between
/// which every beam met something nearer. Pieces of fewer than `fewest` points that hang on nothing
/// lose their label. `grid`: of the same cloud and sensor.
void connect_planes(const CanonicalCloud& cloud, const BeamGrid& grid, const BeamNoise& noise,
                    std::size_t fewest, PlaneLabels& labels);

}  // namespace scanchor
