#pragma once
// Class files as OWL 2 in Turtle, to be looked at in Protege and carried into other tools, and
// back.
//
// Every class is an owl:Class, every clause one of its rdfs:subClassOf restrictions: features are
// data ranges with facets in SI units, relations are someValuesFrom on an object property, a
// conjunction on one shared target is a property below both, a group a qualified minimum
// cardinality. What OWL DL cannot say (pairs inside a group, superlatives, "usually", weights)
// stands in the annotation sdl:words of the restriction, which is also what the way back reads
// first; a restriction without it, as another tool writes it, is read from its OWL form.

#include <string>

#include "reasoning/ontology.hpp"

namespace scanchor {

/// Turtle that declares all of its vocabulary: no owl:imports that would have to resolve.
std::string ontology_to_turtle(const Ontology& ontology);

/// Throws Error(bad_data): not Turtle (with the line), no classes, a restriction that cannot be
/// said in the language, or a build without the serd library.
Ontology ontology_from_turtle(const std::string& turtle, const std::string& file);

}  // namespace scanchor
