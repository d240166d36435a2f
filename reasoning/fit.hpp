#pragma once
// Counting, on training scenes, how often each clause holds: `scanchor fit`.

#include <string>
#include <vector>

#include "perception/surface.hpp"
#include "reasoning/background.hpp"
#include "reasoning/ontology.hpp"
#include "reasoning/reason.hpp"

namespace scanchor {

/// One training scene: what was perceived, and by somebody who may know, what each surface truly
/// is.
struct TrainingScene {
  Surfaces surfaces;
  std::vector<std::string>
      classes;  ///< true class name of each surface; "" for surfaces that are of no single thing
};

/// Hit rate and background of every clause, priors, and the temperature that makes the labels'
/// probabilities calibrated. `fitted_on`: stored as it is, say which suite and which seeds.
/// Deterministic; scenes are taken in their order. A class is taught by surfaces whose true name is
/// one of its names; a part by those of its whole that meet its own features; a group by its
/// members. Classes without examples keep their default rates and a prior of one in a thousand
/// surfaces. Throws Error(bad_data): a scene whose `classes` and surfaces differ in number, no
/// scene at all.
Background fit_backgrounds(const Ontology& ontology, const std::vector<TrainingScene>& scenes,
                           const ReasonOptions& options, const std::string& fitted_on);

}  // namespace scanchor
