#pragma once
// Boards and pictures hang so close before a wall that each of their points could be the wall's:
// two centimetres at a centimetre of noise. Only the mean of many tells them apart.

#include "perception/cell_planes.hpp"

namespace scanchor {

/// Splits a sheet off a plane where a connected part of it lies before or behind the rest by a step
/// of at least one scatter of the plane: two planes must explain the means over small squares
/// better than one (chi-square, 0.1 %, and a bit for each square of the border), leave nothing but
/// noise around the border, and the step must be taken within a few squares. A bend, however high,
/// rises slowly and stays in one plane. Planes that parted the points of one by their noise, so
/// that their squares are as high as one plane, become one. Labels follow; new planes are appended,
/// and those that lost all their points have empty moments.
void split_sheets(const CanonicalCloud& cloud, PlaneLabels& labels, const BeamNoise& noise);

}  // namespace scanchor
