#pragma once
// A labelled scene as questions see it: things with all their faces, how likely each is of a class,
// and how they lie to each other.

#include <vector>

#include "perception/surface.hpp"
#include "reasoning/item.hpp"
#include "reasoning/labelling.hpp"
#include "reasoning/ontology.hpp"
#include "reasoning/relation.hpp"
#include "reasoning/scene_extent.hpp"

namespace scanchor {

class SceneThings {
 public:
  /// The labelling and the ontology must outlive it. Throws Error(bad_data) where the labelling is
  /// not of these surfaces.
  SceneThings(const Surfaces& surfaces, const Ontology& ontology, const Labelling& labelling);

  [[nodiscard]] std::int32_t size() const { return static_cast<std::int32_t>(items_.size()); }
  [[nodiscard]] const Entity& entity(std::int32_t id) const { return labelling_.entities[id]; }
  /// The main face, or the box of a group.
  [[nodiscard]] const Item& item(std::int32_t id) const { return items_[id]; }
  [[nodiscard]] const Surrounding& around() const { return around_; }
  [[nodiscard]] const Ontology& ontology() const { return ontology_; }
  /// It owns at least one surface: no side, leg or board of something else.
  [[nodiscard]] bool is_thing(std::int32_t id) const { return thing_[id] != 0; }

  /// P(it is of one of these classes), kinds counted, parts not: a leg of a chair is no chair.
  /// Members of a group that was found are of the class that it is made of. No class: any thing.
  [[nodiscard]] double probability(std::int32_t id, const std::vector<int>& classes) const;

  /// A clause about its own features.
  [[nodiscard]] Evidence own(const Clause& clause, std::int32_t id) const;
  /// A relation of `a` to `b`; 0 between a thing and its own parts. `on`, `near` and `touching`
  /// look at all faces, and `on` allows for a stand or legs that were not seen: a gap of up to 45
  /// cm to a thing that is not fixed to anything larger. A picture is on the wall that it hangs on.
  [[nodiscard]] Evidence relate(const RelationTerm& term, std::int32_t a, std::int32_t b) const;
  /// Part or member.
  [[nodiscard]] bool belongs(std::int32_t part, std::int32_t whole) const;
  /// Part or member, on it or inside of it.
  [[nodiscard]] Evidence held_by(std::int32_t what, std::int32_t holder) const;
  /// In the plan it lies in the corridor: seen from it the two are more than 120 degrees apart.
  [[nodiscard]] Evidence between(std::int32_t id, std::int32_t a, std::int32_t b) const;
  /// Shortest distance of all faces [m].
  [[nodiscard]] Evidence distance(std::int32_t a, std::int32_t b) const;

 private:
  [[nodiscard]] std::vector<std::int32_t> faces(std::int32_t id) const;
  [[nodiscard]] Evidence stands_on(std::int32_t a, std::int32_t b) const;
  [[nodiscard]] Evidence hangs_on(std::int32_t a, std::int32_t b) const;
  [[nodiscard]] double fixed_to_something(std::int32_t id) const;

  const Ontology& ontology_;
  const Labelling& labelling_;
  std::vector<Item> items_;
  std::vector<Item> whole_;  ///< the same, heights and box of all faces
  std::vector<char> thing_;
  std::vector<std::vector<double>> own_probability_;  ///< of each entity and class
  Surrounding around_;
  SceneExtent extent_;
};

}  // namespace scanchor
