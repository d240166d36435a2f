#pragma once
// One scene as the report's 3D view reads it.

#include <string>

#include "perception/surface.hpp"
#include "reasoning/labelling.hpp"
#include "scenes/scene.hpp"
#include "sensors/scan.hpp"

namespace scanchor {

/// JSON text (docs/reference/report.md#scene): a sample of the points with true and said class, the
/// surfaces as triangles, the entities with probabilities and proof. Integers in millimetres,
/// turned so that the labelling's up is z. `scan` may carry no truth. `most_points`: an even sample
/// of at most that many.
std::string report_scene(const std::string& name, const Scan& scan, const Surfaces& surfaces,
                         const Labelling& labelling, std::size_t most_points);

}  // namespace scanchor
