#pragma once
// All classes of an ontology for people to read.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "reasoning/ontology.hpp"

namespace scanchor {

/// A chapter a class: names, what it is a kind or part of, its clauses with the rates that were
/// counted, and the classes that build on it.
std::string catalogue_markdown(const Ontology& ontology);

/// The same for programs: {"ontology", "classes": [{"name", "synonyms", "axiom", "clauses", ...}]}.
nlohmann::ordered_json catalogue_json(const Ontology& ontology);

/// Names of the classes of which a clause asks for this one, further in as well; each once, in the
/// order of the files.
std::vector<std::string> built_on(const Ontology& ontology, const std::string& class_name);

}  // namespace scanchor
