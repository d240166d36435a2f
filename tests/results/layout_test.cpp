#include "results/layout.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace scanchor {
namespace {

TEST(Layout, BoxesOverlapOnlyWhenTheyDo) {
  const Box2 a{0, 0, 10, 10};
  EXPECT_TRUE(a.overlaps({9, 9, 5, 5}));
  EXPECT_FALSE(a.overlaps({10, 0, 5, 5}));
  EXPECT_EQ(a.nearest({20, 5}), Eigen::Vector2d(10, 5));
}

TEST(Layout, PlacesOneLabelRightBesideItsAnchor) {
  const auto places = place_labels({{{100, 100}, {60, 20}, 0}}, {}, {0, 0, 200, 200});
  ASSERT_TRUE(places[0].placed);
  EXPECT_LT((places[0].box.nearest({100, 100}) - Eigen::Vector2d(100, 100)).norm(), 9.0);
  EXPECT_FALSE(places[0].box.contains({100, 100}));
}

// Property: whatever the crowd, no two boxes overlap, none leaves the area, none covers an
// obstacle, the same twice.
TEST(Layout, NeverOverlaps) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    SequentialRandom random(seed);
    std::vector<LabelRequest> requests;
    for (int i = 0; i < 10 + int(seed) * 12; ++i) {
      requests.push_back({{random.uniform(-20, 820), random.uniform(-20, 620)},
                          {random.uniform(20, 150), 20},
                          random.uniform()});
    }
    const std::vector<Box2> obstacles = {{600, 0, 200, 300}, {0, 550, 150, 50}};
    const Box2 area{0, 40, 800, 560};
    const auto places = place_labels(requests, obstacles, area);
    const auto again = place_labels(requests, obstacles, area);
    std::size_t placed = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      EXPECT_EQ(places[i].placed, again[i].placed);
      EXPECT_EQ(places[i].box.x, again[i].box.x);
      if (!places[i].placed) continue;
      ++placed;
      const Box2& box = places[i].box;
      EXPECT_GE(box.x, area.x);
      EXPECT_GE(box.y, area.y);
      EXPECT_LE(box.x + box.w, area.x + area.w);
      EXPECT_LE(box.y + box.h, area.y + area.h);
      for (const Box2& obstacle : obstacles) EXPECT_FALSE(box.overlaps(obstacle));
      for (std::size_t k = 0; k < i; ++k) {
        if (places[k].placed) {
          EXPECT_FALSE(box.overlaps(places[k].box)) << seed << ": " << i << ", " << k;
        }
      }
    }
    EXPECT_GT(placed, requests.size() / 2) << seed;
  }
}

TEST(Layout, TheImportantOneIsPlacedFirst) {
  // One box fits.
  const Box2 area{0, 0, 64, 24};
  const auto places =
      place_labels({{{32, 23.9}, {60, 12}, 1}, {{32, 23.9}, {60, 12}, 2}}, {}, area);
  EXPECT_FALSE(places[0].placed);
  EXPECT_TRUE(places[1].placed);
}

}  // namespace
}  // namespace scanchor
