#pragma once
// Anybody's regions of points as surfaces: how the truth's own planes and those of other libraries
// come to the stages behind ours.

#include <cstdint>
#include <functional>
#include <vector>

#include "eval/run.hpp"
#include "perception/perceive.hpp"

namespace scanchor {

/// Region of each point of the cloud, -1: none. `sigma` [m]: range noise, given or estimated.
using PlaneFinder = std::function<std::vector<std::int32_t>(const PointCloud& cloud, double sigma)>;

/// What find_planes would return had it found those regions: the same points set aside, the same
/// estimates of noise and spacing, the same fit, order and confidence.
Surfaces surfaces_of_regions(const PointCloud& cloud, const PerceiveOptions& options,
                             const PlaneFinder& finder);

/// A method whose planes are somebody else's; shapes and labels are ours, so that only the planes
/// differ.
Method peer_method(const std::string& name, PlaneFinder finder, const PerceiveOptions& perceive,
                   const Ontology& ontology, const ReasonOptions& reason);

}  // namespace scanchor
