#pragma once
// Reasons as text, in the words of the class file.

#include <string>

#include "perception/surface.hpp"
#include "reasoning/labelling.hpp"
#include "reasoning/ontology.hpp"

namespace scanchor {

/// Why an entity has its label: each clause with what was measured, its uncertainty, likelihood and
/// target, and the targets' own reasons below, each once, down to an axiom. Throws
/// Error(wrong_usage) if there is no such entity.
///
///   7 is a monitor (0.97)
///     above a desk: 0.11 +- 0.01 m, holds (1.00) on 6
///   6 is a desk (0.98)
///     ...
std::string explain(const Labelling& labelling, std::int32_t entity);

/// What keeps an entity from being of a class.
struct WhyNot {
  bool holds = false;  ///< every required clause is likely (0.5): only a likelier class or the
                       ///< prior stands against it
  std::string
      clause;  ///< the first one that fails, in the words of the class file; empty if none does
  double likelihood = 1.0;  ///< of that clause
  double measured = 0.0, sigma = 0.0;
  std::string unit;     ///< empty: nothing was measured, there is no target at all
  double needed = 0.0;  ///< value from which on the clause would be likelier than not, in `unit`
  bool has_needed = false;  ///< false where no change of one number would do
  std::string target;       ///< "6 (desk)" or "" without a target
  std::string text;         ///< all of it in a few lines
};

/// Evaluates the description anew, with the same up direction as the labelling. Throws
/// Error(wrong_usage): unknown class or entity.
WhyNot why_not(const Surfaces& surfaces, const Ontology& ontology, const Labelling& labelling,
               std::int32_t entity, const std::string& class_name);

}  // namespace scanchor
