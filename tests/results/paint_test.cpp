#include "results/paint.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "core/random.hpp"
#include "tests/results/samples.hpp"

namespace scanchor {
namespace {

double total(const std::vector<float>& shares) {
  return std::accumulate(shares.begin(), shares.end(), 0.0);
}

TEST(Paint, CoverageOfARectangleIsExact) {
  const auto shares = coverage({{{1.25, 1.5}, {3.5, 1.5}, {3.5, 3.0}, {1.25, 3.0}}}, 5, 5);
  EXPECT_NEAR(shares[1 * 5 + 1], 0.75 * 0.5, 1e-6);
  EXPECT_NEAR(shares[1 * 5 + 2], 0.5, 1e-6);
  EXPECT_NEAR(shares[2 * 5 + 2], 1.0, 1e-6);
  EXPECT_NEAR(shares[2 * 5 + 3], 0.5, 1e-6);
  EXPECT_EQ(shares[3 * 5 + 2], 0.0F);
}

// Property: the sum over all pixels is the area of the triangle, whichever way it turns.
TEST(Paint, CoverageAddsUpToTheArea) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SequentialRandom random(seed);
    Path t;
    for (int i = 0; i < 3; ++i) t.emplace_back(random.uniform(0, 40), random.uniform(0, 30));
    const Eigen::Vector2d u = t[1] - t[0];
    const Eigen::Vector2d v = t[2] - t[0];
    EXPECT_NEAR(total(coverage({t}, 40, 30)), std::abs(u.x() * v.y() - u.y() * v.x()) / 2, 1e-3)
        << seed;
  }
}

TEST(Paint, HolesStayOpenAndOutsideIsCutOff) {
  const Path outer = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  const Path hole = {{3, 3}, {3, 6}, {6, 6}, {6, 3}};
  EXPECT_NEAR(total(coverage({outer, hole}, 10, 10)), 91.0, 1e-4);
  EXPECT_NEAR(total(coverage({{{-5, -5}, {5, -5}, {5, 5}, {-5, 5}}}, 10, 10)), 25.0, 1e-4);
  EXPECT_NEAR(total(coverage({{{5, 2}, {50, 2}, {50, 3}, {5, 3}}}, 10, 10)), 5.0, 1e-4);
}

TEST(Paint, StrokeHasItsWidthAndClosedCorners) {
  VectorPicture picture{60, 60, {}};
  picture.stroke_rectangle(10, 10, 40, 40, {0, 0, 0}, 4.0, 8.0);
  const Image image = to_image(picture);
  // Along the middle row the stroke is 4 pixels wide on each side.
  int dark = 0;
  for (int x = 0; x < 60; ++x) dark += samples::pixel(image, x, 30).r < 128 ? 1 : 0;
  EXPECT_EQ(dark, 8);
  // Along the rounded corner nothing is open: walk the arc.
  for (int i = 0; i <= 20; ++i) {
    const double a = M_PI + M_PI / 2 * i / 20;
    const int x = int(18 + 8 * std::cos(a));
    const int y = int(18 + 8 * std::sin(a));
    EXPECT_LT(samples::pixel(image, x, y).r, 100) << i;
  }
}

TEST(Paint, DashesLeaveGaps) {
  VectorPicture picture{100, 10, {}};
  picture.line({0, 5}, {100, 5}, {0, 0, 0}, 2.0, {10, 10});
  const Image image = to_image(picture);
  EXPECT_LT(samples::pixel(image, 5, 5).r, 10);
  EXPECT_GT(samples::pixel(image, 15, 5).r, 245);
  EXPECT_LT(samples::pixel(image, 25, 5).r, 10);
}

TEST(Paint, TextIsWhereItsAnchorSays) {
  for (const TextAnchor anchor : {TextAnchor::start, TextAnchor::middle, TextAnchor::end}) {
    VectorPicture picture{200, 40, {}};
    picture.text(100, 30, "HHHH", 20, {0, 0, 0}, anchor);
    const Image image = to_image(picture);
    int low = 200, high = 0;
    for (int x = 0; x < 200; ++x) {
      for (int y = 0; y < 40; ++y) {
        if (samples::pixel(image, x, y).r < 128) {
          low = std::min(low, x);
          high = std::max(high, x);
        }
      }
    }
    const double middle = (low + high) / 2.0;
    const double expected = anchor == TextAnchor::middle  ? 100.0
                            : anchor == TextAnchor::start ? 130.0
                                                          : 70.0;
    EXPECT_NEAR(middle, expected, 3.0);
  }
}

TEST(Paint, CopiesWithClipping) {
  Image image = blank_image(10, 10, {1, 2, 3});
  copy_into(image, blank_image(6, 6, {9, 9, 9}), 7, -2);
  EXPECT_EQ(samples::count(image, {9, 9, 9}), 12u);
  EXPECT_EQ(samples::pixel(image, 7, 3), (Color{9, 9, 9}));
  copy_into(image, blank_image(6, 6, {9, 9, 9}), 40, 40);
  EXPECT_EQ(samples::count(image, {9, 9, 9}), 12u);
}

TEST(Paint, ScaleGivesMorePixels) {
  VectorPicture picture{20, 10, {}};
  picture.fill_rectangle(5, 2, 10, 4, {255, 0, 0});
  const Image image = to_image(picture, 3.0);
  EXPECT_EQ(image.width, 60);
  EXPECT_EQ(samples::count(image, {255, 0, 0}), 30u * 12u);
}

}  // namespace
}  // namespace scanchor
