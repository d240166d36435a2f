#include "reasoning/sdl_clause.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "reasoning/sdl_hints.hpp"
#include "reasoning/sdl_words.hpp"

namespace scanchor {

ClauseReader::Depth::Depth(ClauseReader& reader) : reader_(reader) {
  if (reader.depth_ >= deepest_description)
    reader.fail(
        reader.peek(),
        "more than " + std::to_string(deepest_description) + " descriptions lie in each other",
        "describe the inner ones in a class of their own");
  ++reader.depth_;
}

bool ClauseReader::simple_clause(Clause& clause) {
  for (const auto& word : feature_vocabulary()) {
    if (!at_word(word.word)) continue;
    take();
    clause.kind = ClauseKind::feature;
    clause.feature = word.feature;
    clause.range = range(word.dimension, std::string(word.word));
    return true;
  }
  for (const auto& word : extremum_vocabulary()) {
    if (!accept(word.word)) continue;
    clause.kind = ClauseKind::extremum;
    clause.extremum = word.extremum;
    return true;
  }
  const std::pair<std::string_view, ClauseKind> plain[] = {
      {"horizontal", ClauseKind::horizontal},
      {"vertical", ClauseKind::vertical},
      {"rectangular", ClauseKind::rectangular}};
  for (const auto& [word, kind] : plain) {
    if (!accept(word)) continue;
    clause.kind = kind;
    if (kind != ClauseKind::rectangular && accept("within")) {
      clause.range.high = number() * unit(-1, "within", clause.range.unit);
    }
    return true;
  }
  return false;
}

double ClauseReader::number() {
  const Token token = take();
  if (token.kind != Token::Kind::number) {
    fail(token, token.kind == Token::Kind::end
                    ? "a number was expected here, the line ends"
                    : "a number was expected here, found '" + token.text + "'");
  }
  return token.value;
}

Range ClauseReader::range(int dimension, const std::string& what) {
  Range result;
  const Token first = peek();
  bool low = false;
  bool high = false;
  if (accept_words("at least")) {
    low = true;
  } else if (accept_words("at most")) {
    high = true;
  } else if (accept("over")) {
    low = result.strict = true;
  } else if (accept("under")) {
    high = result.strict = true;
  } else if (accept("about")) {
    result.about = true;
  }
  const bool said = low || high || result.about;
  if (!said && peek().kind != Token::Kind::number)
    fail(peek(),
         "'" + what + "' takes a range here" + (at_end() ? "" : ", found '" + peek().text + "'"),
         range_hint(*this, what));
  const std::string meant = said ? "" : range_hint(*this, what);
  const double a = number();
  double b = a;
  if (!said) {
    if (peek().kind != Token::Kind::dots) {
      fail(first,
           "'" + what +
               "' takes a range: 0.9..1.7, or 'at least', 'at most', 'under', 'over', 'about'",
           meant);
    }
    take();
    b = number();
    if (b < a) fail(first, "the range is empty: " + number_text(a) + " is above " + number_text(b));
  }
  const double scale = unit(dimension, what, result.unit);
  if (result.about) {
    result.low = 0.8 * a * scale;
    result.high = 1.2 * a * scale;
  } else {
    if (!high) result.low = a * scale;
    if (!low) result.high = b * scale;
  }
  return result;
}

double ClauseReader::unit(int dimension, const std::string& what, std::string& word) {
  if (dimension == 0) {
    if (peek().kind == Token::Kind::word && find_unit(peek().text) != nullptr) {
      fail(peek(), "'" + what + "' is a pure number, it has no unit");
    }
    return 1.0;
  }
  const std::vector<std::string> wanted =
      dimension == 2   ? std::vector<std::string>{"m2", "cm2", "mm2"}
      : dimension == 1 ? std::vector<std::string>{"m", "cm", "mm"}
                       : std::vector<std::string>{"deg"};
  const Token token = peek();
  const UnitWord* found = token.kind == Token::Kind::word ? find_unit(token.text) : nullptr;
  if (found == nullptr) {
    const bool missing =
        token.kind != Token::Kind::word || token.text == "above" || token.text == "of";
    fail(token,
         missing ? "a unit is missing behind the number" : "unknown unit '" + token.text + "'",
         suggestion(missing ? "" : token.text, wanted));
  }
  if (found->dimension != dimension) {
    fail(token, "'" + what + "' cannot be measured in " + token.text, suggestion("", wanted));
  }
  take();
  word = token.text;
  return found->scale;
}

// Words up to the end of the name: a comma, a colon, the end or one of `stops`.
std::string ClauseReader::name(const std::vector<std::string>& stops) {
  std::string result;
  while (peek().kind == Token::Kind::word ||
         (peek().kind == Token::Kind::number && !result.empty())) {
    if (!result.empty() && (at_words("that is") || at_words("that has"))) break;
    if (!result.empty() && std::find(stops.begin(), stops.end(), peek().text) != stops.end()) break;
    result += (result.empty() ? "" : " ") + take().text;
  }
  if (result.empty()) fail(peek(), "a name of a class was expected here");
  return result;
}

bool ClauseReader::at_relation() const {
  for (const auto& word : relation_vocabulary()) {
    if (at_words(word.words)) return true;
    if (!word.pair_words.empty() && at_words(word.pair_words) &&
        at_word("and", split_words(word.pair_words).size()))
      return true;
  }
  return at_word("within") || at_word("coplanar");
}

std::vector<RelationTerm> ClauseReader::relation_terms() {
  std::vector<RelationTerm> terms;
  do {
    terms.push_back(relation_term());
  } while (accept("and"));
  return terms;
}

void ClauseReader::relation_clause(Clause& clause, const std::vector<std::string>& stops) {
  clause.relations = relation_terms();
  if (!accept("a") && !accept("an") && !accept("the")) {
    fail(peek(),
         at_end() ? "the relation has no target: write 'a desk'"
                  : "'a', 'an' or 'the' and a class was expected, found '" + peek().text + "'",
         at_end() ? "" : target_hint(*this));
  }
  clause.target = name(stops);
  that_is(clause);
}

void ClauseReader::that_is(Clause& clause) {
  const Token open = peek();
  const bool bracket = accept_sign("(");
  if (!accept_words("that is") && !accept_words("that has")) {
    if (bracket) fail(peek(), "a bracket behind a class goes on with 'that is ...'");
    return;
  }
  const Depth depth(*this);
  for (bool more = true; more;) {
    Clause one;
    one.place = place(peek());
    if (at_word("usually") || at_word("weight"))
      fail(peek(), "'" + peek().text + "' cannot stand behind 'that is'",
           "put it in front of the whole clause, or describe the target in a class of its own");
    if (!simple_clause(one)) {
      const bool negated = accept("not") || accept("no");
      one.kind = negated ? ClauseKind::negation : ClauseKind::relation;
      relation_clause(one, {"and"});
    }
    clause.target_clauses.push_back(std::move(one));
    more = accept("and");
    if (more && !accept("is")) accept("has");
  }
  if (bracket && !accept_sign(")")) fail(at_end() ? open : peek(), "the bracket is not closed");
}

RelationTerm ClauseReader::relation_term() {
  RelationTerm term;
  const Token first = peek();
  for (const auto relation : {Relation::elevation, Relation::bottom, Relation::top}) {
    const std::string word = relation_words(relation);
    if (!accept(word)) continue;
    term.relation = relation;
    term.range = range(1, word);
    if (!accept("above")) fail(peek(), "'" + word + "' goes on with 'above a floor'");
    return term;
  }
  if (accept_words(relation_words(Relation::set_back))) {
    term.relation = Relation::set_back;
    term.range = range(1, "set back");
    if (!accept("behind")) fail(peek(), "'set back' a distance goes on with 'behind a wall'");
    return term;
  }
  if (accept("within")) {
    term.relation = Relation::near;
    term.range.high = distance(term.range.unit);
    if (!accept("of")) fail(peek(), "'within' a distance goes on with 'of a ...'");
    return term;
  }
  if (accept("coplanar")) {
    term.relation = Relation::coplanar;
    if (accept("within")) {
      term.range.high = distance(term.range.unit);
    }
    accept("with");
    return term;
  }
  for (const auto& word : relation_vocabulary()) {
    // The preposition may be left out where another relation follows: "orthogonal and above a
    // desk".
    if (accept_words(word.words)) return {word.relation, {}};
    if (at_word(word.pair_words) && at_word("and", 1) && accept(word.pair_words))
      return {word.relation, {}};
  }
  std::vector<std::string> known;
  for (const auto& word : feature_vocabulary()) known.emplace_back(word.word);
  for (const auto& word : extremum_vocabulary()) known.emplace_back(word.word);
  for (const auto& word : relation_vocabulary()) known.push_back(split_words(word.words).front());
  for (const auto* word : {"horizontal", "vertical", "rectangular", "usually", "within", "not"})
    known.emplace_back(word);
  const std::string hint = clause_hint(*this);
  fail(first, at_end() ? "a clause was expected here" : "unknown clause '" + first.text + "'",
       hint.empty() ? suggestion(first.text, known) : hint);
}

double ClauseReader::distance(std::string& word) {
  const double value = number();
  return value * unit(1, "within", word);
}

}  // namespace scanchor
