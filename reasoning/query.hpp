#pragma once
// A question in the words of the class files: "screen on a desk that is near a window",
// "second board from the top of the shelf", "how many chairs near a table"
// (docs/reference/queries.md).

#include <optional>
#include <string>
#include <vector>

#include "reasoning/ontology.hpp"

namespace scanchor {

/// What the things that fit a description are put in order by.
enum class RankKey {
  nearest,
  farthest,
  largest,
  smallest,
  highest,
  lowest,
  longest,
  shortest,
  widest,
  narrowest,
  leftmost,
  rightmost,
};

struct QueryRef;

/// One thing that is said of what is asked for.
struct QueryClause {
  enum class Kind {
    plain,     ///< of its own features: "that is horizontal", "that has area over 1 m2"
    relation,  ///< "on a desk", "left of the shelf"
    belongs,   ///< "of the shelf": part or member of it
    with,      ///< "with a screen", "with no screen": has it as a part, on it or in it
    between,   ///< "between a desk and a door"
  };
  Kind kind = Kind::plain;
  bool negated = false;
  Clause plain;
  std::vector<RelationTerm> relations;  ///< on one shared target
  std::vector<QueryRef> targets;        ///< one; two of `between`
  int count_low = 1;                    ///< of `with`: at least so many
  int count_high = std::numeric_limits<int>::max();
};

/// A thing by its description.
struct QueryRef {
  std::vector<int> classes;  ///< indices into the ontology, any of them; empty: anything
  std::string name;          ///< of the class, or the common last word of several, or "thing"
  bool definite = false;     ///< "the": one is meant
  std::optional<RankKey> rank;
  int place = 1;                  ///< 2: "second nearest"
  std::vector<QueryRef> rank_to;  ///< at most one: "nearest to a door"; else from the robot
  std::vector<QueryClause> clauses;
};

struct Query {
  enum class Kind { find, count, exists, distance };
  Kind kind = Kind::find;
  std::string text;            ///< as asked
  std::vector<QueryRef> refs;  ///< one; two of `distance`
};

/// Throws Error(wrong_usage): "question:1:13: unknown class 'dsek'; did you mean 'desk'?", then the
/// line and a caret.
Query parse_query(const std::string& text, const Ontology& ontology);

/// How a question was read, with brackets where words could be said of either of two things. Read
/// again it gives the same.
std::string query_text(const Query& query);
std::string ref_text(const QueryRef& ref);
/// "on a desk that is near a window".
std::string query_clause_text(const QueryClause& clause);
/// "nearest", "second highest".
std::string rank_text(const QueryRef& ref);
/// The same with what it is to: "nearest to a door".
std::string order_text(const QueryRef& ref);

struct RankWord {
  RankKey key;
  std::string_view word;
  RankKey opposite;
};
const std::vector<RankWord>& rank_vocabulary();
/// Of these words and others for the same: "closest", "biggest", "top".
std::optional<RankKey> rank_of(std::string_view word);
/// "first", "second", ... "tenth": 1 to 10; 0: none of them. Also "1st", "2nd", ...
int ordinal_value(std::string_view word);
std::string ordinal_word(int value);

}  // namespace scanchor
