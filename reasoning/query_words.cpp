#include <array>
#include <charconv>

#include "reasoning/query.hpp"
#include "reasoning/sdl_words.hpp"

namespace scanchor {

namespace {

constexpr std::array<std::string_view, 10> ordinals = {
    "first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth"};

std::string named(const std::string& noun, bool definite) {
  return definite ? "the " + noun : with_article(noun);
}

/// "chairs near a desk", without an article.
std::string many_text(QueryRef ref) {
  ref.definite = true;  // "the x", of which the article goes
  ref.name = plural(ref.name);
  return ref_text(ref).substr(4);
}

std::string count_text(const QueryClause& clause) {
  const bool open = clause.count_high == std::numeric_limits<int>::max();
  if (open) return "at least " + std::to_string(clause.count_low) + " ";
  if (clause.count_low == clause.count_high)
    return "exactly " + std::to_string(clause.count_low) + " ";
  return std::to_string(clause.count_low) + ".." + std::to_string(clause.count_high) + " ";
}

std::string clauses_text(const QueryRef& ref);

/// What comes behind it is not said of it.
std::string closed_text(const QueryRef& ref) {
  if (!ref.rank_to.empty()) return ref_text(ref);
  QueryRef bare = ref;
  bare.clauses.clear();
  const std::string inner = clauses_text(ref);
  return ref_text(bare) + (inner.empty() ? "" : " (" + inner + ")");
}

std::string clauses_text(const QueryRef& ref) {
  std::string text;
  for (std::size_t i = 0; i < ref.clauses.size(); ++i) {
    const QueryClause& clause = ref.clauses[i];
    const bool last = i + 1 == ref.clauses.size();
    QueryClause bare = clause;
    std::string inner;
    if (!bare.targets.empty() && !bare.targets.back().clauses.empty() &&
        bare.targets.back().rank_to.empty()) {
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

std::optional<RankKey> rank_of(std::string_view word) {
  for (const auto& known : rank_vocabulary()) {
    if (word == known.word) return known.key;
  }
  constexpr std::pair<std::string_view, RankKey> others[] = {
      {"closest", RankKey::nearest},  {"biggest", RankKey::largest}, {"top", RankKey::highest},
      {"topmost", RankKey::highest},  {"bottom", RankKey::lowest},   {"tallest", RankKey::highest},
      {"furthest", RankKey::farthest}};
  for (const auto& [other, key] : others) {
    if (word == other) return key;
  }
  return std::nullopt;
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
  const int last = value % 10;
  const bool teen = value / 10 % 10 == 1;
  const char* const end = teen || last == 0 || last > 3 ? "th"
                          : last == 1                   ? "st"
                          : last == 2                   ? "nd"
                                                        : "rd";
  return std::to_string(value) + end;
}

std::string order_text(const QueryRef& ref) {
  if (ref.rank_to.empty()) return rank_text(ref);
  return rank_text(ref) + (ref.rank == RankKey::farthest ? " from " : " to ") +
         ref_text(ref.rank_to.front());
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
      if (one) return (clause.negated ? "without " : "with ") + target;
      const QueryRef& what = clause.targets.front();
      const bool single = clause.count_low == 1 && clause.count_high == 1;
      QueryRef the_one = what;
      the_one.definite = true;
      return std::string(clause.negated ? "not " : "") + "with " + count_text(clause) +
             (single ? ref_text(the_one).substr(4) : many_text(what));
    }
    case QueryClause::Kind::between: {
      return std::string(clause.negated ? "not " : "") + "between " +
             closed_text(clause.targets.front()) + " and " + ref_text(clause.targets.back());
    }
  }
  return {};
}

std::string ref_text(const QueryRef& ref) {
  const std::string rank = rank_text(ref);
  std::string noun = rank.empty() ? ref.name : rank + " " + ref.name;
  if (!ref.rank_to.empty()) {
    // "desk (with a screen) nearest to a door": the words would run into each other.
    QueryRef first = ref;
    first.place = 1;
    const std::string own = clauses_text(ref);
    noun = (ref.place > 1 ? ordinal_word(ref.place) + " " : "") + ref.name +
           (own.empty() ? " " : " (" + own + ") ") + rank_text(first) +
           (ref.rank == RankKey::farthest ? " from " : " to ") + closed_text(ref.rank_to.front());
    return named(noun, true);
  }
  const std::string said = clauses_text(ref);
  return named(noun, ref.definite || ref.rank.has_value()) + (said.empty() ? "" : " " + said);
}

std::string query_text(const Query& query) {
  switch (query.kind) {
    case Query::Kind::find:
      return ref_text(query.refs.front());
    case Query::Kind::count: {
      return "count " + many_text(query.refs.front());
    }
    case Query::Kind::exists:
      return "is there " + ref_text(query.refs.front());
    case Query::Kind::distance:
      return "distance from " + ref_text(query.refs.front()) + " to " + ref_text(query.refs.back());
  }
  return {};
}

}  // namespace scanchor
