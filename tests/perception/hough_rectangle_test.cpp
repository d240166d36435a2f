#include "perception/hough_rectangle.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/math.hpp"
#include "core/random.hpp"

namespace scanchor {
namespace {

Polygon turned_box(double length, double width, double angle, double waver, std::uint64_t seed) {
  SequentialRandom random(seed);
  Polygon polygon;
  const Ring corners = {{-length / 2, -width / 2},
                        {length / 2, -width / 2},
                        {length / 2, width / 2},
                        {-length / 2, width / 2}};
  for (std::size_t c = 0; c < 4; ++c) {
    const Eigen::Vector2d d = corners[(c + 1) % 4] - corners[c];
    const Eigen::Vector2d u = d.normalized();
    for (double t = 0.0; t < d.norm(); t += 0.015) {
      const Eigen::Vector2d p =
          corners[c] + t * u + random.uniform(-waver, waver) * Eigen::Vector2d(-u.y(), u.x());
      polygon.outer.emplace_back(std::cos(angle) * p.x() - std::sin(angle) * p.y(),
                                 std::sin(angle) * p.x() + std::cos(angle) * p.y());
    }
  }
  return polygon;
}

TEST(HoughRectangle, FindsARectangleAtAnyAngle) {
  for (int k = 0; k < 12; ++k) {
    const double angle = radians(15.0 * k + 2.0);
    const Polygon polygon = turned_box(0.57, 0.42, angle, 0.006, static_cast<std::uint64_t>(k));
    const auto corners = hough_rectangle({polygon});
    ASSERT_TRUE(corners) << degrees(angle);
    const Ring ring(corners->begin(), corners->end());
    EXPECT_NEAR(ring_area(ring), 0.57 * 0.42, 0.05 * 0.57 * 0.42)
        << "one cell of 1 cm on each side is 4 %";
    for (std::size_t i = 0; i < 4; ++i) {
      const Eigen::Vector2d a = ring[(i + 1) % 4] - ring[i];
      const Eigen::Vector2d b = ring[(i + 2) % 4] - ring[(i + 1) % 4];
      EXPECT_LT(std::abs(a.dot(b)) / (a.norm() * b.norm()), std::sin(radians(10.0)));
    }
  }
}

TEST(HoughRectangle, FourLinesOfARectangleAreMergedToFour) {
  const auto lines = hough_lines({turned_box(1.2, 0.8, 0.3, 0.004, 1)});
  ASSERT_GE(lines.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    const double off = std::remainder(lines[i].angle - 0.3, pi / 2);
    EXPECT_NEAR(off, 0.0, radians(1.5));
    const bool across = std::abs(std::remainder(lines[i].angle - 0.3, pi)) < 0.1;
    EXPECT_NEAR(std::abs(lines[i].offset), across ? 0.6 : 0.4, 0.01);
  }
}

TEST(HoughRectangle, OtherShapesAreNone) {
  Polygon circle;
  for (int i = 0; i < 200; ++i)
    circle.outer.emplace_back(0.4 * std::cos(i * 2 * pi / 200), 0.4 * std::sin(i * 2 * pi / 200));
  EXPECT_FALSE(hough_rectangle({circle}));
  const Polygon triangle{{{0, 0}, {1, 0}, {0.5, 0.8}}, {}, {}};
  EXPECT_FALSE(hough_rectangle({triangle}));
  const Polygon lozenge{{{0, 0}, {1, 0}, {1.5, 0.8}, {0.5, 0.8}}, {}, {}};
  EXPECT_FALSE(hough_rectangle({lozenge})) << "58 degrees";
  EXPECT_FALSE(hough_rectangle({}));
}

}  // namespace
}  // namespace scanchor
