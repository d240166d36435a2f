#pragma once
// A second opinion: proofs are held against the surfaces with plain geometry of its own, sharing no
// code with the matcher.

#include <string>
#include <vector>

#include "perception/surface.hpp"
#include "reasoning/labelling.hpp"
#include "reasoning/ontology.hpp"

namespace scanchor {

struct ProofFault {
  std::int32_t entity = 0;
  std::string clause;
  std::string text;  ///< one line: what does not follow
};

/// Checks the proof of an entity and, recursively, of every target in it, for the default mode:
///   every clause of the class is there, no other is, and no required one is below the gate of
///   0.05; every target has the class that the clause asks for among its likely ones, and the chain
///   ends without a circle; each measured number is what the polygons and planes of the surfaces
///   give, within rounding (distances: 2 cm); each likelihood is on the side of one half that the
///   measurement is, unless it lies within 3 sigma and the softness.
/// Empty: the proof holds. Only the label's class is checked, not that no other class is likelier.
std::vector<ProofFault> check_proof(const Surfaces& surfaces, const Ontology& ontology,
                                    const Labelling& labelling, std::int32_t entity);

}  // namespace scanchor
