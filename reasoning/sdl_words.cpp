#include "reasoning/sdl_words.hpp"

#include <cmath>
#include <cstdio>

namespace scanchor {

const std::vector<RelationWords>& relation_vocabulary() {
  static const std::vector<RelationWords> words = {
      {Relation::parallel, "parallel to", "parallel", true},
      {Relation::orthogonal, "orthogonal to", "orthogonal", true},
      {Relation::above, "above", "", false},
      {Relation::below, "below", "", false},
      {Relation::on, "on", "", false},
      {Relation::supports, "supporting", "", false},
      {Relation::inside, "inside", "", false},
      {Relation::near, "near", "near", true},
      {Relation::touching, "touching", "touching", true},
      {Relation::same_size, "same size as", "same size", true},
      {Relation::aligned, "vertically aligned with", "vertically aligned", true},
      {Relation::stacked, "stacked with", "stacked", true},
      {Relation::coplanar, "coplanar with", "coplanar", true},
      {Relation::higher, "higher than", "", false},
      {Relation::lower, "lower than", "", false},
      {Relation::elevation, "elevation", "", false},
      {Relation::bottom, "bottom", "", false},
      {Relation::top, "top", "", false},
      {Relation::set_back, "set back", "", false},
      {Relation::left_of, "left of", "", false},
      {Relation::right_of, "right of", "", false},
      {Relation::in_front_of, "in front of", "", false},
      {Relation::behind, "behind", "", false},
  };
  return words;
}

const std::vector<FeatureWord>& feature_vocabulary() {
  static const std::vector<FeatureWord> words = {
      {Feature::area, "area", 2},
      {Feature::extension, "extension", 1},
      {Feature::width, "width", 1},
      {Feature::height, "height", 1},
      {Feature::elongation, "elongation", 0},
      {Feature::rectangularness, "rectangularness", 0},
      {Feature::members, "members", 0},
  };
  return words;
}

const std::vector<ExtremumWord>& extremum_vocabulary() {
  static const std::vector<ExtremumWord> words = {
      {Extremum::lowest, "lowest"},       {Extremum::highest, "highest"},
      {Extremum::outermost, "outermost"}, {Extremum::largest, "largest"},
      {Extremum::cornered, "cornered"},
  };
  return words;
}

const std::vector<UnitWord>& unit_vocabulary() {
  static const std::vector<UnitWord> words = {
      {"m", 1.0, 1},    {"cm", 0.01, 1},  {"mm", 0.001, 1}, {"m2", 1.0, 2},
      {"cm2", 1e-4, 2}, {"mm2", 1e-6, 2}, {"deg", 1.0, -1},
  };
  return words;
}

const UnitWord* find_unit(std::string_view word) {
  for (const auto& unit : unit_vocabulary()) {
    if (unit.word == word) return &unit;
  }
  return nullptr;
}

std::string number_text(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

std::string relation_words(Relation relation) {
  for (const auto& word : relation_vocabulary()) {
    if (word.relation == relation) return std::string(word.words);
  }
  return "?";
}

std::string feature_word(Feature feature) {
  for (const auto& word : feature_vocabulary()) {
    if (word.feature == feature) return std::string(word.word);
  }
  return "?";
}

std::string extremum_word(Extremum extremum) {
  for (const auto& word : extremum_vocabulary()) {
    if (word.extremum == extremum) return std::string(word.word);
  }
  return "?";
}

std::string range_text(const Range& range) {
  const UnitWord* unit = find_unit(range.unit);
  const double scale = unit != nullptr ? unit->scale : 1.0;
  const std::string tail = range.unit.empty() ? "" : " " + range.unit;
  if (range.about) return "about " + number_text(0.5 * (range.low + range.high) / scale) + tail;
  if (range.has_low() && range.has_high()) {
    return number_text(range.low / scale) + ".." + number_text(range.high / scale) + tail;
  }
  if (range.has_low())
    return (range.strict ? "over " : "at least ") + number_text(range.low / scale) + tail;
  return (range.strict ? "under " : "at most ") + number_text(range.high / scale) + tail;
}

std::string with_article(const std::string& noun) {
  const bool vowel =
      !noun.empty() && std::string_view("aeiou").find(noun.front()) != std::string_view::npos;
  return (vowel ? "an " : "a ") + noun;
}

std::string pair_text(const RelationTerm& term) {
  if (term.relation == Relation::near && term.range.has_high())
    return range_text(term.range).replace(0, std::string_view("at most").size(), "within");
  for (const auto& word : relation_vocabulary()) {
    if (word.relation == term.relation) return std::string(word.pair_words);
  }
  return {};
}

namespace {

std::string article(const std::string& noun) {
  const bool vowel =
      !noun.empty() && std::string_view("aeiou").find(noun.front()) != std::string_view::npos;
  return (vowel ? "an " : "a ") + noun;
}

std::string term_text(const RelationTerm& term) {
  switch (term.relation) {
    case Relation::elevation:
    case Relation::bottom:
    case Relation::top:
      return relation_words(term.relation) + " " + range_text(term.range) + " above";
    case Relation::set_back:
      return relation_words(term.relation) + " " + range_text(term.range) + " behind";
    case Relation::near:
      if (!term.range.has_high()) break;
      return range_text(term.range).replace(0, std::string_view("at most").size(), "within") +
             " of";
    case Relation::coplanar:
      if (!term.range.has_high()) break;
      return "coplanar " +
             range_text(term.range).replace(0, std::string_view("at most").size(), "within") +
             " with";
    default:
      break;
  }
  return relation_words(term.relation);
}

std::string joined(const std::vector<RelationTerm>& terms) {
  std::string text;
  for (const auto& term : terms) text += (text.empty() ? "" : " and ") + term_text(term);
  return text;
}

/// "that is horizontal", but "that has area over 1 m2".
bool takes_has(const Clause& clause) {
  if (clause.kind == ClauseKind::feature) return true;
  if (clause.kind != ClauseKind::relation) return false;
  const Relation first = clause.relations.front().relation;
  return first == Relation::elevation || first == Relation::bottom || first == Relation::top;
}

/// " that is horizontal and near a window"; in brackets where another clause of an outer list
/// follows, which would else be read as said of this target.
std::string that_is_text(const std::vector<Clause>& clauses) {
  std::string text;
  for (std::size_t i = 0; i < clauses.size(); ++i) {
    Clause head = clauses[i];
    head.target_clauses.clear();
    const std::string inner = that_is_text(clauses[i].target_clauses);
    const std::string verb = takes_has(clauses[i]) ? "has " : "is ";
    const bool same_verb = i > 0 && takes_has(clauses[i]) == takes_has(clauses[i - 1]);
    text += (i == 0 ? " that " + verb : same_verb ? " and " : " and " + verb) + clause_text(head);
    if (!inner.empty()) text += i + 1 < clauses.size() ? " (" + inner.substr(1) + ")" : inner;
  }
  return text;
}

}  // namespace

std::string plural(const std::string& noun) {
  if (noun.ends_with("f")) return noun.substr(0, noun.size() - 1) + "ves";
  for (const auto* end : {"s", "x", "sh", "ch"}) {
    if (noun.ends_with(end)) return noun + "es";
  }
  return noun + "s";
}

std::string clause_text(const Clause& clause) {
  std::string text = clause.usually ? "usually " : "";
  if (clause.weight != 1.0) text += "weight " + number_text(clause.weight) + " ";
  switch (clause.kind) {
    case ClauseKind::feature:
      return text + feature_word(clause.feature) + " " + range_text(clause.range);
    case ClauseKind::horizontal:
    case ClauseKind::vertical:
      text += clause.kind == ClauseKind::horizontal ? "horizontal" : "vertical";
      return clause.range.has_high() ? text + " within " + number_text(clause.range.high) + " deg"
                                     : text;
    case ClauseKind::rectangular:
      return text + "rectangular";
    case ClauseKind::extremum:
      return text + extremum_word(clause.extremum);
    case ClauseKind::relation:
      return text + joined(clause.relations) + " " + article(clause.target) +
             that_is_text(clause.target_clauses);
    case ClauseKind::negation:
      return text + "not " + joined(clause.relations) + " " + article(clause.target) +
             that_is_text(clause.target_clauses);
    case ClauseKind::group: {
      const bool open = clause.count_high == std::numeric_limits<int>::max();
      if (open) {
        text += "at least " + std::to_string(clause.count_low);
      } else if (clause.count_low == clause.count_high) {
        text += "exactly " + std::to_string(clause.count_low);
      } else {
        text += std::to_string(clause.count_low) + ".." + std::to_string(clause.count_high);
      }
      text += " " +
              (clause.written_target.empty() ? plural(clause.target) : clause.written_target) +
              ", each pair";
      std::string pairs;
      for (const auto& term : clause.pairwise)
        pairs += (pairs.empty() ? " " : " and ") + pair_text(term);
      return text + pairs;
    }
  }
  return text;
}

}  // namespace scanchor
