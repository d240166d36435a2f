#include "reasoning/proof.hpp"

#include "reasoning/background.hpp"

namespace scanchor {

std::vector<ProofClause> make_proof(const Matcher& matcher, const Ontology& ontology,
                                    int class_index, std::int32_t item) {
  static_cast<void>(ontology);
  std::vector<ProofClause> proof;
  for (const auto& clause : matcher.clauses(class_index)) {
    const ClauseValue value = matcher.evaluate(class_index, clause, item);
    ProofClause entry;
    entry.text = clause_text(clause);
    entry.likelihood = value.value;
    entry.background = background_of(clause);
    entry.measured = value.evidence.measured;
    entry.sigma = value.evidence.sigma;
    entry.unit = value.evidence.unit;
    entry.target_class = clause.target;
    if (value.target >= 0) entry.targets.push_back(value.target);
    for (const auto m : value.members) entry.targets.push_back(m);
    proof.push_back(std::move(entry));
  }
  return proof;
}

}  // namespace scanchor
