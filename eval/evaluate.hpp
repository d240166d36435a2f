#pragma once
// Answers held against the truth.

#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "perception/surface.hpp"
#include "reasoning/labelling.hpp"
#include "scenes/scene.hpp"
#include "sensors/scan.hpp"

namespace scanchor {

/// A prediction for one scan, whoever made it: one row a point of the scan, in the scan's order.
struct PointPrediction {
  std::vector<std::int32_t> class_id;  ///< ClassId; unlabelled where nothing is said
  std::vector<std::int32_t> instance;  ///< any number that is the same within a thing; -1: none
  std::vector<std::int32_t> plane;     ///< any number that is the same within a plane; -1: none
  std::vector<float> confidence;       ///< [0, 1] of the instance; empty: 1
};

/// Our own answer as rows: class names of the ontology are mapped to the class list by name and
/// synonym. The instance is the entity's id; points of surfaces that have no named entity are
/// unlabelled. Works from the inliers of the surfaces and, where those were not kept, from
/// plane_of_point.
PointPrediction predict_points(const Surfaces& surfaces, const Labelling& labelling);

/// The class that a word of a class file means: the class of that name, else of a synonym (screen:
/// monitor), else of the word's head
/// ("standing desk": desk). Nothing for "unknown", "ambiguous" and words for parts (board, seat).
std::optional<ClassId> class_of_label(std::string_view label);

/// The classes that a list of words can say, rising, each once: `described` of summarize_objects.
std::vector<ClassId> classes_of_labels(const std::vector<std::string>& labels);

}  // namespace scanchor
