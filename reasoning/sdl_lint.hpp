#pragma once
// What is legal in a class file but cannot be meant: `scanchor ontology lint`.

#include <string>
#include <vector>

#include "reasoning/ontology.hpp"

namespace scanchor {

struct LintFinding {
  std::string rule;  ///< "contradiction", "never grounded", "always true", "same description",
                     ///< "part without relation"
  std::string file;
  SourcePlace place;
  std::string text;  ///< one line for the person
};

/// All findings in the order of the classes. Circles of required clauses are already errors of the
/// reader.
///   contradiction          two clauses of a class exclude each other (its parents' included), or a
///   range has no room within nature never grounded         a class needs another one that is
///   contradictory itself always true            a clause that another one implies, or that holds
///   for everything (area over 0 m2) same description       two classes with the same clauses: no
///   measurement can tell them apart part without relation  a part that names no relation to its
///   whole is never given to it
std::vector<LintFinding> lint(const Ontology& ontology);

/// "office.sdl:12:5: always true: ..."
std::string lint_text(const LintFinding& finding);

}  // namespace scanchor
