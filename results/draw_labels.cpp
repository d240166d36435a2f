#include "results/draw_labels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "eval/evaluate.hpp"
#include "results/draw_surfaces.hpp"

namespace scanchor {
namespace {

bool is_named(const Entity& entity) {
  return !entity.label.empty() && entity.label != "unknown" && entity.label != "ambiguous";
}

bool is_stuff(const std::string& label) {
  const std::optional<ClassId> id = class_of_label(label);
  return id && !class_info(*id).thing;
}

const Entity* owner_of(const Labelling& labelling, std::size_t surface) {
  if (surface >= labelling.entity_of_surface.size()) return nullptr;
  const std::int32_t entity = labelling.entity_of_surface[surface];
  if (entity < 0 || std::size_t(entity) >= labelling.entities.size()) return nullptr;
  return &labelling.entities[std::size_t(entity)];
}

void add_relations(Drawing& drawing, const Labelling& labelling, const Entity& entity,
                   bool stuff_too) {
  for (const ProofClause& clause : entity.proof) {
    // A clause may hold on many things ("parallel to the other boards"): the nearest stands for
    // them.
    const Entity* nearest = nullptr;
    for (const std::int32_t target : clause.targets) {
      if (target < 0 || std::size_t(target) >= labelling.entities.size()) continue;
      const Entity& other = labelling.entities[std::size_t(target)];
      if (!stuff_too && is_stuff(other.label)) continue;
      if (nearest == nullptr ||
          (other.center - entity.center).norm() < (nearest->center - entity.center).norm()) {
        nearest = &other;
      }
    }
    if (nearest == nullptr || nearest->id == entity.id) continue;
    drawing.arrows.push_back({entity.center, nearest->center,
                              mix(color_of_label(entity.label), ink, 0.35), 1.6,
                              fmt::format("{} {:.2f}", clause.text, clause.likelihood)});
  }
}

}  // namespace

Color color_of_label(const std::string& label) {
  if (label.empty() || label == "unknown" || label == "ambiguous") return color_of_number(-1);
  if (const std::optional<ClassId> id = class_of_label(label)) return color_of_class(*id);
  std::uint32_t hash = 2166136261U;  // FNV-1a
  for (const char c : label)
    hash = (hash ^ std::uint32_t(static_cast<unsigned char>(c))) * 16777619U;
  return palette(hash % 21U);
}

std::string label_text(const Entity& entity) {
  return fmt::format("{} {:.2f}", entity.label, entity.probability);
}

Drawing draw_labels(const Surfaces& surfaces, const Labelling& labelling,
                    const DrawLabelsOptions& options) {
  DrawSurfacesOptions shape_options;
  shape_options.rectangles = false;
  shape_options.occlusion = false;
  shape_options.towards_eye = options.towards_eye;
  for (std::size_t s = 0; s < surfaces.surfaces.size(); ++s) {
    const Entity* owner = owner_of(labelling, s);
    const bool named = owner != nullptr && is_named(*owner);
    // What has no name stays in the background.
    shape_options.colors.push_back(named ? color_of_label(owner->label) : Color{206, 212, 218});
  }
  shape_options.opacity = options.opacity;
  Drawing drawing = draw_surfaces(surfaces, shape_options);

  std::map<std::string, std::size_t> counts;
  std::vector<bool> owns(labelling.entities.size(), false);
  std::vector<bool> seen(labelling.entities.size(), false);
  for (std::size_t s = 0; s < surfaces.surfaces.size(); ++s) {
    const Entity* owner = owner_of(labelling, s);
    if (owner == nullptr) continue;
    owns[std::size_t(owner->id)] = true;
    if (!turned_away(surfaces.surfaces[s], options.towards_eye))
      seen[std::size_t(owner->id)] = true;
  }
  for (const Entity& entity : labelling.entities) {
    if (!owns[std::size_t(entity.id)]) continue;
    const bool named = is_named(entity);
    ++counts[named ? entity.label : "unknown"];
    if (!seen[std::size_t(entity.id)]) continue;
    const Color color = color_of_label(entity.label);
    if (options.groups && entity.members.size() > 1 && named) {
      DrawnLines box;
      box.color = mix(color, ink, 0.25);
      box.width_px = 1.8;
      add_box_lines(box, entity.pose, entity.size);
      drawing.lines.push_back(std::move(box));
    }
    if (options.names &&
        (named ? options.stuff_names || !is_stuff(entity.label) : options.unknown)) {
      drawing.labels.push_back({entity.center, label_text(entity), color,
                                named ? 1.0 + entity.probability : 0.0, entity.size.maxCoeff()});
    }
    if (named && (options.relations_of == -2 || options.relations_of == entity.id)) {
      add_relations(drawing, labelling, entity, options.relations_of >= 0);
    }
  }
  std::vector<std::pair<std::string, std::size_t>> order(counts.begin(), counts.end());
  std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) {
    return (a.first == "unknown") != (b.first == "unknown") ? b.first == "unknown"
                                                            : a.second > b.second;
  });
  for (const auto& [label, count] : order) {
    drawing.legend.push_back({fmt::format("{} ({})", label, count), color_of_label(label)});
  }
  drawing.legend_title = "labels";
  return drawing;
}

}  // namespace scanchor
