#include "reasoning/hold_together.hpp"

#include <cmath>

namespace scanchor {

namespace {

constexpr double within_slack = 0.1;  // [m] a top lies on its frame and not in it
constexpr double end_gap = 0.3;  // [m] what shadows may leave of boards ends before their panel

bool lies_within(const Eigen::Vector3d& point, const Item& group, double slack = within_slack) {
  const Eigen::Vector3d d = point - group.center;
  return std::abs(d.dot(group.along)) <= group.half_length + slack &&
         std::abs(d.dot(group.across)) <= group.half_width + slack &&
         point.z() >= group.z_low - slack && point.z() <= group.z_high + slack;
}

bool lies_wholly_within(const Item& item, const Item& group) {
  for (const double u : {-item.half_length, item.half_length}) {
    for (const double v : {-item.half_width, item.half_width}) {
      if (!lies_within(item.center + u * item.along + v * item.across, group)) return false;
    }
  }
  return true;
}

void give(std::int32_t from, std::int32_t to, Labelling& labelling) {
  auto& entity = labelling.entities[from];
  entity.whole = to;
  for (const auto s : entity.surfaces) {
    labelling.entity_of_surface[s] = to;
    labelling.entities[to].surfaces.push_back(s);
  }
}

}  // namespace

void hold_together(const std::vector<std::int32_t>& groups, const std::vector<Item>& items,
                   const Ontology& ontology, Labelling& labelling) {
  auto& entities = labelling.entities;
  for (const auto g : groups) {
    const int c = ontology.find(entities[g].label);
    if (c < 0 || ontology.classes[c].part_of.empty()) continue;
    const std::string& whole = ontology.classes[c].part_of;
    std::vector<std::int32_t> pieces;
    std::int32_t main = g;
    for (std::size_t i = 0; i < labelling.entity_of_surface.size(); ++i) {
      const int of = ontology.find(entities[i].label);
      if (of < 0 || entities[i].whole >= 0 || !lies_within(items[i].center, items[g])) continue;
      const bool is_whole = entities[i].label == whole;
      if (!is_whole && ontology.classes[of].part_of != whole) continue;
      pieces.push_back(static_cast<std::int32_t>(i));
      if (is_whole && (main == g || entities[i].area > entities[main].area))
        main = static_cast<std::int32_t>(i);
    }
    // The boards of a shelf are a group themselves; its end stands at their edge.
    for (const auto other : groups) {
      if (other == g || entities[other].whole >= 0 || entities[other].label != whole ||
          !(lies_within(items[other].center, items[g]) ||
            lies_within(items[g].center, items[other], end_gap)))
        continue;
      pieces.push_back(other);
      if (main == g || entities[other].surfaces.size() > entities[main].surfaces.size())
        main = other;
    }
    for (const auto piece : pieces) {
      if (piece != main) give(piece, main, labelling);
    }
    if (main == g) {
      entities[g].label = whole;
      for (std::size_t i = 0; i < labelling.entity_of_surface.size(); ++i) {
        if (entities[i].whole < 0 && entities[i].label == "unknown" &&
            lies_wholly_within(items[i], items[g]))
          give(static_cast<std::int32_t>(i), g, labelling);
      }
    } else {
      give(g, main, labelling);
    }
  }
}

}  // namespace scanchor
