#pragma once
// Which plane a point is on, as its neighbours see it: under noise as large as the step between two
// planes a distance alone cannot say, but what the sensor saw beside each other mostly is one.

#include "perception/beam_grid.hpp"
#include "perception/cell_planes.hpp"

namespace scanchor {

/// Each point whose beam lies next to one on another plane, or on none, chooses again between the
/// planes beside it and its own: half the squared distance in its scatter, the logarithm of that
/// scatter, and one less for each neighbour on that plane (iterated conditional modes of a Potts
/// model; Besag, J. R. Stat. Soc. B 48, 1986). Beyond three scatters it is on none. Three rounds;
/// then planes that won or lost points follow them.
void smooth_planes(const CanonicalCloud& cloud, const BeamGrid& grid, PlaneLabels& labels,
                   const BeamNoise& noise);

}  // namespace scanchor
