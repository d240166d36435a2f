#include <algorithm>

#include "core/error.hpp"
#include "core/text.hpp"
#include "reasoning/query.hpp"
#include "reasoning/sdl_clause.hpp"
#include "reasoning/sdl_hints.hpp"
#include "reasoning/sdl_words.hpp"

namespace scanchor {

namespace {

const std::string question = "question";

class QueryParser : private ClauseReader {
 public:
  QueryParser(const std::string& text, const Ontology& ontology)
      : ClauseReader(text, question), ontology_(ontology) {
    Line line = scan_line(text, 1);
    // A comment has no meaning here, and a question mark none either.
    while (line.tokens.size() > 1 && line.tokens[line.tokens.size() - 2].text == "?")
      line.tokens.erase(line.tokens.end() - 2);
    // "How many", "Is there".
    for (auto& token : line.tokens) {
      if (token.kind == Token::Kind::word)
        std::transform(token.text.begin(), token.text.end(), token.text.begin(), [](char c) {
          return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        });
    }
    start(std::move(line));
  }

  Query parse() {
    Query query;
    query.text = text();
    if (at_end()) fail(peek(), "nothing is asked", "write for example: screen on a desk");
    if (accept_words("how far") || accept("distance")) {
      distance(query);
    } else if (accept_words("how many") || accept("count")) {
      query.kind = Query::Kind::count;
      query.refs.push_back(ref(0));
      query.refs.back().definite = false;  // "count the chairs": all of them
      accept_words("are there");
    } else if (accept_words("is there") || accept_words("are there")) {
      query.kind = Query::Kind::exists;
      query.refs.push_back(ref(0));
    } else if (accept_words("what is") || accept_words("which things are")) {
      QueryRef thing;
      thing.name = "thing";
      said_of(thing, 0);
      query.refs.push_back(std::move(thing));
    } else {
      const bool asked = accept("find") || accept("show") || accept("list") || accept("which") ||
                         accept_words("where is") || accept_words("where are");
      static_cast<void>(asked);
      query.refs.push_back(ref(0));
    }
    if (!at_end()) {
      fail(peek(), "'" + peek().text + "' begins nothing that can be said of a thing",
           question_hint(*this));
    }
    return query;
  }

 private:
  void distance(Query& query) {
    query.kind = Query::Kind::distance;
    const bool asked = accept("is") && !accept("it");
    if (accept("between")) {
      query.refs.push_back(ref(1));
      if (!accept("and")) fail(peek(), "'between' names two things: between a desk and a door");
      query.refs.push_back(ref(1));
      return;
    }
    if (!asked && !accept("from"))
      fail(peek(), "write 'distance from a desk to a door' or 'distance between ... and ...'");
    to_is_taken_ = true;  // "from the nearest chair to a desk" goes to the desk
    query.refs.push_back(ref(1));
    to_is_taken_ = false;
    if (!accept("to") && !accept("from"))
      fail(peek(), "the distance to what? write 'distance from a desk to a door'");
    query.refs.push_back(ref(1));
  }

  /// `depth` 0: what is asked for; only there an "and" outside of "that is" and brackets goes on.
  QueryRef ref(int depth) {
    const Depth inner(*this);
    QueryRef result;
    result.definite = accept("the");
    if (!result.definite && !accept("a") && !accept("an")) {
      if (!accept("any")) accept("all");
    }
    bool ordered = false;
    if (name_length() == 0) ordered = rank_words(result);
    class_name(result);
    const bool order_follows = at_words("from the") || at_words("nearest to") ||
                               at_words("closest to") || at_words("farthest from") ||
                               at_words("furthest from");
    if (ordered && !result.rank && !order_follows) {
      const std::string place = last_ ? "last" : ordinal_word(result.place);
      fail(peek(), "the " + place + " in which order?",
           "write '" + place + " " + result.name + " from the top', from the left, or '" + place +
               " nearest " + result.name + "'");
    }
    said_of(result, depth);
    return result;
  }

  /// "second", "nearest", "third largest"; true after an ordinal.
  bool rank_words(QueryRef& result) {
    bool ordered = false;
    if (peek().kind == Token::Kind::word && ordinal_value(peek().text) > 0) {
      result.place = ordinal_value(take().text);
      ordered = true;
    } else if (peek().kind == Token::Kind::number &&
               ordinal_value(peek().text + peek(1).text) > 0) {
      result.place = ordinal_value(peek().text + peek(1).text);
      take();
      take();
      ordered = true;
    } else if (accept("last")) {
      ordered = last_ = true;
    }
    if (name_length() > 0) return ordered;
    if (peek().kind == Token::Kind::word) result.rank = rank_of(peek().text);
    if (result.rank) take();
    turn_if_last(result);
    return ordered;
  }

  /// "last" counts an order from its other end.
  void turn_if_last(QueryRef& result) {
    if (!last_ || !result.rank) return;
    const RankKey key = *result.rank;
    for (const auto& entry : rank_vocabulary()) {
      if (entry.key == key) result.rank = entry.opposite;
    }
    last_ = false;
  }

  /// Tokens of the longest class name here; 0: none.
  [[nodiscard]] std::size_t name_length() const {
    std::string words;
    std::size_t longest = 0;
    for (std::size_t i = 0; i < 6 && peek(i).kind != Token::Kind::end; ++i) {
      if (peek(i).kind != Token::Kind::word && peek(i).kind != Token::Kind::number) break;
      words += (i == 0 ? "" : " ") + peek(i).text;
      if (ontology_.find(words, true) >= 0) longest = i + 1;
    }
    return longest;
  }

  void class_name(QueryRef& result) {
    if (const std::size_t length = name_length(); length > 0) {
      std::string words;
      for (std::size_t i = 0; i < length; ++i) words += (i == 0 ? "" : " ") + take().text;
      const int index = ontology_.find(words, true);
      result.classes = {index};
      result.name = ontology_.classes[static_cast<std::size_t>(index)].name();
      return;
    }
    const Token token = peek();
    for (const auto* word : {"thing", "things", "object", "objects", "anything", "something"}) {
      if (!accept(word)) continue;
      result.name = "thing";
      return;
    }
    if (token.kind != Token::Kind::word)
      fail(token, "a class was expected here", "write for example: screen on a desk");
    // "board" where there are only shelf boards.
    for (std::size_t c = 0; c < ontology_.classes.size(); ++c) {
      const std::string& name = ontology_.classes[c].name();
      const auto blank = name.rfind(' ');
      if (blank == std::string::npos) continue;
      const std::string head = name.substr(blank + 1);
      if (token.text != head && token.text != head + "s" && token.text != head + "es" &&
          !(head.ends_with("f") && token.text == head.substr(0, head.size() - 1) + "ves"))
        continue;
      result.classes.push_back(static_cast<int>(c));
      result.name = result.classes.size() == 1 ? name : head;
    }
    if (result.classes.empty()) {
      const auto names = ontology_.class_names();
      const std::string hint = nearest_word(token.text, names) ? "" : question_hint(*this);
      fail(token, "unknown class '" + token.text + "'",
           hint.empty() ? suggestion(token.text, names) : hint);
    }
    take();
  }

  void said_of(QueryRef& result, int depth) {
    if (accept_sign("(")) {
      const Depth inner(*this);
      said_of(result, 0);
      if (!accept_sign(")")) fail(peek(), "the bracket is not closed");
    }
    for (bool more = true; more;) {
      more = one_more(result, false);
      if (!more && depth == 0 && at_word("and")) {
        // Only what goes on with words that can be said of a thing is ours.
        take();
        if (!one_more(result, true))
          fail(peek(), at_end()
                           ? "nothing comes behind 'and'"
                           : "'" + peek().text + "' begins nothing that can be said of a thing");
        more = true;
      }
    }
  }

  /// One more clause, rank or list of "that is"; false with nothing taken.
  bool one_more(QueryRef& result, bool behind_and) {
    if (order_from(result) || nearest_to(result)) return true;
    for (const auto* word : {"that is", "that are", "that has", "that have", "which is",
                             "which are", "which has", "which have", "are", "is"}) {
      if (!accept_words(word)) continue;
      if (at_word("there")) {  // "how many chairs are there"
        take();
        return true;
      }
      that_is(result);
      return true;
    }
    QueryClause clause;
    if (!read_clause(clause, behind_and)) return false;
    result.clauses.push_back(std::move(clause));
    return true;
  }

  void that_is(QueryRef& result) {
    for (bool more = true; more;) {
      QueryClause clause;
      const bool order = nearest_to(result);
      if (!order && !read_clause(clause, true)) {
        const Token first = peek();
        std::vector<std::string> known = {"horizontal", "vertical", "rectangular", "not"};
        for (const auto& word : feature_vocabulary()) known.emplace_back(word.word);
        for (const auto& word : relation_vocabulary())
          known.push_back(split_words(word.words).front());
        const bool thing = at_word("a") || at_word("an") || at_word("the") || at_word("no");
        fail(first,
             first.kind == Token::Kind::end ? "the question ends behind 'that is'"
                                            : "unknown clause '" + first.text + "'",
             thing ? "of things say 'with': 'desk with a monitor'" : suggestion(first.text, known));
      }
      if (!order) result.clauses.push_back(std::move(clause));
      more = at_word("and");
      if (more) {
        take();
        if (!accept("is") && !accept("has")) accept_words("that is") || accept_words("that has");
      }
    }
  }

  /// `plain`: features and orientations may stand here without "that is".
  bool read_clause(QueryClause& clause, bool plain) {
    const bool negated = at_word("not") && (take(), true);
    clause.negated = negated;
    if (accept("of")) {
      clause.kind = QueryClause::Kind::belongs;
      clause.targets.push_back(ref(1));
      return true;
    }
    if (at_word("with") || at_word("without")) {
      with(clause);
      return true;
    }
    if (accept("between")) {
      clause.kind = QueryClause::Kind::between;
      clause.targets.push_back(ref(1));
      if (!accept("and")) fail(peek(), "'between' names two things: between a desk and a door");
      clause.targets.push_back(ref(1));
      return true;
    }
    const bool height = at_word("elevation") || at_word("bottom") || at_word("top");
    if (at_relation() || (height && plain)) {
      clause.kind = QueryClause::Kind::relation;
      clause.relations = relation_terms();
      const Token target = peek();
      if (target.kind == Token::Kind::end)
        fail(target, "the relation has no target", "write 'a desk'");
      clause.targets.push_back(ref(1));
      seen_from_robot();
      return true;
    }
    if (plain && simple_clause(clause.plain)) return true;
    if (negated) fail(peek(), "'not' goes on with a relation, such as 'not on a desk'");
    return false;
  }

  void with(QueryClause& clause) {
    clause.kind = QueryClause::Kind::with;
    if (accept("without")) {
      clause.negated = !clause.negated;
      clause.targets.push_back(ref(1));
      return;
    }
    take();
    for (const auto& word : feature_vocabulary()) {
      if (!at_word(word.word)) continue;
      clause.kind = QueryClause::Kind::plain;
      simple_clause(clause.plain);
      return;
    }
    if (accept("no")) {
      clause.negated = !clause.negated;
    } else if (accept_words("at least")) {
      clause.count_low = whole_number();
    } else if (accept_words("at most")) {
      clause.count_low = 0;
      clause.count_high = whole_number();
    } else if (accept("exactly") || peek().kind == Token::Kind::number) {
      clause.count_low = clause.count_high = whole_number();
      if (peek().kind == Token::Kind::dots) {
        take();
        const Token high = peek();
        clause.count_high = whole_number();
        if (clause.count_high < clause.count_low)
          fail(high, "the range is empty: " + std::to_string(clause.count_low) + " is above " +
                         std::to_string(clause.count_high));
      }
    }
    clause.targets.push_back(ref(1));
  }

  int whole_number() {
    const Token token = peek();
    const double value = number();
    if (!(value >= 0.0 && value <= 1e6) || value != static_cast<int>(value))
      fail(token, "a count is a whole number, found '" + token.text + "'");
    return static_cast<int>(value);
  }

  /// Sides are always meant from the robot; saying so is allowed.
  void seen_from_robot() {
    if (!at_words("seen from") && !at_words("from the robot") && !at_words("from robot")) return;
    accept("seen");
    accept("from");
    accept("the");
    if (!accept("robot")) fail(peek(), "sides are seen from the robot: write 'from the robot'");
  }

  /// "second board from the top".
  bool order_from(QueryRef& result) {
    if (!at_words("from the")) return false;
    const std::pair<std::string_view, RankKey> ends[] = {{"top", RankKey::highest},
                                                         {"bottom", RankKey::lowest},
                                                         {"left", RankKey::leftmost},
                                                         {"right", RankKey::rightmost}};
    for (const auto& [word, key] : ends) {
      if (!at_word(word, 2)) continue;
      if (result.rank) fail(peek(), "there is an order already: '" + rank_text(result) + "'");
      take();
      take();
      take();
      result.rank = key;
      turn_if_last(result);
      return true;
    }
    return false;
  }

  /// "desk nearest to a door".
  bool nearest_to(QueryRef& result) {
    std::optional<RankKey> key;
    if (accept_words("nearest to") || accept_words("closest to")) key = RankKey::nearest;
    if (accept_words("farthest from") || accept_words("furthest from")) key = RankKey::farthest;
    if (!key && !result.rank_to.empty()) return false;
    // "the nearest chair to a desk"
    if (!key && !to_is_taken_ && at_word("to") &&
        (result.rank == RankKey::nearest || result.rank == RankKey::farthest)) {
      take();
      result.rank_to.push_back(ref(1));
      return true;
    }
    if (!key) return false;
    if (result.rank) fail(peek(), "there is an order already: '" + rank_text(result) + "'");
    result.rank = key;
    turn_if_last(result);
    result.rank_to.push_back(ref(1));
    return true;
  }

  const Ontology& ontology_;
  bool last_ = false;         ///< "last": the order is still to come, and goes from its other end
  bool to_is_taken_ = false;  ///< "to" belongs to the distance that is asked for
};

}  // namespace

Query parse_query(const std::string& text, const Ontology& ontology) {
  try {
    return QueryParser(text, ontology).parse();
  } catch (const Error& error) {
    throw Error(ExitCode::wrong_usage, error.what());
  }
}

}  // namespace scanchor
