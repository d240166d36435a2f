#pragma once
// Answers held against the truth.

#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "perception/surface.hpp"
#include "reasoning/labelling.hpp"
#include "scenes/scene.hpp"
#include "sensors/scan.hpp"

namespace scanchor {

/// A prediction for one scan, whoever made it: one row a point of the scan, in the scan's order.
struct PointPrediction {
  std::vector<std::int32_t> class_id;    ///< ClassId; unlabelled where nothing is said
  std::vector<std::int32_t> instance;    ///< any number that is the same within a thing; -1: none
  std::vector<std::int32_t> plane;       ///< any number that is the same within a plane; -1: none
  std::vector<float> confidence;         ///< [0, 1] of the instance; empty: 1
};

/// Our own answer as rows: class names of the ontology are mapped to the class list by name and synonym.
PointPrediction predict_points(const Surfaces& surfaces, const Labelling& labelling);

}  // namespace scanchor
