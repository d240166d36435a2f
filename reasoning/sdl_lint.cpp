#include "reasoning/sdl_lint.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "reasoning/sdl_words.hpp"

namespace scanchor {

namespace {

struct Interval {
  double low = 0.0;
  double high = INFINITY;
};

/// Range of each feature that all required clauses together leave.
std::map<Feature, Interval> intervals(const std::vector<Clause>& clauses) {
  std::map<Feature, Interval> result;
  for (const auto& word : feature_vocabulary()) {
    Interval whole;
    if (word.feature == Feature::elongation) whole.low = 1.0;
    if (word.feature == Feature::members) whole.low = 1.0;
    if (word.feature == Feature::rectangularness) whole.high = 1.0;
    result[word.feature] = whole;
  }
  for (const auto& clause : clauses) {
    if (clause.kind != ClauseKind::feature || clause.usually) continue;
    auto& interval = result[clause.feature];
    interval.low = std::max(interval.low, clause.range.low);
    interval.high = std::min(interval.high, clause.range.high);
  }
  return result;
}

class Linter {
 public:
  explicit Linter(const Ontology& ontology) : ontology_(ontology) {}

  std::vector<LintFinding> run() {
    for (const int c : evaluation_order(ontology_)) contradictions(c);
    for (std::size_t c = 0; c < ontology_.classes.size(); ++c) {
      always_true(static_cast<int>(c));
      parts(static_cast<int>(c));
    }
    same_descriptions();
    std::stable_sort(findings_.begin(), findings_.end(), [](const auto& a, const auto& b) {
      return a.file != b.file ? a.file < b.file : a.place.line < b.place.line;
    });
    return findings_;
  }

 private:
  void add(const std::string& rule, const ClassDescription& description, SourcePlace place,
           const std::string& text) {
    findings_.push_back({rule, description.file, place, text});
  }

  void contradictions(int c) {
    const auto& description = ontology_.classes[c];
    if (excluded(description, all_clauses(ontology_, c), "class '" + description.name() + "'",
                 description.place))
      dead_.insert(c);
  }

  /// Reports the first reason why nothing can satisfy all these clauses; `what` names them.
  bool excluded(const ClassDescription& description, const std::vector<Clause>& clauses,
                const std::string& what, SourcePlace fallback) {
    const auto ranges = intervals(clauses);
    bool found = false;
    const auto impossible = [&](const std::string& why, SourcePlace place) {
      add("contradiction", description, place, what + " can never hold: " + why);
      found = true;
    };
    for (const auto& [feature, interval] : ranges) {
      if (interval.low <= interval.high) continue;
      impossible(feature_word(feature) + " would have to be at least " + number_text(interval.low) +
                     " and at most " + number_text(interval.high),
                 place_of(clauses, feature, fallback));
      return true;
    }
    const double area = ranges.at(Feature::area).low;
    const double extension = ranges.at(Feature::extension).high;
    const double width = std::min(ranges.at(Feature::width).high, extension);
    if (area > extension * width) {
      impossible("area at least " + number_text(area) + " m2 does not fit into sides of at most " +
                     number_text(extension) + " x " + number_text(width) + " m",
                 place_of(clauses, Feature::area, fallback));
      return true;
    }
    if (ranges.at(Feature::width).low > extension) {
      impossible("width is never above extension", place_of(clauses, Feature::width, fallback));
      return true;
    }
    const auto has = [&](ClauseKind kind) {
      return std::any_of(clauses.begin(), clauses.end(), [&](const Clause& x) {
        return x.kind == kind && !x.usually && !x.range.has_high();
      });
    };
    if (has(ClauseKind::horizontal) && has(ClauseKind::vertical)) {
      impossible("horizontal and vertical", fallback);
      return true;
    }
    for (const auto& clause : clauses) {
      if (clause.usually || clause.target.empty() || clause.kind == ClauseKind::negation) continue;
      const int target = ontology_.find(clause.target);
      if (dead_.count(target) != 0) {
        add("never grounded", description, clause.place,
            what + " needs '" + clause.target + "', which can never hold");
        return true;
      }
      std::set<Relation> relations;
      for (const auto& term : clause.relations) relations.insert(term.relation);
      const auto both = [&](Relation a, Relation b) {
        return relations.count(a) != 0 && relations.count(b) != 0;
      };
      if (both(Relation::parallel, Relation::orthogonal) ||
          both(Relation::above, Relation::below) || both(Relation::higher, Relation::lower) ||
          both(Relation::left_of, Relation::right_of) ||
          both(Relation::in_front_of, Relation::behind)) {
        impossible("'" + clause_text(clause) + "' excludes itself", clause.place);
        return true;
      }
      if (clause.target_clauses.empty()) continue;
      auto together = all_clauses(ontology_, target);
      together.insert(together.end(), clause.target_clauses.begin(), clause.target_clauses.end());
      if (excluded(description, together, "'" + clause_text(clause) + "'", clause.place))
        return true;
    }
    return found;
  }

  static SourcePlace place_of(const std::vector<Clause>& clauses, Feature feature,
                              SourcePlace fallback) {
    for (auto clause = clauses.rbegin(); clause != clauses.rend(); ++clause) {
      if (clause->kind == ClauseKind::feature && clause->feature == feature) return clause->place;
    }
    return fallback;
  }

  void always_true(int c) {
    const auto& description = ontology_.classes[c];
    const auto clauses = all_clauses(ontology_, c);
    for (const auto& clause : description.clauses) {
      if (clause.kind != ClauseKind::feature) continue;
      std::vector<Clause> others;
      for (const auto& other : clauses) {
        if (other.kind == ClauseKind::feature && other.place.line == clause.place.line &&
            other.range == clause.range)
          continue;
        others.push_back(other);
      }
      const auto left = intervals(others).at(clause.feature);
      if (clause.range.low <= left.low && clause.range.high >= left.high) {
        add("always true", description, clause.place,
            "'" + clause_text(clause) + "' of class '" + description.name() +
                "' says nothing beyond the other clauses");
      }
    }
    for (const auto& clause : description.clauses) said_of_target_already(description, clause);
    for (std::size_t i = 0; i < clauses.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (clauses[i].kind != ClauseKind::feature &&
            clause_text(clauses[i]) == clause_text(clauses[j])) {
          add("always true", description, clauses[i].place,
              "'" + clause_text(clauses[i]) + "' of class '" + description.name() +
                  "' is said twice");
        }
      }
    }
  }

  /// "near a desk that is horizontal" where every desk is.
  void said_of_target_already(const ClassDescription& description, const Clause& clause) {
    if (clause.target_clauses.empty()) return;
    const auto known = all_clauses(ontology_, ontology_.find(clause.target));
    for (const auto& nested : clause.target_clauses) {
      for (const auto& other : known) {
        if (!other.usually && clause_text(other) == clause_text(nested)) {
          add("always true", description, nested.place,
              "every '" + clause.target + "' is required to be '" + clause_text(nested) + "'");
        }
      }
      said_of_target_already(description, nested);
    }
  }

  void parts(int c) {
    const auto& description = ontology_.classes[c];
    if (description.part_of.empty()) return;
    if (only_a_member(ontology_, c)) return;
    for (const auto& clause : all_clauses(ontology_, c)) {
      if (clause.kind == ClauseKind::group) return;  // holds its whole together by its place
      if (clause.kind == ClauseKind::relation && clause.target == description.part_of) return;
    }
    add("part without relation", description, description.place,
        "class '" + description.name() + "' names no relation to its whole '" +
            description.part_of + "'");
  }

  void same_descriptions() {
    std::map<std::string, int> seen;
    for (std::size_t c = 0; c < ontology_.classes.size(); ++c) {
      std::vector<std::string> texts;
      for (const auto& clause : all_clauses(ontology_, static_cast<int>(c)))
        texts.push_back(clause_text(clause));
      std::sort(texts.begin(), texts.end());
      std::string key;
      for (const auto& text : texts) key += text + "\n";
      const auto [at, fresh] = seen.emplace(key, static_cast<int>(c));
      if (fresh) continue;
      const auto& description = ontology_.classes[c];
      add("same description", description, description.place,
          "classes '" + ontology_.classes[at->second].name() + "' and '" + description.name() +
              "' are described alike: nothing can tell them apart");
    }
  }

  const Ontology& ontology_;
  std::vector<LintFinding> findings_;
  std::set<int> dead_;
};

}  // namespace

std::vector<LintFinding> lint(const Ontology& ontology) { return Linter(ontology).run(); }

std::string lint_explanation(const std::string& rule) {
  static const std::map<std::string, std::string> explanations = {
      {"contradiction",
       "Two of these clauses exclude each other, those of parents and targets included, or a range "
       "has no room: nothing will ever be found. Widen one of them."},
      {"never grounded", "It asks for a class that is contradictory itself. Mend that one first."},
      {"always true",
       "Another clause implies it, or everything satisfies it: it costs time and tells nothing "
       "apart. Leave it out."},
      {"same description",
       "No measurement can tell the two apart: every such thing will be ambiguous. Add a clause to "
       "one, or make one a synonym."},
      {"part without relation",
       "A part is given to its whole by a relation to it, or by the whole's group: without one it "
       "stays alone. Add one, such as 'touching a ...'."}};
  const auto at = explanations.find(rule);
  return at != explanations.end() ? at->second : "";
}

std::string lint_text(const LintFinding& finding) {
  return finding.file + ":" + std::to_string(finding.place.line) + ":" +
         std::to_string(finding.place.column) + ": " + finding.rule + ": " + finding.text;
}

}  // namespace scanchor
