#include "reasoning/assign.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "reasoning/background.hpp"
#include "reasoning/proof.hpp"

namespace scanchor {

namespace {

constexpr double negligible = 1e-4;

bool is_ancestor(const Ontology& ontology, int ancestor, int c) {
  for (std::size_t steps = 0; c >= 0 && steps <= ontology.classes.size(); ++steps) {
    if (c == ancestor) return true;
    const auto& parent = ontology.classes[c].parent;
    c = parent.empty() ? -1 : ontology.find(parent);
  }
  return false;
}

bool related(const Ontology& ontology, const std::string& a, const std::string& b) {
  const int i = ontology.find(a);
  const int j = ontology.find(b);
  return i >= 0 && j >= 0 && (is_ancestor(ontology, i, j) || is_ancestor(ontology, j, i));
}

struct Scored {
  int class_index;
  double score;
};

/// p(c|e) = exp S_c / (pi_0 + sum exp S_k), reasoning.md 2.4; a class's probability includes that of its kinds.
void distribute(Entity& entity, const std::vector<Scored>& scored, const Ontology& ontology, double applies) {
  const double unknown = std::log(unknown_prior_of(ontology));
  double top = unknown;
  for (const auto& s : scored) top = std::max(top, s.score);
  double sum = std::exp(unknown - top);
  for (const auto& s : scored) sum += std::exp(s.score - top);
  std::map<int, double> mass;
  double known = 0.0;
  for (const auto& s : scored) {
    const double p = applies * std::exp(s.score - top) / sum;
    known += p;
    int c = s.class_index;
    for (std::size_t steps = 0; c >= 0 && steps <= ontology.classes.size(); ++steps) {
      mass[c] += p;
      const auto& parent = ontology.classes[c].parent;
      c = parent.empty() ? -1 : ontology.find(parent);
    }
  }
  for (const auto& [c, p] : mass) {
    if (p > negligible) entity.classes.push_back({ontology.classes[c].name(), std::min(1.0, p)});
  }
  entity.classes.push_back({"unknown", std::max(0.0, 1.0 - known)});
  std::stable_sort(entity.classes.begin(), entity.classes.end(),
                   [](const auto& a, const auto& b) { return a.probability > b.probability; });
}

/// `unique` classes go to the entity that is most likely one; the others have to be something else.
void keep_unique(std::vector<std::vector<Scored>>& scored, const Ontology& ontology) {
  for (std::size_t c = 0; c < ontology.classes.size(); ++c) {
    if (!ontology.classes[c].unique) continue;
    std::size_t best = scored.size();
    double best_score = -INFINITY;
    const auto of = [&](std::size_t i) {
      return std::find_if(scored[i].begin(), scored[i].end(),
                          [&](const Scored& s) { return s.class_index == static_cast<int>(c); });
    };
    for (std::size_t i = 0; i < scored.size(); ++i) {
      const auto at = of(i);
      if (at != scored[i].end() && at->score > best_score) {
        best_score = at->score;
        best = i;
      }
    }
    for (std::size_t i = 0; i < scored.size(); ++i) {
      const auto at = of(i);
      if (i != best && at != scored[i].end()) scored[i].erase(at);
    }
  }
}

}  // namespace

Entity make_entity(const Item& item, const Eigen::Matrix3d& R) {
  Entity entity;
  entity.id = item.id;
  entity.members = item.members;
  if (!item.group) entity.surfaces = {item.id};
  entity.center = R * item.center;
  entity.normal = R * item.normal;
  entity.area = item.area.value;
  // Sides of the box, longest first, as a right-handed frame.
  const Eigen::Vector3d third = item.along.cross(item.across);
  struct Side {
    double length;
    Eigen::Vector3d axis;
  };
  std::array<Side, 3> sides = {{{2.0 * item.half_length, item.along},
                                {2.0 * item.half_width, item.across},
                                {item.group ? item.z_high - item.z_low : 0.0, third}}};
  std::stable_sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.length > b.length; });
  Eigen::Matrix3d axes;
  for (int i = 0; i < 3; ++i) {
    entity.size[i] = sides[i].length;
    axes.col(i) = sides[i].axis;
  }
  if (axes.determinant() < 0.0) axes.col(2) = -axes.col(2);
  entity.pose.linear() = R * axes;
  entity.pose.translation() = entity.center;
  return entity;
}

void decide(Entity& entity, const Ontology& ontology, const ReasonOptions& options) {
  entity.label = "unknown";
  entity.probability = 0.0;
  for (const auto& c : entity.classes) {
    if (c.name == "unknown") entity.probability = c.probability;
  }
  // The most specific class that is likely enough (reasoning.md 2.7).
  const ClassProbability* best = nullptr;
  for (const auto& c : entity.classes) {
    if (c.name == "unknown") continue;
    const bool more_specific = best != nullptr && c.probability >= options.report_probability &&
                               is_ancestor(ontology, ontology.find(best->name), ontology.find(c.name));
    if (best == nullptr || more_specific) best = &c;
  }
  if (best == nullptr) return;
  const ClassProbability* rival = nullptr;
  for (const auto& c : entity.classes) {
    if (c.name == "unknown" || related(ontology, c.name, best->name)) continue;
    if (rival == nullptr || c.probability > rival->probability) rival = &c;
  }
  const double second = rival != nullptr ? rival->probability : 0.0;
  if (rival != nullptr && best->probability + second >= options.report_probability &&
      std::abs(best->probability - second) < options.ambiguity_margin) {
    entity.label = "ambiguous";
    entity.probability = best->probability;
    entity.also = static_cast<std::int32_t>(rival - entity.classes.data());
  } else if (best->probability >= options.report_probability) {
    entity.label = best->name;
    entity.probability = best->probability;
  }
}

void assign_labels(const Matcher& matcher, const Surfaces& surfaces, const Ontology& ontology, const ReasonOptions& options,
                   const Eigen::Matrix3d& R, double upright, Labelling& labelling) {
  const auto& items = matcher.items();
  std::vector<std::vector<Scored>> scored(items.size());
  for (std::size_t c = 0; c < ontology.classes.size(); ++c) {
    for (const auto& candidate : matcher.candidates(static_cast<int>(c))) {
      scored[candidate.item].push_back({static_cast<int>(c), candidate.score});
    }
  }
  keep_unique(scored, ontology);
  for (const auto& item : items) {
    Entity entity = make_entity(item, R);
    double applies = upright;
    if (!item.group) applies *= std::clamp(surfaces.surfaces[item.id].confidence, 0.0, 1.0);
    distribute(entity, scored[item.id], ontology, applies);
    decide(entity, ontology, options);
    const auto best = std::find_if(entity.classes.begin(), entity.classes.end(),
                                   [](const auto& c) { return c.name != "unknown"; });
    const std::string& proved = entity.label != "unknown" && entity.label != "ambiguous" ? entity.label
                                : best != entity.classes.end()                           ? best->name
                                                                                         : entity.label;
    if (const int c = ontology.find(proved); c >= 0) entity.proof = make_proof(matcher, ontology, c, item.id);
    labelling.entities.push_back(std::move(entity));
  }

  auto& entities = labelling.entities;
  labelling.entity_of_surface.resize(matcher.surface_count());
  for (std::size_t i = 0; i < matcher.surface_count(); ++i) labelling.entity_of_surface[i] = static_cast<std::int32_t>(i);

  // Groups that are what they seem own their members; a member of two goes to the likelier group.
  std::vector<std::int32_t> groups;
  for (const auto& item : items) {
    const int c = ontology.find(entities[item.id].label);
    if (item.group && c >= 0) groups.push_back(item.id);
  }
  std::stable_sort(groups.begin(), groups.end(), [&](std::int32_t a, std::int32_t b) {
    return entities[a].probability != entities[b].probability ? entities[a].probability > entities[b].probability
                                                              : entities[a].members.size() > entities[b].members.size();
  });
  for (const auto g : groups) {
    const bool free = std::all_of(entities[g].members.begin(), entities[g].members.end(),
                                  [&](std::int32_t m) { return entities[m].whole < 0; });
    if (!free) {
      entities[g].label = "unknown";
      continue;
    }
    for (const auto m : entities[g].members) {
      entities[m].whole = g;
      labelling.entity_of_surface[m] = g;
      entities[g].surfaces.push_back(m);
    }
  }

  // Parts go to their whole, the target of their first relation to it.
  for (std::size_t i = 0; i < matcher.surface_count(); ++i) {
    auto& entity = entities[i];
    const int c = ontology.find(entity.label);
    if (c < 0 || ontology.classes[c].part_of.empty() || entity.whole >= 0) continue;
    for (const auto& clause : entity.proof) {
      if (clause.target_class != ontology.classes[c].part_of || clause.targets.empty()) continue;
      const std::int32_t whole = clause.targets.front();
      if (whole == static_cast<std::int32_t>(i) || entities[whole].label != clause.target_class) continue;
      entity.whole = whole;
      labelling.entity_of_surface[i] = whole;
      entities[whole].surfaces.push_back(static_cast<std::int32_t>(i));
      break;
    }
  }

  // Faces of one thing: they meet at a right angle and are of one class that may have several faces.
  for (std::size_t i = 0; i < matcher.surface_count(); ++i) {
    const int c = ontology.find(entities[i].label);
    if (c < 0 || !ontology.classes[c].several_faces || entities[i].whole >= 0) continue;
    for (std::size_t j = i + 1; j < matcher.surface_count(); ++j) {
      if (entities[j].label != entities[i].label || entities[j].whole >= 0) continue;
      if (relate({Relation::orthogonal, {}}, items[i], items[j], {}).likelihood < 0.5) continue;
      if (relate({Relation::touching, {}}, items[i], items[j], {}).likelihood < 0.5) continue;
      entities[j].whole = static_cast<std::int32_t>(i);
      for (const auto s : entities[j].surfaces) {
        entities[i].surfaces.push_back(s);
        labelling.entity_of_surface[s] = static_cast<std::int32_t>(i);
      }
    }
  }
}

}  // namespace scanchor
