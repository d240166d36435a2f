#include "reasoning/scene_extent.hpp"

#include <gtest/gtest.h>

#include "tests/reasoning/support/built.hpp"

namespace scanchor {
namespace {

struct Room {
  std::vector<Item> items;
  SceneExtent extent;
  double value(Extremum which, std::size_t item) const {
    return extent.extremum(which, items[item], {}).likelihood;
  }
};

Room room(const std::vector<test::Plate>& plates) {
  Room r;
  r.items = make_items(test::make_surfaces(plates), Eigen::Matrix3d::Identity());
  std::vector<Evidence> level;
  for (const auto& item : r.items) level.push_back(horizontal(item, {}));
  r.extent = SceneExtent(r.items, level);
  return r;
}

TEST(SceneExtent, FloorCeilingAndWallsAreTheEnds) {
  const auto r = room(test::paper_room());
  EXPECT_GT(r.value(Extremum::lowest, 0), 0.99);
  EXPECT_GT(r.value(Extremum::highest, 5), 0.99);
  EXPECT_LT(r.value(Extremum::lowest, 6), 0.01) << "a desk";
  for (std::size_t wall = 1; wall < 5; ++wall)
    EXPECT_GT(r.value(Extremum::outermost, wall), 0.9) << wall;
  EXPECT_LT(r.value(Extremum::outermost, 7), 0.1) << "a screen has the wall behind it";
  EXPECT_EQ(r.value(Extremum::cornered, 7), 0.0) << "asked elsewhere";
}

TEST(SceneExtent, ADeskIsNoFloorWhereWallsGoOnBelowIt) {
  auto plates = test::paper_room();
  plates.erase(plates.begin());  // the floor was not seen
  const auto r = room(plates);
  EXPECT_LT(r.value(Extremum::lowest, 5), 0.01);
  EXPECT_EQ(room({}).items.size(), 0U);
}

}  // namespace
}  // namespace scanchor
