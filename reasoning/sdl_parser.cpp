#include "reasoning/sdl_parser.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/error.hpp"
#include "core/text.hpp"
#include "reasoning/sdl_clause.hpp"
#include "reasoning/sdl_hints.hpp"
#include "reasoning/sdl_lexer.hpp"
#include "reasoning/sdl_words.hpp"

namespace scanchor {

namespace {

class Parser : private ClauseReader {
 public:
  using ClauseReader::ClauseReader;

  Ontology parse() {
    Ontology ontology;
    ontology.file = file();
    std::vector<std::string> comments;
    std::size_t begin = 0;
    if (text().starts_with("\xEF\xBB\xBF")) begin = 3;
    for (int number = 1; begin <= text().size(); ++number) {
      const std::size_t end = std::min(text().find('\n', begin), text().size());
      start(scan_line(std::string_view(text()).substr(begin, end - begin), number));
      begin = end + 1;
      if (line().tokens.size() == 1) {
        if (line().has_comment) comments.push_back(line().comment);
        if (!line().has_comment && !comments.empty()) comments.emplace_back(blank_line);
        continue;
      }
      if (line().indent == 0) {
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
  void top_level(Ontology& ontology, const std::vector<std::string>& comments) {
    finish_class(ontology);
    const Token first = take();
    if (first.kind == Token::Kind::word && first.text == "import") {
      std::string import;
      while (!at_end()) import += take().text;
      import.erase(std::remove(import.begin(), import.end(), '"'), import.end());
      if (import.empty()) fail(peek(), "import of what? write: import office");
      ontology.imports.push_back(import);
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
    description.comment = line().comment;
    description.file = file();
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

  void indented(Ontology& ontology, const std::vector<std::string>& comments) {
    if (ontology.classes.empty())
      fail(peek(), "a clause needs a class above it, such as 'class desk:'");
    auto& description = ontology.classes.back();
    if (!description.clauses.empty() && description.clauses.back().kind == ClauseKind::group &&
        line().indent > group_indent_) {
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
    clause.comment = line().comment;
    description.clauses.push_back(std::move(clause));
  }

  void finish_class(const Ontology& ontology) const {
    if (ontology.classes.empty()) return;
    const auto& description = ontology.classes.back();
    if (description.clauses.empty() && description.parent.empty()) {
      fail_sdl(text(), file(), description.place,
               "class '" + description.name() + "' has no clause",
               "describe it by at least one indented line");
    }
    for (const auto& clause : description.clauses) {
      if (clause.kind == ClauseKind::group && clause.pairwise.empty()) {
        fail_sdl(text(), file(), clause.place,
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
      if (simple_clause(clause)) {
        expect_end();
        return clause;
      }
      if (accept("not") || accept("no")) {
        clause.kind = ClauseKind::negation;
        if (!at_relation() && clause_hint(*this).empty())
          fail(peek(),
               "a relation was expected behind '" + first.text + "'" +
                   (at_end() ? "" : ", found '" + peek().text + "'"),
               denial_hint(*this));
        relation_clause(clause);
        expect_end();
        return clause;
      }
    }
    if (group_ahead()) {
      if (clause.usually)
        fail(first, "'usually' cannot stand before the members of a group",
             "a group is what its class is made of; say it without 'usually'");
      group_clause(clause);
      return clause;
    }
    clause.kind = ClauseKind::relation;
    relation_clause(clause);
    expect_end();
    return clause;
  }

  // "at least 2 boards, each pair" or "2..5 boards, each pair": a count is not followed by a unit.
  [[nodiscard]] bool group_ahead() const {
    for (std::size_t i = 0; peek(i).kind != Token::Kind::end; ++i) {
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
    group_indent_ = line().indent;
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
      bool found = accept("within");
      if (found) {
        RelationTerm& term = clause.pairwise.emplace_back(RelationTerm{Relation::near, {}});
        term.range.high = distance(term.range.unit);
      }
      for (const auto& word : relation_vocabulary()) {
        if (found) break;
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
    if (clause.place.line != line().number) clause.pair_comments.back() = line().comment;
  }

  int group_indent_ = 0;
};

}  // namespace

Ontology parse_sdl(const std::string& text, const std::string& file) {
  return Parser(text, file).parse();
}

}  // namespace scanchor
