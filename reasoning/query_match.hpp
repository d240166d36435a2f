#pragma once
// A description held against everything in a labelled scene.

#include <algorithm>
#include <map>
#include <vector>

#include "reasoning/query.hpp"
#include "reasoning/scene_things.hpp"

namespace scanchor {

/// One clause of a question held against one thing.
struct ClauseMatch {
  double value = 1.0;    ///< P(it holds), the targets' own probability included
  double weakest = 1.0;  ///< the least likely step of its proof, further in as well
  double own = 1.0;      ///< the same, the targets taken for certain
  bool unseen = false;   ///< where the thing that is denied would be, was not seen: cannot tell
  Evidence evidence;     ///< of its weakest relation
  std::vector<std::int32_t> targets;
  const QueryClause* clause = nullptr;
};

/// A whole description held against one thing.
struct RefMatch {
  std::int32_t id = 0;
  double of_class = 0.0;      ///< P(it is of the class)
  double probability = 0.0;   ///< that all of it holds: the product of its steps
  double weakest = 0.0;       ///< the least likely step but the order
  double rank = 1.0;          ///< P(it has the place in the order that was asked for)
  double key = 0.0;           ///< what it is put in order by, in metres, square metres or radians
  std::int32_t rank_to = -1;  ///< "nearest to a door": which; -1: from the robot, or there is none
  std::vector<ClauseMatch> clauses;
  /// Every step is likelier than not, and nothing was left unseen.
  [[nodiscard]] bool holds() const;
  /// The least likely step of what is said of another thing's target, the order included.
  [[nodiscard]] double as_target() const { return std::min(weakest, rank); }
};

class QueryMatcher {
 public:
  explicit QueryMatcher(const SceneThings& scene) : scene_(scene) {}

  /// All things that may be of the class (at least 1 %), by rising id. Throws Error(wrong_usage)
  /// where sides or "nearest" are asked for and nobody knows where the robot stood.
  const std::vector<RefMatch>& match(const QueryRef& ref);

 private:
  ClauseMatch hold(const QueryClause& clause, std::int32_t id);
  ClauseMatch hold_relation(const QueryClause& clause, std::int32_t id);
  ClauseMatch hold_with(const QueryClause& clause, std::int32_t id);
  ClauseMatch hold_between(const QueryClause& clause, std::int32_t id);
  void put_in_order(const QueryRef& ref, std::vector<RefMatch>& matches);
  void need_viewpoint(const std::string& words) const;
  /// Value to be small for the first place, and its deviation. "Nearest to a door" wants the door.
  std::pair<double, double> key_of(const QueryRef& ref, RefMatch& of);

  const SceneThings& scene_;
  std::map<const QueryRef*, std::vector<RefMatch>> known_;
};

}  // namespace scanchor
