#include "reasoning/query_match.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "core/random.hpp"
#include "reasoning/likelihood.hpp"
#include "tests/reasoning/support/labelled.hpp"

namespace scanchor {
namespace {

/// Every thing with every other, over and over, no memory, no early end; orders by listing all
/// subsets of the rivals.
class EveryAnswer {
 public:
  explicit EveryAnswer(const SceneThings& scene) : scene_(scene) {}

  double probability(const QueryRef& ref, std::int32_t id) const {
    const double before = unordered(ref, id);
    if (!ref.rank) return before;
    std::vector<double> better;
    for (std::int32_t other = 0; other < scene_.size(); ++other) {
      if (other == id || scene_.probability(other, ref.classes) < 0.01) continue;
      if (unordered(ref, other) < 1e-3) continue;
      const double sure = weakest(ref, other) >= 0.5 ? 1.0 : unordered(ref, other);
      better.push_back(sure * is_better(*ref.rank, other, id));
    }
    double place = 0.0;
    for (std::size_t subset = 0; subset < (std::size_t{1} << better.size()); ++subset) {
      double p = 1.0;
      int ahead = 0;
      for (std::size_t k = 0; k < better.size(); ++k) {
        const bool in = (subset >> k & 1) != 0;
        ahead += in ? 1 : 0;
        p *= in ? better[k] : 1.0 - better[k];
      }
      if (ahead == ref.place - 1) place += p;
    }
    return before * place;
  }

 private:
  double unordered(const QueryRef& ref, std::int32_t id) const {
    double p = scene_.probability(id, ref.classes);
    if (p < 0.01) return 0.0;
    for (const auto& clause : ref.clauses) p *= clause_value(clause, id);
    return p;
  }
  double weakest(const QueryRef& ref, std::int32_t id) const {
    double w = scene_.probability(id, ref.classes);
    for (const auto& clause : ref.clauses) w = std::min(w, clause_weakest(clause, id));
    return w;
  }
  double clause_value(const QueryClause& clause, std::int32_t id) const {
    double best = 0.0;
    double none = 1.0;
    for (std::int32_t t = 0; t < scene_.size(); ++t) {
      if (t == id) continue;
      double value = probability(clause.targets.front(), t);
      if (clause.kind == QueryClause::Kind::with) {
        value *= scene_.held_by(t, id).likelihood;
      } else {
        for (const auto& term : clause.relations) value *= scene_.relate(term, id, t).likelihood;
      }
      best = std::max(best, value);
      none *= 1.0 - value;
    }
    const double seen = 1.0 - scene_.item(id).area.hidden;
    return clause.negated ? seen * none + 0.5 * (1.0 - seen) : best;
  }
  double clause_weakest(const QueryClause& clause, std::int32_t id) const {
    if (clause.negated) return clause_value(clause, id);
    double best = -1.0;
    double result = 0.0;
    for (std::int32_t t = 0; t < scene_.size(); ++t) {
      if (t == id) continue;
      double value = probability(clause.targets.front(), t);
      double w = weakest(clause.targets.front(), t);
      if (clause.kind == QueryClause::Kind::with) {
        const double l = scene_.held_by(t, id).likelihood;
        value *= l;
        w = std::min(w, l);
      }
      for (const auto& term : clause.relations) {
        const double l = scene_.relate(term, id, t).likelihood;
        value *= l;
        w = std::min(w, l);
      }
      if (value > best) {
        best = value;
        result = w;
      }
    }
    return result;
  }
  double is_better(RankKey key, std::int32_t a, std::int32_t b) const {
    const Item& x = scene_.item(a);
    const Item& y = scene_.item(b);
    const auto less = [](double p, double q, double s1, double s2) {
      return upper_likelihood(p, q, std::max(std::hypot(s1, s2), 1e-9));
    };
    if (key == RankKey::highest) return less(-x.z, -y.z, x.z_sigma, y.z_sigma);
    if (key == RankKey::largest)
      return less(-x.area.value, -y.area.value, x.area.sigma, y.area.sigma);
    const Eigen::Vector3d eye = *scene_.around().viewpoint;
    return less((x.center - eye).norm(), (y.center - eye).norm(), x.extension.sigma,
                y.extension.sigma);
  }
  const SceneThings& scene_;
};

TEST(QueryMatch, EqualsBruteForceOnRandomScenes) {
  const char* const questions[] = {
      "screen on a desk",
      "desk with no screen",
      "desk with a screen",
      "the nearest chair",
      "second largest desk",
      "the highest screen on a desk near a window",
      "chair near a desk that is near a window and not near a door",
      "thing within 1 m of a screen and not on a desk",
      "chair near the largest desk",
      "screen above the second nearest desk with no chair",
      "chair left of a desk and lower than a window",
  };
  const char* const labels[] = {"desk", "monitor", "chair", "window", "door", "unknown"};
  SequentialRandom random(23);
  std::size_t compared = 0;
  for (int s = 0; s < 200; ++s) {
    std::vector<test::Named> named;
    for (int i = 0, n = 2 + static_cast<int>(random.below(9)); i < n; ++i) {
      test::Named thing;
      const auto way = random.below(3);
      thing.plate.center = {random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(0, 1.5)};
      thing.plate.normal = way == 0   ? Eigen::Vector3d::UnitX()
                           : way == 1 ? Eigen::Vector3d::UnitY()
                                      : Eigen::Vector3d::UnitZ();
      thing.plate.along = {random.normal(), random.normal(), random.normal()};
      thing.plate.length = random.uniform(0.3, 1.6);
      thing.plate.width = random.uniform(0.3, 1.0) * thing.plate.length;
      thing.plate.hidden = random.chance(0.3) ? random.uniform(0.1, 0.9) : 0.0;
      thing.label = labels[random.below(6)];
      thing.probability = random.uniform(0.3, 1.0);
      named.push_back(thing);
    }
    const auto scene = test::labelled(named);
    const SceneThings things(scene.surfaces, test::office(), scene.labelling);
    const EveryAnswer brute(things);
    for (const auto* question : questions) {
      const Query query = parse_query(question, test::office());
      QueryMatcher matcher(things);
      std::vector<double> p(named.size(), 0.0);
      for (const auto& m : matcher.match(query.refs.front())) p[m.id] = m.probability;
      for (std::size_t i = 0; i < named.size(); ++i) {
        const double expected = brute.probability(query.refs.front(), static_cast<std::int32_t>(i));
        ASSERT_NEAR(p[i], expected, 1e-9) << question << " " << i << " of scene " << s;
        compared += expected > 1e-6 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(compared, 800U);
}

TEST(QueryMatch, PlacesBeyondAllThingsAreNobodys) {
  auto scene = test::labelled({{test::desk_plate(), "desk"}, {test::screen_plate(), "monitor"}});
  const SceneThings things(scene.surfaces, test::office(), scene.labelling);
  const Query query = parse_query("2147483647th highest thing", test::office());
  QueryMatcher matcher(things);
  for (const auto& m : matcher.match(query.refs.front())) EXPECT_EQ(m.rank, 0.0);
}

TEST(QueryMatch, NearestToWantsWhatItIsTo) {
  auto scene =
      test::labelled({{test::desk_plate(), "desk", 0.8}, {test::screen_plate(), "monitor", 0.9}});
  const SceneThings things(scene.surfaces, test::office(), scene.labelling);
  const Query found = parse_query("screen nearest to a desk", test::office());
  const Query missed = parse_query("screen nearest to a door", test::office());
  QueryMatcher matcher(things);
  const RefMatch& screen = matcher.match(found.refs.front()).front();
  EXPECT_TRUE(screen.holds());
  EXPECT_EQ(screen.rank_to, 0);
  EXPECT_NEAR(screen.probability, 0.8 * 0.9, 1e-9);
  EXPECT_FALSE(matcher.match(missed.refs.front()).front().holds());
}

TEST(QueryMatch, TargetsHaveThePlaceThatIsSaidOfThem) {
  test::Plate lower = test::desk_plate(), near_it = test::screen_plate();
  test::Plate upper = lower;
  upper.center += Eigen::Vector3d(5.0, 0.0, 0.5);
  auto scene = test::labelled({{lower, "desk"}, {near_it, "monitor"}, {upper, "desk"}});
  const SceneThings things(scene.surfaces, test::office(), scene.labelling);
  QueryMatcher matcher(things);
  const Query right = parse_query("screen near the lowest desk", test::office());
  const Query wrong = parse_query("screen near the highest desk", test::office());
  EXPECT_TRUE(matcher.match(right.refs.front()).front().holds());
  EXPECT_FALSE(matcher.match(wrong.refs.front()).front().holds());
}

TEST(QueryMatch, CountsMayBeDenied) {
  auto scene =
      test::labelled({{test::desk_plate(), "desk", 1.0}, {test::screen_plate(), "monitor", 0.9}});
  const SceneThings things(scene.surfaces, test::office(), scene.labelling);
  QueryMatcher matcher(things);
  const Query one = parse_query("desk with exactly 1 screen", test::office());
  const Query not_one = parse_query("desk not with exactly 1 screen", test::office());
  const Query not_two = parse_query("desk not with 2 screens", test::office());
  const double p = matcher.match(one.refs.front()).front().probability;
  EXPECT_GT(p, 0.5);
  EXPECT_NEAR(matcher.match(not_one.refs.front()).front().probability, 1.0 - p, 1e-9);
  EXPECT_NEAR(matcher.match(not_two.refs.front()).front().probability, 1.0, 1e-9);
}

TEST(QueryMatch, SidesNeedAPlaceToLookFrom) {
  auto scene = test::labelled({{test::desk_plate(), "desk"}, {test::screen_plate(), "monitor"}});
  scene.surfaces.sensor_positions.clear();
  const SceneThings things(scene.surfaces, test::office(), scene.labelling);
  for (const auto* question : {"nearest desk", "screen left of a desk", "leftmost desk"}) {
    const Query query = parse_query(question, test::office());
    QueryMatcher matcher(things);
    EXPECT_THROW(matcher.match(query.refs.front()), Error) << question;
  }
  const Query query = parse_query("screen nearest to a desk", test::office());
  EXPECT_EQ(QueryMatcher(things).match(query.refs.front()).size(), 1U);
}

}  // namespace
}  // namespace scanchor
