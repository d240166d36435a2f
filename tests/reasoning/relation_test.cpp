#include "reasoning/relation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/math.hpp"
#include "core/random.hpp"
#include "reasoning/sdl_words.hpp"
#include "tests/reasoning/support/built.hpp"

namespace scanchor {
namespace {

using test::Plate;

Item item(const Plate& plate, std::int32_t id = 0) {
  auto items = make_items(test::make_surfaces({plate}), Eigen::Matrix3d::Identity());
  items[0].id = id;
  return items[0];
}

double value(Relation relation, const Plate& a, const Plate& b) {
  return relate({relation, {}}, item(a), item(b), {}).likelihood;
}

Eigen::Vector3d tilted(double degrees_off) {
  const double t = radians(degrees_off);
  return {std::sin(t), 0.0, std::cos(t)};
}

Plate random_plate(SequentialRandom& random) {
  Plate plate;
  plate.center = {random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(0, 2)};
  plate.normal = {random.normal(), random.normal(), random.normal()};
  if (random.chance(0.6))
    plate.normal = random.chance(0.5) ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitY();
  plate.along = {random.normal(), random.normal(), random.normal()};
  plate.length = random.uniform(0.3, 2.0);
  plate.width = random.uniform(0.2, 1.0) * plate.length;
  plate.tilt_sigma_deg = random.uniform(0.05, 2.0);
  return plate;
}

TEST(Relation, LimitsAreThePlainPredicates) {
  const Plate level;
  EXPECT_GT(value(Relation::parallel, level, {{0, 0, 1}, tilted(0.5)}), 0.99);
  EXPECT_LT(value(Relation::parallel, level, {{0, 0, 1}, tilted(12)}), 0.01);
  EXPECT_GT(value(Relation::orthogonal, level, {{0, 0, 1}, tilted(90)}), 0.99);
  EXPECT_LT(value(Relation::orthogonal, level, {{0, 0, 1}, tilted(70)}), 0.01);
  // S8, S9: what equation 2 lets pass for every pair of vectors.
  EXPECT_LT(value(Relation::parallel, level, {{0, 0, 1}, tilted(90)}), 0.01);
  EXPECT_LT(value(Relation::orthogonal, level, {{0, 0, 1}, tilted(180)}), 0.01);
}

TEST(Relation, AboveWantsOverlapAndHeight) {
  const auto desk = test::desk_plate();
  EXPECT_GT(value(Relation::above, test::screen_plate(), desk), 0.95);
  EXPECT_LT(value(Relation::above, desk, test::screen_plate()), 0.05);
  auto beside = test::screen_plate(4.0);  // S20: higher, but not over it
  EXPECT_LT(value(Relation::above, beside, desk), 0.05);
  EXPECT_GT(value(Relation::higher, beside, desk), 0.95);
}

TEST(Relation, OnNeedsContact) {
  const auto desk = test::desk_plate();
  Plate box_side{{1, 1.5, 0.84}, {0, 1, 0}, {1, 0, 0}, 0.3, 0.2};
  EXPECT_GT(value(Relation::on, box_side, desk), 0.9);
  EXPECT_GT(value(Relation::supports, desk, box_side), 0.9);
  box_side.center.z() = 1.3;
  EXPECT_LT(value(Relation::on, box_side, desk), 0.1);
}

TEST(Relation, DistancesByHand) {
  const Plate a{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 1.0, 1.0};
  const Plate side_by_side{{1.5, 0, 0}, {0, 0, 1}, {1, 0, 0}, 1.0, 1.0};
  EXPECT_NEAR(gap_distance(item(a), item(side_by_side)), 0.5, 1e-9);
  const Plate over{{0, 0, 0.7}, {0, 0, 1}, {1, 0, 0}, 0.2, 0.2};
  EXPECT_NEAR(gap_distance(item(a), item(over)), 0.7, 1e-9);
  const Plate through{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, 0.5, 0.5};
  EXPECT_NEAR(gap_distance(item(a), item(through)), 0.0, 1e-9);
}

TEST(Relation, CoplanarIgnoresDistanceWithinThePlane) {
  const Plate a{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}, 1.0, 1.0};
  EXPECT_GT(value(Relation::coplanar, a, {{2, 0, 1}, {0, 1, 0}, {1, 0, 0}, 1.0, 1.0}), 0.9);
  EXPECT_LT(value(Relation::coplanar, a, {{2, 0.3, 1}, {0, 1, 0}, {1, 0, 0}, 1.0, 1.0}), 0.01);
}

TEST(Relation, StackedNeedsNoCommonMiddle) {
  const Plate board{{0, 0, 1}, {0, 0, 1}, {1, 0, 0}, 1.0, 0.4};
  const Plate rest{{0.3, 0.1, 1.4}, {0, 0, 1}, {1, 0, 0}, 0.3, 0.15};
  EXPECT_GT(value(Relation::stacked, board, rest), 0.95) << "what a shadow left of a board";
  EXPECT_EQ(value(Relation::stacked, board, rest), value(Relation::stacked, rest, board));
  EXPECT_LT(value(Relation::aligned, board, rest), 0.05);
  const Plate aside{{0.9, 0, 1.4}, {0, 0, 1}, {1, 0, 0}, 1.0, 0.4};
  EXPECT_LT(value(Relation::stacked, board, aside), 0.01);
  const Plate same_level{{0.3, 0.1, 1.01}, {0, 0, 1}, {1, 0, 0}, 0.3, 0.15};
  EXPECT_LT(value(Relation::stacked, board, same_level), 0.05);
}

TEST(Relation, SameSizeForgivesOnlyTheSmallerOneThatIsCut) {
  const Plate a{{0, 0, 1}, {0, 0, 1}, {1, 0, 0}, 1.0, 0.3};
  Plate b = a;
  b.length = 0.7;
  const double plain = value(Relation::same_size, a, b);
  EXPECT_LT(plain, 0.05);
  b.hidden = 0.5;
  EXPECT_GT(value(Relation::same_size, a, b), 10.0 * plain);
  Plate larger_cut = a;
  larger_cut.hidden = 0.5;
  b.hidden = 0.0;
  EXPECT_LE(value(Relation::same_size, larger_cut, b), plain);
}

TEST(Relation, SidesAreSeenFromTheRobot) {
  Surrounding around;
  around.viewpoint = Eigen::Vector3d(0, -5, 1);
  const Plate b{{0, 0, 1}};
  const Plate left{{-2, 0, 1}};
  const auto of = [&](Relation r) {
    return relate({r, {}}, item(left), item(b), around).likelihood;
  };
  EXPECT_GT(of(Relation::left_of), 0.95);
  EXPECT_LT(of(Relation::right_of), 0.05);
  EXPECT_LT(of(Relation::behind), 0.05);
  EXPECT_GT(relate({Relation::behind, {}}, item({{0, 2, 1}}), item(b), around).likelihood, 0.95);
  EXPECT_NEAR(relate({Relation::left_of, {}}, item(left), item(b), {}).likelihood, 0.5, 1e-12);
}

TEST(Relation, PropertiesHoldForRandomPairs) {
  SequentialRandom random(11);
  for (int i = 0; i < 300; ++i) {
    const Plate a = random_plate(random);
    const Plate b = random_plate(random);
    const Item ia = item(a, 0);
    const Item ib = item(b, 1);
    Plate flipped = b;
    flipped.normal = -b.normal;
    const Item fb = item(flipped, 1);
    // A turn about the vertical and a move.
    const double yaw = random.uniform(0.0, 2.0 * pi);
    const Eigen::AngleAxisd turn(yaw, Eigen::Vector3d::UnitZ());
    const Eigen::Vector3d by(random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9));
    const auto move = [&](Plate p) {
      p.center = turn * p.center + by;
      p.normal = turn * p.normal;
      p.along = turn * p.along;
      return p;
    };
    for (const auto& word : relation_vocabulary()) {
      RelationTerm term{word.relation, {}};
      if (word.relation == Relation::elevation || word.relation == Relation::bottom ||
          word.relation == Relation::top) {
        term.range.low = 0.2;
        term.range.high = 0.9;
      }
      const double l = relate(term, ia, ib, {}).likelihood;
      ASSERT_TRUE(l >= 0.0 && l <= 1.0) << word.words;
      EXPECT_NEAR(relate(term, ia, fb, {}).likelihood, l, 1e-6)
          << word.words << ": the sign of a normal matters";
      EXPECT_NEAR(relate(term, item(move(a)), item(move(b)), {}).likelihood, l, 1e-5)
          << word.words << ": the frame matters";
      if (word.symmetric) {
        EXPECT_NEAR(relate(term, ib, ia, {}).likelihood, l, 1e-9)
            << word.words << " is not symmetric";
      }
    }
    const auto of = [&](Relation r, const Item& x, const Item& y) {
      return relate({r, {}}, x, y, {}).likelihood;
    };
    EXPECT_LE(of(Relation::above, ia, ib) + of(Relation::above, ib, ia), 1.0 + 1e-9);
    EXPECT_EQ(of(Relation::above, ia, ib), of(Relation::below, ib, ia));
    EXPECT_EQ(of(Relation::on, ia, ib), of(Relation::supports, ib, ia));
  }
}

TEST(Relation, MonotoneInWhatItMeasures) {
  const Plate level;
  double last_parallel = 2.0;
  double last_near = 2.0;
  for (double x = 0.0; x <= 20.0; x += 0.5) {
    const double parallel = value(Relation::parallel, level, {{0, 0, 1}, tilted(x)});
    EXPECT_LE(parallel, last_parallel + 5e-4);  // a plane in a thousand may lie any way
    last_parallel = parallel;
    const double near = value(Relation::near, level, {{1.0 + 0.1 * x, 0, 0}});
    EXPECT_LE(near, last_near + 1e-12);
    last_near = near;
  }
}

TEST(Relation, UncertaintySoftens) {
  Plate sure{{0, 0, 1}, tilted(3)};
  Plate unsure = sure;
  unsure.tilt_sigma_deg = 6.0;
  EXPECT_GT(value(Relation::parallel, {}, sure), 0.9);
  const double l = value(Relation::parallel, {}, unsure);
  EXPECT_LT(l, value(Relation::parallel, {}, sure) - 0.1);
  EXPECT_GT(l, 0.5) << "most faces of rooms that are nearly parallel are parallel";
}

TEST(Relation, FeaturesAndWords) {
  const Item desk = item(test::desk_plate());
  Range area;
  area.low = 0.9;
  area.high = 1.7;
  EXPECT_GT(feature(Feature::area, area, desk).likelihood, 0.9);
  EXPECT_NEAR(feature(Feature::area, area, desk).measured, 1.28, 1e-9);
  area.low = 2.0;
  area.high = INFINITY;
  EXPECT_LT(feature(Feature::area, area, desk).likelihood, 0.05);
  EXPECT_GT(horizontal(desk, {}).likelihood, 0.99);
  EXPECT_LT(vertical(desk, {}).likelihood, 0.01);
  EXPECT_GT(rectangular(desk).likelihood, 0.99);
  Plate ragged = test::desk_plate();
  ragged.fill = 0.6;
  EXPECT_LT(rectangular(item(ragged)).likelihood, 0.05);
  ragged.hidden = 0.5;  // what is missing may be in the shadow
  EXPECT_GT(rectangular(item(ragged)).likelihood, 0.5);
}

}  // namespace
}  // namespace scanchor
