#pragma once
// One surface may be several equal things side by side, two in one plane may be one thing that a
// shadow parts: other readings of the same points, which compete with the first one.

#include "cloud/point_cloud.hpp"
#include "perception/surface.hpp"
#include "reasoning/labelling.hpp"
#include "reasoning/ontology.hpp"
#include "reasoning/reason.hpp"

namespace scanchor {

/// Reads the surfaces anew where another reading explains them better by far, and says which. Needs
/// the inliers for cuts, and examined outlines for joins. Deterministic.
///   cut    2 to 6 pieces across the longer side, at seams in which the points thin out or evenly:
///          ln of the likelihood ratio is the worst piece's best class against all that the whole
///          may be; a prior stands against it, a stronger one where no seam is seen, and for it
///          where the outline falls apart by more than 60 cm: then things that fit a class as they
///          are, and unequal pieces, are cut too
///   joined two rectangles in one plane that face each other over at most 60 cm, both with shadows
///          for edges: the one thing's class against the better one of the two, a prior against it,
///          and for it that sides of two things are seldom in line
std::vector<Alternative> read_anew(Surfaces& surfaces, const PointCloud& cloud,
                                   const Ontology& ontology, const ReasonOptions& options);

/// read_anew and then reason: `surfaces` become those that the labelling is of.
Labelling interpret(Surfaces& surfaces, const PointCloud& cloud, const Ontology& ontology,
                    const ReasonOptions& options);

}  // namespace scanchor
