#pragma once
// The paper's own method: equations 1 and 2 with the slips mended (docs/why/semantics.md, S1 to
// S24).

#include "perception/surface.hpp"
#include "reasoning/labelling.hpp"
#include "reasoning/ontology.hpp"
#include "reasoning/up.hpp"

namespace scanchor {

struct ReasonOptions;

/// Disparity of a class and an entity, each part of it divided by the size it is measured against
/// (mend of S11), so that metres, square metres and likelihoods may be added. 0: exactly as
/// described.
struct Disparity {
  double area = 0.0, extension = 0.0, rectangularness = 0.0, theta = 0.0;
  [[nodiscard]] double sum() const { return area + extension + rectangularness + theta; }
};

/// The similarity threshold delta of the paper, for the sum above.
inline constexpr double similarity_threshold = 0.5;

/// The paper's chain: "0.8 on a table of 0.5 is 0.4" (section 3), own likelihood times that of what
/// it rests on.
constexpr double chained(double own, double target) { return own * target; }

/// Labels by disparity < delta and the chain of products: a clause on a target counts its
/// likelihood times the target's.
Labelling reason_as_paper(const Surfaces& surfaces, const Ontology& ontology,
                          const ReasonOptions& options, const UpDirection& up);

}  // namespace scanchor
