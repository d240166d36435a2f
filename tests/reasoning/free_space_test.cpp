#include "reasoning/free_space.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/polygons.hpp"
#include "core/random.hpp"

namespace scanchor {
namespace {

Ring box(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

bool in_convex(const Ring& ring, const Eigen::Vector2d& p, double slack) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d e = ring[(i + 1) % ring.size()] - ring[i];
    const Eigen::Vector2d d = p - ring[i];
    if (e.x() * d.y() - e.y() * d.x() < slack * e.norm()) return false;
  }
  return true;
}

/// By the separating axis theorem: do two convex rings have more than borders in common?
bool overlap(const Ring& a, const Ring& b, double slack) {
  for (const auto* ring : {&a, &b}) {
    for (std::size_t i = 0; i < ring->size(); ++i) {
      const Eigen::Vector2d e = (*ring)[(i + 1) % ring->size()] - (*ring)[i];
      const Eigen::Vector2d n = Eigen::Vector2d(e.y(), -e.x()).normalized();
      double high = -1e9, low = 1e9;
      for (const auto& p : *ring) high = std::max(high, n.dot(p));
      const Ring& other = ring == &a ? b : a;
      for (const auto& p : other) low = std::min(low, n.dot(p));
      if (low >= high - slack) return false;
    }
  }
  return true;
}

Ring moved(Ring ring, const Eigen::Vector2d& by) {
  for (auto& p : ring) p += by;
  return ring;
}

TEST(FreeSpace, NearestFitIsThatOfAGrid) {
  SequentialRandom random(12);
  int fits = 0, none = 0;
  for (int round = 0; round < 40; ++round) {
    FreeSpace space;
    space.outer = {box(0, 0, 1.6, 0.8)};
    for (int k = 0; k < 6; ++k) {
      std::vector<Eigen::Vector2d> points;
      const Eigen::Vector2d at(random.uniform(0, 1.6), random.uniform(0, 0.8));
      for (int i = 0; i < 4; ++i)
        points.push_back(at +
                         Eigen::Vector2d(random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2)));
      space.obstacles.push_back(convex_hull(points));
    }
    const double a = random.uniform(0.1, 0.3), b = random.uniform(0.1, 0.25);
    const Ring shape = box(-a, -b, a, b);
    const Ring window = box(-1, -1, 3, 3);
    const Eigen::Vector2d wanted(random.uniform(0, 1.6), random.uniform(0, 0.8));
    const auto found = nearest_fit(space, shape, window, wanted);
    const auto free = [&](const Eigen::Vector2d& p, double slack) {
      if (p.x() < a - slack || p.x() > 1.6 - a + slack || p.y() < b - slack ||
          p.y() > 0.8 - b + slack)
        return false;
      for (const auto& obstacle : space.obstacles) {
        if (overlap(obstacle, moved(shape, p), slack)) return false;
      }
      return true;
    };
    double best = INFINITY;
    for (double x = 0.0; x <= 1.6; x += 0.01) {
      for (double y = 0.0; y <= 0.8; y += 0.01) {
        if (free({x, y}, 0.0)) best = std::min(best, (Eigen::Vector2d(x, y) - wanted).norm());
      }
    }
    if (!found) {
      EXPECT_EQ(best, INFINITY);
      ++none;
      continue;
    }
    ++fits;
    EXPECT_TRUE(free(*found, 1e-7)) << "round " << round;
    EXPECT_LE((*found - wanted).norm(), best + 1e-9);
  }
  EXPECT_GT(fits, 10);
  EXPECT_GT(none, 2);
}

TEST(FreeSpace, HolesAndWindowsAreKept) {
  FreeSpace space;
  space.outer = {box(0, 0, 1, 1)};
  space.holes = {box(0.4, 0.4, 0.6, 0.6)};
  const Ring shape = box(-0.1, -0.1, 0.1, 0.1);
  const auto found = nearest_fit(space, shape, box(0, 0, 1, 1), {0.5, 0.5});
  ASSERT_TRUE(found);
  EXPECT_NEAR((*found - Eigen::Vector2d(0.5, 0.5)).norm(), 0.2, 1e-9);
  EXPECT_FALSE(nearest_fit(space, shape, box(0.45, 0.45, 0.55, 0.55), {0.5, 0.5}));
  // A corner of free floor that only just fits.
  const auto exact = nearest_fit(space, box(-0.2, -0.2, 0.2, 0.2), box(0, 0, 1, 1), {0.5, 0.5});
  ASSERT_TRUE(exact);
  EXPECT_NEAR(std::abs(exact->x() - 0.5), 0.3, 1e-9);
  EXPECT_FALSE(nearest_fit(space, box(-0.21, -0.21, 0.21, 0.21), box(0, 0, 1, 1), {0.5, 0.5}));
}

TEST(FreeSpace, AreaTakesHolesOff) {
  FreeSpace space;
  space.outer = {{{0, 0}, {1, 0}, {1, 1}, {0.5, 0.5}, {0, 1}}};  // a notch from above
  space.holes = {box(0.1, 0.1, 0.3, 0.2)};
  EXPECT_NEAR(area_within(space, box(-1, -1, 2, 2)), 0.75 - 0.02, 1e-12);
  EXPECT_NEAR(area_within(space, box(0, 0, 0.2, 1)), 0.2 - 0.02 - 0.01, 1e-12);
  EXPECT_TRUE(in_convex(box(0, 0, 1, 1), {0.5, 0.5}, 0.0));
}

}  // namespace
}  // namespace scanchor
