#include "reasoning/proof.hpp"

#include "reasoning/background.hpp"

namespace scanchor {

namespace {

ProofClause prove(const Matcher& matcher, const Ontology& ontology, int class_index,
                  const Clause& clause, std::int32_t item) {
  const ClauseValue value = matcher.evaluate(class_index, clause, item);
  ProofClause entry;
  entry.text = matcher.text_of(clause);
  entry.likelihood = value.value;
  entry.background = background_of(clause);
  entry.measured = value.evidence.measured;
  entry.sigma = value.evidence.sigma;
  entry.unit = value.evidence.unit;
  entry.target_class = clause.target;
  if (value.target >= 0) entry.targets.push_back(value.target);
  for (const auto m : value.members) entry.targets.push_back(m);
  if (value.target < 0) return entry;
  for (const auto& nested : clause.target_clauses) {
    entry.that_is.push_back(
        prove(matcher, ontology, ontology.find(clause.target), nested, value.target));
  }
  return entry;
}

}  // namespace

std::vector<ProofClause> make_proof(const Matcher& matcher, const Ontology& ontology,
                                    int class_index, std::int32_t item) {
  std::vector<ProofClause> proof;
  for (const auto& clause : matcher.clauses(class_index))
    proof.push_back(prove(matcher, ontology, class_index, clause, item));
  return proof;
}

}  // namespace scanchor
