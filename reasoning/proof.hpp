#pragma once
// The reason for a label, clause by clause.

#include "reasoning/labelling.hpp"
#include "reasoning/matcher.hpp"

namespace scanchor {

/// Every clause of a class held against an entity, in the order of the class file, those of its
/// parents first. A target's own proof is that of the entity with its id: recursive down to an
/// axiom.
std::vector<ProofClause> make_proof(const Matcher& matcher, const Ontology& ontology,
                                    int class_index, std::int32_t item);

}  // namespace scanchor
