#include "reasoning/sdl_parser.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/error.hpp"
#include "core/text.hpp"
#include "reasoning/sdl_lexer.hpp"
#include "reasoning/sdl_words.hpp"

namespace scanchor {

namespace {

class Parser {
 public:
  Parser(const std::string& text, const std::string& file) : text_(text), file_(file) {}

  Ontology parse() {
    Ontology ontology;
    ontology.file = file_;
    std::vector<std::string> comments;
    std::size_t begin = 0;
    if (text_.starts_with("\xEF\xBB\xBF")) begin = 3;
    for (int number = 1; begin <= text_.size(); ++number) {
      const std::size_t end = std::min(text_.find('\n', begin), text_.size());
      line_ = scan_line(std::string_view(text_).substr(begin, end - begin), number);
      next_ = 0;
      begin = end + 1;
      if (line_.tokens.size() == 1) {
        if (line_.has_comment) comments.push_back(line_.comment);
        if (!line_.has_comment && !comments.empty()) comments.emplace_back(blank_line);
        continue;
      }
      if (line_.indent == 0) {
        const std::size_t classes = ontology.classes.size();
        top_level(ontology, comments);
        if (ontology.classes.size() == classes)
          continue;  // an import: what stands above it goes to the first class
      } else {
        indented(ontology, comments);
      }
      comments.clear();
    }
    finish_class(ontology);
    while (!comments.empty() && comments.back() == blank_line) comments.pop_back();
    ontology.closing_comments = comments;
    return ontology;
  }

 private:
  [[nodiscard]] const Token& peek(std::size_t ahead = 0) const {
    return line_.tokens[std::min(next_ + ahead, line_.tokens.size() - 1)];
  }
  Token take() {
    Token token = peek();
    if (next_ + 1 < line_.tokens.size()) ++next_;
    return token;
  }
  [[nodiscard]] bool at_word(std::string_view word, std::size_t ahead = 0) const {
    return peek(ahead).kind == Token::Kind::word && peek(ahead).text == word;
  }
  bool accept(std::string_view word) {
    if (!at_word(word)) return false;
    take();
    return true;
  }
  bool accept_words(std::string_view words) {
    const auto parts = split_words(words);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (!at_word(parts[i], i)) return false;
    }
    for (std::size_t i = 0; i < parts.size(); ++i) take();
    return true;
  }
  [[nodiscard]] SourcePlace place(const Token& token) const { return {line_.number, token.column}; }
  [[noreturn]] void fail(const Token& token, const std::string& cause,
                         const std::string& remedy = "") const {
    fail_sdl(text_, file_, place(token), cause, remedy);
  }
  void expect_end() const {
    if (peek().kind != Token::Kind::end)
      fail(peek(), "nothing more was expected here, found '" + peek().text + "'");
  }

  void top_level(Ontology& ontology, const std::vector<std::string>& comments) {
    finish_class(ontology);
    const Token first = take();
    if (first.kind == Token::Kind::word && first.text == "import") {
      std::string name;
      while (peek().kind != Token::Kind::end) name += take().text;
      name.erase(std::remove(name.begin(), name.end(), '"'), name.end());
      if (name.empty()) fail(peek(), "import of what? write: import office");
      ontology.imports.push_back(name);
      return;
    }
    if (first.kind != Token::Kind::word || (first.text != "class" && first.text != "axiom")) {
      const bool clause_like = !ontology.classes.empty() && first.text != "Class";
      fail(first,
           "a line that is not indented begins with 'class', 'axiom' or 'import', found '" +
               first.text + "'",
           clause_like && !nearest_word(first.text, {"class", "axiom", "import"})
               ? "indent it if it is a clause"
               : suggestion(first.text, {"class", "axiom", "import"}));
    }
    ClassDescription description;
    description.axiom = first.text == "axiom";
    description.place = place(first);
    description.comments = comments;
    description.comment = line_.comment;
    description.file = file_;
    do {
      description.names.push_back(name({"is", "part"}));
    } while (peek().kind == Token::Kind::comma && (take(), true));
    while (peek().kind == Token::Kind::word) {
      if (accept_words("is a") || accept_words("is an")) {
        description.parent = name({"is", "part"});
      } else if (accept_words("part of")) {
        if ((at_word("a") || at_word("an")) && peek(1).kind == Token::Kind::word) take();
        description.part_of = name({"is", "part"});
      } else {
        fail(peek(), "expected 'is a', 'part of' or ':', found '" + peek().text + "'");
      }
    }
    if (peek().kind != Token::Kind::colon)
      fail(peek(), "a class begins with 'class name:', the ':' is missing");
    take();
    expect_end();
    ontology.classes.push_back(std::move(description));
  }

  // Words up to the end of the name: a comma, a colon, the end or one of `stops`.
  std::string name(const std::vector<std::string>& stops) {
    std::string result;
    while (peek().kind == Token::Kind::word ||
           (peek().kind == Token::Kind::number && !result.empty())) {
      if (!result.empty() && std::find(stops.begin(), stops.end(), peek().text) != stops.end())
        break;
      result += (result.empty() ? "" : " ") + take().text;
    }
    if (result.empty()) fail(peek(), "a name of a class was expected here");
    return result;
  }

  void indented(Ontology& ontology, const std::vector<std::string>& comments) {
    if (ontology.classes.empty())
      fail(peek(), "a clause needs a class above it, such as 'class desk:'");
    auto& description = ontology.classes.back();
    if (!description.clauses.empty() && description.clauses.back().kind == ClauseKind::group &&
        line_.indent > group_indent_) {
      pair_line(description.clauses.back());
      return;
    }
    if (accept("unique")) {
      expect_end();
      description.unique = true;
      return;
    }
    if (at_word("several") && at_word("faces", 1)) {
      accept_words("several faces");
      expect_end();
      description.several_faces = true;
      return;
    }
    Clause clause = parse_clause();
    clause.comments = comments;
    clause.comment = line_.comment;
    description.clauses.push_back(std::move(clause));
  }

  void finish_class(const Ontology& ontology) const {
    if (ontology.classes.empty()) return;
    const auto& description = ontology.classes.back();
    if (description.clauses.empty() && description.parent.empty()) {
      fail_sdl(text_, file_, description.place, "class '" + description.name() + "' has no clause",
               "describe it by at least one indented line");
    }
    for (const auto& clause : description.clauses) {
      if (clause.kind == ClauseKind::group && clause.pairwise.empty()) {
        fail_sdl(text_, file_, clause.place,
                 "'each pair' needs at least one indented line such as 'parallel'");
      }
    }
  }

  Clause parse_clause() {
    Clause clause;
    clause.place = place(peek());
    clause.usually = accept("usually");
    if (accept("weight")) {
      const Token token = take();
      if (token.kind != Token::Kind::number || token.value <= 0.0 || token.value > 1.0) {
        fail(token, "a weight is a number above 0 and at most 1, found '" + token.text + "'");
      }
      clause.weight = token.value;
    }
    const Token first = peek();
    if (first.kind == Token::Kind::word) {
      if (simple_clause(clause)) return clause;
      if (accept("not") || accept("no")) {
        clause.kind = ClauseKind::negation;
        relation_clause(clause);
        return clause;
      }
    }
    if (group_ahead()) {
      group_clause(clause);
      return clause;
    }
    clause.kind = ClauseKind::relation;
    relation_clause(clause);
    return clause;
  }

  bool simple_clause(Clause& clause) {
    for (const auto& word : feature_vocabulary()) {
      if (!at_word(word.word)) continue;
      take();
      clause.kind = ClauseKind::feature;
      clause.feature = word.feature;
      clause.range = range(word.dimension, std::string(word.word));
      expect_end();
      return true;
    }
    for (const auto& word : extremum_vocabulary()) {
      if (!accept(word.word)) continue;
      clause.kind = ClauseKind::extremum;
      clause.extremum = word.extremum;
      expect_end();
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
      expect_end();
      return true;
    }
    return false;
  }

  double number() {
    const Token token = take();
    if (token.kind != Token::Kind::number) {
      fail(token, token.kind == Token::Kind::end
                      ? "a number was expected here, the line ends"
                      : "a number was expected here, found '" + token.text + "'");
    }
    return token.value;
  }

  Range range(int dimension, const std::string& what) {
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
    const double a = number();
    double b = a;
    if (!low && !high && !result.about) {
      if (peek().kind != Token::Kind::dots) {
        fail(first,
             "'" + what +
                 "' takes a range: 0.9..1.7, or 'at least', 'at most', 'under', 'over', 'about'");
      }
      take();
      b = number();
      if (b < a)
        fail(first, "the range is empty: " + number_text(a) + " is above " + number_text(b));
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

  double unit(int dimension, const std::string& what, std::string& word) {
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

  // "at least 2 boards, each pair" or "2..5 boards, each pair": a count is not followed by a unit.
  [[nodiscard]] bool group_ahead() const {
    for (std::size_t i = 0; i + next_ < line_.tokens.size(); ++i) {
      if (at_word("each", i) && at_word("pair", i + 1)) return true;
    }
    return at_word("exactly") || (at_word("at") && (at_word("least", 1) || at_word("most", 1)));
  }

  int count() {
    const Token token = peek();
    const double value = number();
    if (value < 1.0 || value > 1e6 || value != std::floor(value)) {
      fail(token, "a count is a whole number from 1, found '" + token.text + "'");
    }
    return static_cast<int>(value);
  }

  void group_clause(Clause& clause) {
    clause.kind = ClauseKind::group;
    group_indent_ = line_.indent;
    if (accept_words("at least")) {
      clause.count_low = count();
    } else if (accept_words("at most")) {
      clause.count_low = 1;
      clause.count_high = count();
    } else if (accept("exactly")) {
      clause.count_low = clause.count_high = count();
    } else {
      const Token token = peek();
      clause.count_low = count();
      if (peek().kind != Token::Kind::dots)
        fail(peek(), "a count is '2..5', 'at least 2', 'at most 5' or 'exactly 4'");
      take();
      clause.count_high = count();
      if (clause.count_high < clause.count_low) fail(token, "the range of the count is empty");
    }
    clause.target = clause.written_target = name({});
    if (peek().kind == Token::Kind::comma) take();
    if (!accept_words("each pair"))
      fail(peek(), "a group goes on with ', each pair' and indented pair relations");
    if (peek().kind != Token::Kind::end) pair_line(clause);
  }

  void pair_line(Clause& clause) {
    do {
      const Token first = peek();
      bool found = false;
      for (const auto& word : relation_vocabulary()) {
        if (word.pair_words.empty() || !accept_words(word.pair_words)) continue;
        clause.pairwise.push_back({word.relation, {}});
        found = true;
        break;
      }
      if (!found) {
        std::vector<std::string> known;
        for (const auto& word : relation_vocabulary()) {
          if (!word.pair_words.empty()) known.emplace_back(word.pair_words);
        }
        fail(first, "unknown relation of a pair '" + rest() + "'", suggestion(rest(), known));
      }
    } while (accept("and"));
    expect_end();
    clause.pair_comments.resize(clause.pairwise.size());
    if (clause.place.line != line_.number) clause.pair_comments.back() = line_.comment;
  }

  [[nodiscard]] std::string rest() const {
    std::string text;
    for (std::size_t i = 0; peek(i).kind != Token::Kind::end; ++i)
      text += (i == 0 ? "" : " ") + peek(i).text;
    return text;
  }

  void relation_clause(Clause& clause) {
    do {
      clause.relations.push_back(relation_term());
    } while (accept("and"));
    if (!accept("a") && !accept("an") && !accept("the")) {
      fail(peek(),
           peek().kind == Token::Kind::end
               ? "the relation has no target: write 'a desk'"
               : "'a', 'an' or 'the' and a class was expected, found '" + peek().text + "'");
    }
    clause.target = name({});
    expect_end();
  }

  RelationTerm relation_term() {
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
    if (accept("within")) {
      term.relation = Relation::near;
      term.range.high = distance();
      term.range.unit = unit_;
      if (!accept("of")) fail(peek(), "'within' a distance goes on with 'of a ...'");
      return term;
    }
    if (accept("coplanar")) {
      term.relation = Relation::coplanar;
      if (accept("within")) {
        term.range.high = distance();
        term.range.unit = unit_;
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
    fail(first, "unknown clause '" + first.text + "'", suggestion(first.text, known));
  }

  double distance() {
    const double value = number();
    return value * unit(1, "within", unit_);
  }

  const std::string& text_;
  const std::string& file_;
  Line line_;
  std::size_t next_ = 0;
  int group_indent_ = 0;
  std::string unit_;
};

}  // namespace

Ontology parse_sdl(const std::string& text, const std::string& file) {
  return Parser(text, file).parse();
}

}  // namespace scanchor
