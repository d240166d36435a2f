#pragma once
// Counting, on training scenes, how often each clause holds and what it adds: `scanchor fit`.

#include <string>
#include <vector>

#include "perception/surface.hpp"
#include "reasoning/background.hpp"
#include "reasoning/ontology.hpp"
#include "reasoning/reason.hpp"

namespace scanchor {

class Matcher;
struct Item;

/// One training scene: what was perceived, and by somebody who may know, what each surface truly
/// is.
struct TrainingScene {
  Surfaces surfaces;
  std::vector<std::string>
      classes;  ///< true class name of each surface; "" for surfaces that are of no single thing
};

/// A book among the boards makes no other thing of a shelf: the name of more than half of the area
/// of a group's members, of the `classes` of surfaces; "" where there is none.
std::string name_of_most(const Matcher& matcher, const Item& group,
                         const std::vector<std::string>& classes);

/// Hit rate, background and weight of every clause, and priors (fit_weights.hpp). `fitted_on`:
/// stored as it is, say which suite and which seeds. Deterministic; scenes are taken in their
/// order. A class is taught by surfaces whose true name is one of its names; a part by those of its
/// whole that meet its own features; a group by what most of its members' area is. Classes without
/// examples stay near their default rates, weights of one half and a prior of one in a thousand
/// surfaces. Throws Error(bad_data): a scene whose `classes` and surfaces differ in number, no
/// scene at all.
Background fit_backgrounds(const Ontology& ontology, const std::vector<TrainingScene>& scenes,
                           const ReasonOptions& options, const std::string& fitted_on);

}  // namespace scanchor
