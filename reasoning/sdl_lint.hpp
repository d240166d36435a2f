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
std::vector<LintFinding> lint(const Ontology& ontology);

/// What a rule means and what to do about it, in a sentence or two.
std::string lint_explanation(const std::string& rule);

/// "office.sdl:12:5: always true: ..."
std::string lint_text(const LintFinding& finding);

}  // namespace scanchor
