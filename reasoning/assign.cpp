#include "reasoning/assign.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

#include "reasoning/background.hpp"
#include "reasoning/faces.hpp"
#include "reasoning/hold_together.hpp"
#include "reasoning/proof.hpp"

namespace scanchor {

namespace {

constexpr double negligible = 1e-4;

bool related(const Ontology& ontology, const std::string& a, const std::string& b) {
  const int i = ontology.find(a);
  const int j = ontology.find(b);
  return i >= 0 && j >= 0 && are_akin(ontology, i, j);
}

struct Scored {
  int class_index;
  double score;
};

/// p(c|e) = exp S_c / (pi_0 + sum exp S_k), reasoning.md 2.4; a class's probability includes that
/// of its kinds and parts.
void distribute(Entity& entity, const std::vector<Scored>& scored, const Ontology& ontology,
                double applies) {
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
      c = class_above(ontology, c);
    }
  }
  for (const auto& [c, p] : mass) {
    if (p > negligible) entity.classes.push_back({ontology.classes[c].name(), std::min(1.0, p)});
  }
  entity.classes.push_back({"unknown", std::max(0.0, 1.0 - known)});
  std::stable_sort(entity.classes.begin(), entity.classes.end(),
                   [](const auto& a, const auto& b) { return a.probability > b.probability; });
}

/// Where only the parts of a class speak for it, the likeliest part is what is named: the whole's
/// own clauses do not hold here.
void name_the_part(Entity& entity, const std::vector<Scored>& scored, const Ontology& ontology) {
  if (entity.label == "unknown" || entity.label == "ambiguous") return;
  const int named = ontology.find(entity.label);
  const Scored* best = nullptr;
  for (const auto& s : scored) {
    if (s.class_index == named) return;
    if (is_ancestor(ontology, named, s.class_index) && (best == nullptr || s.score > best->score))
      best = &s;
  }
  if (best != nullptr) entity.label = ontology.classes[best->class_index].name();
}

/// Its label is taken back; what it may be stays in `classes`.
void withdraw(Entity& entity) {
  entity.label = "unknown";
  for (const auto& c : entity.classes) {
    if (c.name == "unknown") entity.probability = c.probability;
  }
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
  std::stable_sort(sides.begin(), sides.end(),
                   [](const Side& a, const Side& b) { return a.length > b.length; });
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
    if (best != nullptr && c.probability < options.report_probability) break;
    const bool more_specific =
        best != nullptr && is_ancestor(ontology, ontology.find(best->name), ontology.find(c.name));
    if (best == nullptr || more_specific) best = &c;
  }
  if (best == nullptr) return;
  const ClassProbability* rival = nullptr;
  for (const auto& c : entity.classes) {
    if (c.name == "unknown" || related(ontology, c.name, best->name)) continue;
    rival = &c;  // they are falling: the first is the likeliest
    break;
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

void assign_labels(const Matcher& matcher, const Surfaces& surfaces, const Ontology& ontology,
                   const ReasonOptions& options, const Eigen::Matrix3d& R, double upright,
                   Labelling& labelling) {
  const auto& items = matcher.items();
  std::unordered_map<std::string, int> class_of;  // looked up, never walked through
  for (std::size_t c = 0; c < ontology.classes.size(); ++c)
    class_of.emplace(ontology.classes[c].name(), static_cast<int>(c));
  const auto find = [&](const std::string& label) {
    const auto at = class_of.find(label);
    return at != class_of.end() ? at->second : -1;
  };
  std::vector<std::vector<Scored>> scored(items.size());
  for (std::size_t c = 0; c < ontology.classes.size(); ++c) {
    if (only_a_member(ontology, static_cast<int>(c))) continue;
    for (const auto& candidate : matcher.candidates(static_cast<int>(c))) {
      scored[candidate.item].push_back({static_cast<int>(c), candidate.score});
    }
  }
  keep_unique(scored, ontology);
  const auto judge = [&](Entity& entity) {
    entity.classes.clear();
    distribute(entity, scored[entity.id], ontology, upright);
    decide(entity, ontology, options);
    name_the_part(entity, scored[entity.id], ontology);
    const auto best = std::find_if(entity.classes.begin(), entity.classes.end(),
                                   [](const auto& c) { return c.name != "unknown"; });
    const bool named = entity.label != "unknown" && entity.label != "ambiguous";
    const int c = find(named || best == entity.classes.end() ? entity.label : best->name);
    entity.proof.clear();
    if (c >= 0) entity.proof = make_proof(matcher, ontology, c, entity.id);
  };
  for (const auto& item : items) {
    Entity entity = make_entity(item, R);
    if (!item.group) {
      // A bent surface speaks against every flat thing, by at most four to one: floors of real
      // scans are a little bent too.
      const double bent =
          std::log(0.25 + 0.75 * std::clamp(surfaces.surfaces[item.id].confidence, 0.0, 1.0));
      for (auto& s : scored[item.id]) s.score += bent;
    }
    judge(entity);
    labelling.entities.push_back(std::move(entity));
  }

  auto& entities = labelling.entities;
  labelling.entity_of_surface.resize(matcher.surface_count());
  for (std::size_t i = 0; i < matcher.surface_count(); ++i)
    labelling.entity_of_surface[i] = static_cast<std::int32_t>(i);

  // Groups that are what they seem own their members; a member of two goes to the likelier group.
  std::vector<std::int32_t> groups;
  for (const auto& item : items) {
    const int c = find(entities[item.id].label);
    if (item.group && c >= 0) groups.push_back(item.id);
  }
  std::stable_sort(groups.begin(), groups.end(), [&](std::int32_t a, std::int32_t b) {
    return entities[a].probability != entities[b].probability
               ? entities[a].probability > entities[b].probability
               : entities[a].members.size() > entities[b].members.size();
  });
  std::vector<std::int32_t> owners;
  for (const auto g : groups) {
    const bool free = std::all_of(entities[g].members.begin(), entities[g].members.end(),
                                  [&](std::int32_t m) { return entities[m].whole < 0; });
    // What speaks for its members being something else by themselves speaks against the group.
    double alone = 0.0;
    for (const auto m : entities[g].members) {
      if (find(entities[m].label) >= 0 && !related(ontology, entities[m].label, entities[g].label))
        alone += entities[m].probability / static_cast<double>(entities[g].members.size());
    }
    if (!free || alone > entities[g].probability) {
      withdraw(entities[g]);
      continue;
    }
    for (const auto m : entities[g].members) {
      entities[m].whole = g;
      labelling.entity_of_surface[m] = g;
      entities[g].surfaces.push_back(m);
    }
    owners.push_back(g);
  }
  hold_together(owners, items, ontology, labelling);

  // Parts go to their whole, the target of their first relation to it. What finds none is no such
  // part: it is judged again without that class.
  const auto join_whole = [&](Entity& entity, int c) {
    for (const auto& clause : entity.proof) {
      if (clause.target_class != ontology.classes[c].part_of || clause.targets.empty()) continue;
      const std::int32_t whole = clause.targets.front();
      if (whole == entity.id || entities[whole].label != clause.target_class ||
          !part_fits(matcher, find(clause.target_class), whole, entity.id))
        continue;
      entity.whole = whole;
      labelling.entity_of_surface[entity.id] = whole;
      entities[whole].surfaces.push_back(entity.id);
      return true;
    }
    return false;
  };
  std::vector<std::pair<std::size_t, int>> orphans;
  do {
    orphans.clear();
    for (std::size_t i = 0; i < matcher.surface_count(); ++i) {
      const int c = find(entities[i].label);
      if (c < 0 || ontology.classes[c].part_of.empty() || entities[i].whole >= 0) continue;
      if (!join_whole(entities[i], c)) orphans.emplace_back(i, c);
    }
    for (const auto& [i, c] : orphans) {
      std::erase_if(scored[i], [&](const Scored& s) { return s.class_index == c; });
      judge(entities[i]);
    }
  } while (!orphans.empty());

  gather_faces(matcher, ontology, labelling);
}

}  // namespace scanchor
