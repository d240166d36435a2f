#pragma once
// A room of a floor, a desk and a cabinet, "scanned" by putting points on the faces: no ray is
// traced, every number is known.

#include "eval/truth.hpp"
#include "perception/surface.hpp"
#include "scenes/scene.hpp"
#include "sensors/scan.hpp"

namespace scanchor {

struct SmallScan {
  Scene scene;
  Scan scan;
};

/// The sensor stands at (0, -2, 1.5) and looks along y; faces that look towards it get points on a
/// grid of 4 cm. Instances: 1 floor, 2 desk, 3 cabinet, 4 a cup that has 4 points only.
SmallScan small_scan();

/// Surfaces with the inliers of the truth's planes, largest first, plane parameters as in the
/// truth.
Surfaces true_surfaces(const Scan& scan, const ScanTruth& truth);

}  // namespace scanchor
