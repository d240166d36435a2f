#include "eval/evaluate.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace scanchor {
namespace {

// Words people use for a class of the list. Kept short on purpose: a word that fits two classes is
// in neither.
constexpr std::array<std::pair<std::string_view, std::string_view>, 30> synonyms = {{
    {"screen", "monitor"},
    {"display", "monitor"},
    {"computer screen", "monitor"},
    {"tv", "television"},
    {"tv set", "television"},
    {"fridge", "refrigerator"},
    {"couch", "sofa"},
    {"settee", "sofa"},
    {"cupboard", "cabinet"},
    {"file cabinet", "cabinet"},
    {"filing cabinet", "cabinet"},
    {"carton", "box"},
    {"parcel", "box"},
    {"bin", "waste bin"},
    {"trash can", "waste bin"},
    {"wastebasket", "waste bin"},
    {"column", "pillar"},
    {"notebook computer", "laptop"},
    {"conference table", "meeting table"},
    {"heater", "radiator"},
    {"bookshelf", "bookcase"},
    {"shelves", "shelf"},
    {"rack", "shelf"},
    {"shelving unit", "shelf"},
    {"chest of drawers", "drawer unit"},
    {"blackboard", "whiteboard"},
    {"painting", "picture"},
    {"closet", "wardrobe"},
    {"cart", "trolley"},
    {"ground", "floor"},
}};

std::optional<ClassId> exact(std::string_view word) {
  if (const auto id = find_class(word)) return id;
  for (const auto& [name, target] : synonyms) {
    if (name == word) return find_class(target);
  }
  return std::nullopt;
}

}  // namespace

std::optional<ClassId> class_of_label(std::string_view label) {
  // "standing desk" is a desk: what stands in front of the last words only narrows it down.
  while (!label.empty()) {
    if (const auto id = exact(label)) return *id == unlabelled ? std::nullopt : id;
    const auto blank = label.find(' ');
    if (blank == std::string_view::npos) break;
    label.remove_prefix(blank + 1);
  }
  return std::nullopt;
}

std::vector<ClassId> classes_of_labels(const std::vector<std::string>& labels) {
  std::vector<ClassId> classes;
  for (const auto& label : labels) {
    if (const auto id = class_of_label(label)) classes.push_back(*id);
  }
  std::sort(classes.begin(), classes.end());
  classes.erase(std::unique(classes.begin(), classes.end()), classes.end());
  return classes;
}

PointPrediction predict_points(const Surfaces& surfaces, const Labelling& labelling) {
  std::size_t count = surfaces.plane_of_point.size();
  for (const auto& surface : surfaces.surfaces) {
    if (!surface.inliers.empty())
      count = std::max<std::size_t>(count, surface.inliers.back() + std::size_t{1});
  }
  PointPrediction prediction;
  prediction.class_id.assign(count, unlabelled);
  prediction.instance.assign(count, -1);
  prediction.plane.assign(count, -1);
  prediction.confidence.assign(count, 0.0F);
  std::copy(surfaces.plane_of_point.begin(), surfaces.plane_of_point.end(),
            prediction.plane.begin());
  if (surfaces.plane_of_point.empty()) {
    for (const auto& surface : surfaces.surfaces) {
      for (const auto i : surface.inliers) prediction.plane[i] = surface.id;
    }
  }
  struct Said {
    ClassId class_id = unlabelled;
    std::int32_t instance = -1;
    float confidence = 0.0F;
  };
  std::vector<Said> said(surfaces.surfaces.size());
  for (std::size_t s = 0; s < said.size() && s < labelling.entity_of_surface.size(); ++s) {
    const std::int32_t owner = labelling.entity_of_surface[s];
    if (owner < 0 || static_cast<std::size_t>(owner) >= labelling.entities.size()) continue;
    const Entity& entity = labelling.entities[static_cast<std::size_t>(owner)];
    if (const auto id = class_of_label(entity.label)) {
      said[s] = {*id, entity.id, static_cast<float>(std::clamp(entity.probability, 0.0, 1.0))};
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    const std::int32_t s = prediction.plane[i];
    if (s < 0 || static_cast<std::size_t>(s) >= said.size()) continue;
    const Said& answer = said[static_cast<std::size_t>(s)];
    prediction.class_id[i] = answer.class_id;
    prediction.instance[i] = answer.instance;
    prediction.confidence[i] = answer.confidence;
  }
  return prediction;
}

}  // namespace scanchor
