#pragma once
// Reads one clause: ranges with units, relations, their target and what is said of it.

#include <string>
#include <vector>

#include "reasoning/sdl_cursor.hpp"

namespace scanchor {

class ClauseReader : public SdlCursor {
 public:
  using SdlCursor::SdlCursor;

  /// A feature, an orientation, an extremum, or false with nothing taken.
  bool simple_clause(Clause& clause);
  /// The terms of a relation up to its target: "orthogonal to and above".
  std::vector<RelationTerm> relation_terms();
  /// True at a word that a relation may begin with.
  [[nodiscard]] bool at_relation() const;
  /// Terms, target and what is said of the target. `stops` end the target's name.
  void relation_clause(Clause& clause, const std::vector<std::string>& stops = {});
  /// Words up to the end of a name: a comma, a colon, the end, "that is" or one of `stops`.
  std::string name(const std::vector<std::string>& stops);
  Range range(int dimension, const std::string& what);
  double number();
  double distance(std::string& word);  ///< with its unit, in metres

 protected:
  /// Counts, while it lives, how many descriptions lie in each other; fails beyond what anybody
  /// means, long before the stack ends.
  class Depth {
   public:
    explicit Depth(ClauseReader& reader);
    ~Depth() { --reader_.depth_; }
    Depth(const Depth&) = delete;
    Depth& operator=(const Depth&) = delete;

   private:
    ClauseReader& reader_;
  };

 private:
  /// "that is horizontal and near a window": said of the class named just before. In brackets
  /// where an outer list goes on behind it.
  void that_is(Clause& clause);
  RelationTerm relation_term();
  double unit(int dimension, const std::string& what, std::string& word);

  int depth_ = 0;
};

}  // namespace scanchor
