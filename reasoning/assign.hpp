#pragma once
// From scores to labels: one probability distribution an entity, then what belongs together becomes
// one thing.

#include "reasoning/labelling.hpp"
#include "reasoning/matcher.hpp"
#include "reasoning/reason.hpp"

namespace scanchor {

/// Fills `entities` and `entity_of_surface`. `R_cloud_level` turns the items' frame back into the
/// cloud's; `upright` in [0, 1] is the probability that the description applies at all: the rest
/// goes to "unknown". A low confidence of a surface counts against all classes, by at most four to
/// one.
void assign_labels(const Matcher& matcher, const Surfaces& surfaces, const Ontology& ontology,
                   const ReasonOptions& options, const Eigen::Matrix3d& R_cloud_level,
                   double upright, Labelling& labelling);

/// The entity without a label: geometry only.
Entity make_entity(const Item& item, const Eigen::Matrix3d& R_cloud_level);

/// Label, probability and `also` from `classes` (falling, "unknown" included); classes related by
/// "is a" are no rivals.
void decide(Entity& entity, const Ontology& ontology, const ReasonOptions& options);

}  // namespace scanchor
