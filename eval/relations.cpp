#include "eval/relations.hpp"

#include <algorithm>
#include <tuple>

#include "eval/statistics.hpp"

namespace scanchor {
namespace {

auto key(const NamedRelation& fact) { return std::tie(fact.relation, fact.a, fact.b); }

// One fact a pair; of several claims the surest.
void keep_one_each(std::vector<NamedRelation>& facts) {
  std::stable_sort(facts.begin(), facts.end(), [](const NamedRelation& a, const NamedRelation& b) {
    return key(a) != key(b) ? key(a) < key(b) : a.probability > b.probability;
  });
  facts.erase(std::unique(facts.begin(), facts.end(),
                          [](const auto& a, const auto& b) { return key(a) == key(b); }),
              facts.end());
}

}  // namespace

double RelationCounts::precision() const { return ratio_of(right, right + wrong); }
double RelationCounts::recall() const { return ratio_of(right, right + missed); }

void RelationCounts::add(const RelationCounts& other) {
  right += other.right;
  wrong += other.wrong;
  missed += other.missed;
  judged += other.judged;
  brier.add(other.brier);
}

void RelationScore::add(const RelationScore& other) {
  for (const auto& [name, counts] : other.clear) clear[name].add(counts);
  for (const auto& [name, counts] : other.borderline) borderline[name].add(counts);
}

RelationScore score_relations(std::vector<NamedRelation> truth, std::vector<NamedRelation> claims,
                              double threshold) {
  keep_one_each(truth);
  keep_one_each(claims);
  RelationScore score;
  for (const auto& fact : truth) score.clear[fact.relation];
  std::size_t c = 0;
  const auto claim_without_truth = [&](const NamedRelation& claim) {
    const auto known = score.clear.find(claim.relation);
    if (known == score.clear.end()) return;
    ++known->second.judged;
    known->second.brier.add(claim.probability * claim.probability);
    if (claim.probability >= threshold) ++known->second.wrong;
  };
  for (const auto& fact : truth) {
    while (c < claims.size() && key(claims[c]) < key(fact)) claim_without_truth(claims[c++]);
    const bool judged = c < claims.size() && key(claims[c]) == key(fact);
    const double probability = judged ? claims[c++].probability : 0.0;
    auto& counts = (fact.borderline ? score.borderline : score.clear)[fact.relation];
    if (judged) {
      ++counts.judged;
      const double off = probability - (fact.holds ? 1.0 : 0.0);
      counts.brier.add(off * off);
    }
    const bool said = judged && probability >= threshold;
    if (fact.holds && said) ++counts.right;
    if (fact.holds && !said) ++counts.missed;
    if (!fact.holds && said) ++counts.wrong;
  }
  while (c < claims.size()) claim_without_truth(claims[c++]);
  return score;
}

}  // namespace scanchor
