#pragma once
// How far the direction of a found plane may be off, all told.

#include <Eigen/Core>

#include "perception/surface.hpp"

namespace scanchor {

struct RelationModel;
const RelationModel& relation_model();

/// Covariance of the plane's normal [rad2] in the cloud's frame, across the normal: that of a fit
/// along the beams, what the fit that was made differs from it, and what the choice of its points
/// may have tilted it by (docs/why/semantics.md, "How far likelihoods of relations can be
/// believed"). Zero for a plane without a covariance of its own: taken for exact.
Eigen::Matrix3d plane_error(const Surface& surface, const Surfaces& surfaces,
                            const RelationModel& model = relation_model());

}  // namespace scanchor
