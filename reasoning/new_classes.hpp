#pragma once
// Classes that nobody has counted, as a user's five lines beside the shipped ones: how sure one may
// be of them, found without a single example.

#include <vector>

#include "reasoning/ontology.hpp"
#include "reasoning/reference_rooms.hpp"

namespace scanchor {

/// Classes that have no counted prior, or a description most of which was never counted.
std::vector<int> new_classes(const Ontology& ontology);

/// Background rates of the clauses and priors of these classes, from what their words hold of in
/// `rooms`: docs/why/semantics.md, "Classes that nobody counted". All others keep theirs to the
/// last bit. Nothing happens without rooms. Deterministic.
void weigh_new_classes(Ontology& ontology, const std::vector<int>& classes,
                       const std::vector<ReferenceRoom>& rooms);

}  // namespace scanchor
