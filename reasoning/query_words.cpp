#include <array>
#include <charconv>

#include "reasoning/query.hpp"
#include "reasoning/sdl_words.hpp"

namespace scanchor {

namespace {

constexpr std::array<std::string_view, 10> ordinals = {
    "first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth"};

std::string with_article(const std::string& noun, bool definite) {
  if (definite) return "the " + noun;
  const bool vowel =
      !noun.empty() && std::string_view("aeiou").find(noun.front()) != std::string_view::npos;
  return (vowel ? "an " : "a ") + noun;
}

std::string count_text(const QueryClause& clause) {
  const bool open = clause.count_high == std::numeric_limits<int>::max();
  if (open) return "at least " + std::to_string(clause.count_low) + " ";
  if (clause.count_low == clause.count_high)
    return "exactly " + std::to_string(clause.count_low) + " ";
  return std::to_string(clause.count_low) + ".." + std::to_string(clause.count_high) + " ";
}

std::string clauses_text(const QueryRef& ref) {
  std::string text;
  for (std::size_t i = 0; i < ref.clauses.size(); ++i) {
    const QueryClause& clause = ref.clauses[i];
    const bool last = i + 1 == ref.clauses.size();
    QueryClause bare = clause;
    std::string inner;
    if (!bare.targets.empty() && !bare.targets.back().clauses.empty()) {
      inner = clauses_text(bare.targets.back());
      // Words behind it, or an "and" of its own, would be said of the outer thing.
      if (!last || bare.targets.back().clauses.size() > 1) inner = "(" + inner + ")";
      inner.insert(0, " ");
      bare.targets.back().clauses.clear();
    }
    text += (i == 0 ? "" : " and ") + query_clause_text(bare) + inner;
  }
  return text;
}

}  // namespace

const std::vector<RankWord>& rank_vocabulary() {
  static const std::vector<RankWord> words = {
      {RankKey::nearest, "nearest", RankKey::farthest},
      {RankKey::farthest, "farthest", RankKey::nearest},
      {RankKey::largest, "largest", RankKey::smallest},
      {RankKey::smallest, "smallest", RankKey::largest},
      {RankKey::highest, "highest", RankKey::lowest},
      {RankKey::lowest, "lowest", RankKey::highest},
      {RankKey::longest, "longest", RankKey::shortest},
      {RankKey::shortest, "shortest", RankKey::longest},
      {RankKey::widest, "widest", RankKey::narrowest},
      {RankKey::narrowest, "narrowest", RankKey::widest},
      {RankKey::leftmost, "leftmost", RankKey::rightmost},
      {RankKey::rightmost, "rightmost", RankKey::leftmost},
  };
  return words;
}

int ordinal_value(std::string_view word) {
  for (std::size_t i = 0; i < ordinals.size(); ++i) {
    if (word == ordinals[i]) return static_cast<int>(i) + 1;
  }
  int value = 0;
  const auto read = std::from_chars(word.data(), word.data() + word.size(), value);
  const std::string_view end(read.ptr,
                             static_cast<std::size_t>(word.data() + word.size() - read.ptr));
  const bool ends_well = end == "st" || end == "nd" || end == "rd" || end == "th";
  return read.ec == std::errc() && ends_well && value > 0 ? value : 0;
}

std::string ordinal_word(int value) {
  if (value <= static_cast<int>(ordinals.size()))
    return std::string(ordinals[static_cast<std::size_t>(value - 1)]);
  return std::to_string(value) + "th";
}

std::string rank_text(const QueryRef& ref) {
  if (!ref.rank) return {};
  std::string text = ref.place > 1 ? ordinal_word(ref.place) + " " : "";
  for (const auto& word : rank_vocabulary()) {
    if (word.key == *ref.rank) text += word.word;
  }
  return text;
}

std::string query_clause_text(const QueryClause& clause) {
  switch (clause.kind) {
    case QueryClause::Kind::plain: {
      const bool has = clause.plain.kind == ClauseKind::feature;
      return std::string(has ? "that has " : "that is ") + (clause.negated ? "not " : "") +
             clause_text(clause.plain);
    }
    case QueryClause::Kind::relation: {
      // The words of the class files, without a target of theirs.
      Clause bare;
      bare.kind = clause.negated ? ClauseKind::negation : ClauseKind::relation;
      bare.relations = clause.relations;
      bare.target = "x";
      std::string words = clause_text(bare);
      words.erase(words.size() - std::string_view("an x").size() + 1);
      if (words.back() != ' ') words += ' ';
      return words + ref_text(clause.targets.front());
    }
    case QueryClause::Kind::belongs:
      return (clause.negated ? "not of " : "of ") + ref_text(clause.targets.front());
    case QueryClause::Kind::with: {
      const std::string target = ref_text(clause.targets.front());
      const bool one = clause.count_low == 1 && clause.count_high > 1'000'000;
      if (clause.negated) return "without " + target;
      if (one) return "with " + target;
      QueryRef many = clause.targets.front();
      many.definite = true;  // "the x", of which the article goes
      return "with " + count_text(clause) + ref_text(many).substr(4);
    }
    case QueryClause::Kind::between: {
      QueryRef first = clause.targets.front();
      const std::string inner = clauses_text(first);
      first.clauses.clear();
      return std::string(clause.negated ? "not " : "") + "between " + ref_text(first) +
             (inner.empty() ? "" : " (" + inner + ")") + " and " + ref_text(clause.targets.back());
    }
  }
  return {};
}

std::string ref_text(const QueryRef& ref) {
  const std::string rank = rank_text(ref);
  std::string noun = rank.empty() ? ref.name : rank + " " + ref.name;
  if (!ref.rank_to.empty()) {
    // "desk nearest to a door": the door's own words would run into the desk's.
    QueryRef to = ref.rank_to.front();
    const std::string inner = clauses_text(to);
    to.clauses.clear();
    const bool from = ref.rank == RankKey::farthest;
    noun = ref.name + " " + rank + (from ? " from " : " to ") + ref_text(to) +
           (inner.empty() ? "" : " (" + inner + ")");
  }
  const std::string said = clauses_text(ref);
  return with_article(noun, ref.definite || ref.rank.has_value()) +
         (said.empty() ? "" : " " + said);
}

std::string query_text(const Query& query) {
  switch (query.kind) {
    case Query::Kind::find:
      return ref_text(query.refs.front());
    case Query::Kind::count: {
      QueryRef many = query.refs.front();
      many.definite = true;
      return "count " + ref_text(many).substr(4);
    }
    case Query::Kind::exists:
      return "is there " + ref_text(query.refs.front());
    case Query::Kind::distance:
      return "distance from " + ref_text(query.refs.front()) + " to " + ref_text(query.refs.back());
  }
  return {};
}

}  // namespace scanchor
