#include "reasoning/support_relations.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"
#include "reasoning/relation_model.hpp"
#include "tests/reasoning/support/built.hpp"

namespace scanchor {
namespace {

using test::Plate;

Item item_of_plate(const Plate& plate) {
  return make_items(test::make_surfaces({plate}), Eigen::Matrix3d::Identity())[0];
}

Plate upright_front(double low, double high) {
  return {{0, 0, 0.5 * (low + high)}, {0, 1, 0}, {1, 0, 0}, 0.6, high - low};
}

TEST(SupportRelations, AFrontWhoseLowerEndIsInAShadowMayStandOnTheFloor) {
  const Item floor = item_of_plate({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 4.0, 3.0});
  Item seen = item_of_plate(upright_front(0.4, 1.0));
  EXPECT_LT(on_relation(seen, floor, {}).likelihood, 0.2);
  Item cut = seen;
  // The side that looks down.
  cut.open[cut.across.z() > 0.0 ? 3 : 2] = 1.0;
  EXPECT_GT(on_relation(cut, floor, {}).likelihood, on_relation(seen, floor, {}).likelihood + 0.2);
  EXPECT_GT(above_relation(cut, floor, {}).likelihood, 0.9);
}

TEST(SupportRelations, AFloorThatLeansIsMeasuredBelowTheThing) {
  const double lean = 0.01;  // [rad] 2 cm at the ends
  const Eigen::Vector3d normal(std::sin(lean), 0, std::cos(lean));
  const Item floor =
      item_of_plate({{0, 0, 0}, normal, {std::cos(lean), 0, -std::sin(lean)}, 4.0, 3.0});
  Plate low_end = upright_front(-0.018, 0.6);
  low_end.center.x() = 1.8;
  EXPECT_NEAR(top_under(floor, item_of_plate(low_end)), -0.018, 1e-3);
  EXPECT_NEAR(on_relation(item_of_plate(low_end), floor, {}).measured, 0.0, 1e-3);
}

TEST(SupportRelations, ShareIsThatOfDilatedFootprints) {
  SequentialRandom random(3);
  for (int i = 0; i < 20; ++i) {
    const Plate a{
        {random.uniform(-1, 1), random.uniform(-1, 1), 1}, {0, 0, 1}, {1, 0, 0}, 0.8, 0.5};
    const Plate b{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 1.2, 0.7};
    int inside = 0;
    constexpr int steps = 200;
    for (int u = 0; u < steps; ++u) {
      for (int v = 0; v < steps; ++v) {
        const double x = a.center.x() + 0.8 * ((u + 0.5) / steps - 0.5);
        const double y = a.center.y() + 0.5 * ((v + 0.5) / steps - 0.5);
        if (std::abs(x) <= 0.6 + 0.05 && std::abs(y) <= 0.35 + 0.05) ++inside;
      }
    }
    EXPECT_NEAR(share_over(item_of_plate(a), item_of_plate(b)), inside / double(steps * steps),
                0.01);
  }
}

TEST(SupportRelations, NothingIsOverWhatIsOutOfReach) {
  SequentialRandom random(4);
  for (int i = 0; i < 200; ++i) {
    Item lower = item_of_plate({{0, 0, 0.7}, {0, 0, 1}, {1, 0.3, 0}, 1.6, 0.8});
    lower.open = {random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1),
                  random.uniform(0, 1)};
    const Item upper = item_of_plate(
        {{random.uniform(-3, 3), random.uniform(-3, 3), 1.0}, {0, 1, 0}, {1, 0, 0}, 0.5, 0.4});
    if (plan_gap(upper, lower) <= overlap_reach(lower)) continue;
    EXPECT_EQ(above_relation(upper, lower, {}).likelihood, 0.0);
    EXPECT_EQ(on_relation(upper, lower, {}).likelihood, 0.0);
  }
}

TEST(SupportRelations, SidesGoOnTheMoreTheLessOfTheirEndWasSeen) {
  const RelationModel usual;  // whatever was fitted
  Item a = item_of_plate(upright_front(0.0, 1.0));
  for (const double open : {0.0, 0.5, 1.0}) {
    a.open.fill(open);
    double last = 1.0;
    for (double d = 0.0; d < 2.0; d += 0.1) {
      const double p = goes_on(a, 0, 1.0, d, usual);
      EXPECT_LE(p, last);
      last = p;
    }
  }
  EXPECT_GT(goes_on(a, 0, 1.0, 0.3, usual), 0.3);
  a.open.fill(0.0);
  EXPECT_LT(goes_on(a, 0, 1.0, 0.3, usual), 0.05);
}

}  // namespace
}  // namespace scanchor
