#include "perception/rectangle_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/math.hpp"
#include "core/random.hpp"

namespace scanchor {
namespace {

struct Truth {
  double length, width, angle;
  Eigen::Vector2d center;
};

/// Samples of a jittered lattice around a rectangle, sorted into inside and outside after lateral
/// noise; edges off by up to half a gap.
RectangleEvidence evidence_of(const Truth& truth, double spacing, double sigma,
                              SequentialRandom& random) {
  RectangleEvidence e;
  e.sigma = sigma;
  const Eigen::Vector2d u(std::cos(truth.angle), std::sin(truth.angle));
  const Eigen::Vector2d v(-u.y(), u.x());
  const double tilt = random.uniform(-0.5, 0.5);
  const double px = random.uniform();
  const double py = random.uniform();
  const int n = static_cast<int>(0.5 * (truth.length + truth.width) / spacing) + 6;
  for (int j = -n; j <= n; ++j) {
    for (int i = -n; i <= n; ++i) {
      const double x = (i + px) * spacing;
      const double y = (j + py) * spacing;
      const Eigen::Vector2d p(std::cos(tilt) * x - std::sin(tilt) * y,
                              std::sin(tilt) * x + std::cos(tilt) * y);
      const double beyond =
          std::max(std::abs(p.x()) - 0.5 * truth.length, std::abs(p.y()) - 0.5 * truth.width);
      const Eigen::Vector2d seen = p + sigma * Eigen::Vector2d(random.normal(), random.normal());
      const Eigen::Vector2d q = truth.center + seen.x() * u + seen.y() * v;
      if (beyond < 0.0)
        e.inside.push_back(q);
      else if (beyond < 1.5 * spacing)
        e.outside.push_back(q);
    }
  }
  const double l = 0.5 * truth.length;
  const double w = 0.5 * truth.width;
  const Eigen::Vector2d corner[4] = {{-l, -w}, {l, -w}, {l, w}, {-l, w}};
  for (int k = 0; k < 4; ++k) {
    const double shift = random.uniform(-0.4, 0.4) * spacing;
    Eigen::Vector2d a = corner[k];
    Eigen::Vector2d b = corner[(k + 1) % 4];
    const Eigen::Vector2d d = (b - a).normalized();
    a += shift * Eigen::Vector2d(d.y(), -d.x());
    b += shift * Eigen::Vector2d(d.y(), -d.x());
    e.edges.push_back({truth.center + a.x() * u + a.y() * v, truth.center + b.x() * u + b.y() * v,
                       EdgeKind::true_edge, spacing, 0.2 * spacing});
  }
  return e;
}

TEST(RectangleFit, IntervalsCoverTheTruthAndAreNarrow) {
  SequentialRandom random(21);
  constexpr int rounds = 400;
  int length = 0, width = 0, area = 0;
  double bias = 0.0;
  double breadth = 0.0;
  for (int round = 0; round < rounds; ++round) {
    Truth truth{random.uniform(0.5, 1.5),
                0.0,
                random.uniform(-1.5, 1.5),
                {random.normal(), random.normal()}};
    truth.width = truth.length * random.uniform(0.3, 0.9);
    const double spacing = random.uniform(0.01, 0.03);
    const RectangleFit fit =
        fit_rectangle(evidence_of(truth, spacing, random.chance(0.5) ? 0.002 : 0.0, random));
    const FittedRectangle& r = fit.rectangle;
    length += r.length.low <= truth.length && truth.length <= r.length.high;
    width += r.width.low <= truth.width && truth.width <= r.width.high;
    area +=
        fit.area.low <= truth.length * truth.width && truth.length * truth.width <= fit.area.high;
    bias += (r.width.value - truth.width) / spacing / rounds;
    breadth += (r.width.high - r.width.low) / spacing / rounds;
    EXPECT_NEAR(r.length.value, truth.length, spacing);
    EXPECT_NEAR(std::remainder(r.angle - truth.angle, pi), 0.0, spacing / truth.width);
    EXPECT_LT((r.center - truth.center).norm(), spacing);
    EXPECT_FALSE(r.length.at_least);
    EXPECT_GT(fit.support[0] + fit.support[1] + fit.support[2] + fit.support[3], 3.5);
  }
  for (const int covered : {length, width, area}) {
    EXPECT_GE(covered, rounds * 90 / 100);
    EXPECT_LE(covered, rounds * 99 / 100);
  }
  EXPECT_LT(std::abs(bias), 0.02);
  EXPECT_LT(breadth, 0.5) << "sides oblique to the lattice are known far better than a spacing";
}

TEST(RectangleFit, ASideInShadowMakesTheSizeAtLeast) {
  SequentialRandom random(5);
  RectangleEvidence e = evidence_of({1.0, 0.6, 0.0, {0, 0}}, 0.02, 0.0, random);
  e.edges[1].kind = EdgeKind::occlusion;  // the right side
  std::erase_if(e.outside, [](const Eigen::Vector2d& p) { return p.x() > 0.5; });
  const RectangleFit fit = fit_rectangle(e);
  EXPECT_TRUE(fit.rectangle.length.at_least);
  EXPECT_FALSE(fit.rectangle.width.at_least);
  EXPECT_TRUE(fit.censored[0]);
  EXPECT_FALSE(fit.censored[1] || fit.censored[2] || fit.censored[3]);
}

TEST(RectangleFit, ABiteOutOfASideDoesNotMoveIt) {
  SequentialRandom random(6);
  const Truth truth{1.2, 0.8, 0.0, {0, 0}};
  RectangleEvidence e = evidence_of(truth, 0.02, 0.0, random);
  // A shadow eats the middle of the upper side, 0.4 m wide and 0.3 m deep.
  const auto bitten = [](const Eigen::Vector2d& p) { return std::abs(p.x()) < 0.2 && p.y() > 0.1; };
  std::erase_if(e.inside, bitten);
  std::erase_if(e.outside, bitten);
  e.edges.erase(e.edges.begin() + 2);
  for (const auto& [from, to] :
       {std::pair<Eigen::Vector2d, Eigen::Vector2d>{{0.6, 0.4}, {0.2, 0.4}},
        {{-0.2, 0.4}, {-0.6, 0.4}}}) {
    e.edges.push_back({from, to, EdgeKind::true_edge, 0.02, 0.004});
  }
  e.edges.push_back({{0.2, 0.4}, {0.2, 0.1}, EdgeKind::occlusion, 0.02, 0.004});
  e.edges.push_back({{0.2, 0.1}, {-0.2, 0.1}, EdgeKind::occlusion, 0.02, 0.004});
  e.edges.push_back({{-0.2, 0.1}, {-0.2, 0.4}, EdgeKind::occlusion, 0.02, 0.004});
  const RectangleFit fit = fit_rectangle(e);
  EXPECT_NEAR(fit.rectangle.length.value, 1.2, 0.01);
  EXPECT_NEAR(fit.rectangle.width.value, 0.8, 0.01);
  EXPECT_FALSE(fit.rectangle.width.at_least);
}

TEST(RectangleFit, AnUncertainPlaneWidensTheInterval) {
  SequentialRandom random(7);
  RectangleEvidence e = evidence_of({1.0, 0.6, 0.2, {0, 0}}, 0.02, 0.0, random);
  const double before =
      fit_rectangle(e).rectangle.length.high - fit_rectangle(e).rectangle.length.low;
  e.plane_variance = [](const auto&, const auto&, const auto&) { return 0.01 * 0.01; };
  const Measured after = fit_rectangle(e).rectangle.length;
  EXPECT_NEAR(after.high - after.low, std::hypot(before, 2 * 1.96 * 0.01), 0.002);
}

TEST(RectangleFit, NoEvidenceNoRectangle) {
  EXPECT_EQ(fit_rectangle({}).rectangle.length.value, 0.0);
}

// A box with a second one claimed along half of a side: the size holds both readings.
TEST(RectangleFit, WhatSticksOutIsInTheInterval) {
  RectangleEvidence e;
  const Ring stepped = {{0, 0}, {2, 0}, {2, 1.5}, {1.2, 1.5}, {1.2, 1}, {0, 1}};
  for (std::size_t i = 0; i < stepped.size(); ++i)
    e.edges.push_back({stepped[i], stepped[(i + 1) % 6], EdgeKind::true_edge, 0.02, 0.004});
  const RectangleFit fit = fit_rectangle(e);
  EXPECT_NEAR(fit.rectangle.width.value, 1.5, 0.01);
  EXPECT_LT(fit.rectangle.width.low, 1.0);
  EXPECT_GT(fit.rectangle.width.low, 0.9);
  EXPECT_NEAR(fit.loose_area, 0.4, 0.02);
}

// One row of samples, so that the outline's sides cross: nobody knows how broad it is, but it does
// not reach farther than the gaps to both sides.
TEST(RectangleFit, ASingleRowIsAsBroadAsItsGaps) {
  RectangleEvidence e;
  const auto add = [&](const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    e.edges.push_back({from, to, EdgeKind::true_edge, 0.02, 0.0});
  };
  add({1.0, -0.01}, {0.0, -0.01});  // faces up
  add({0.0, 0.01}, {1.0, 0.01});
  add({1.0, 0.01}, {1.0, 0.02});
  add({0.0, 0.02}, {0.0, 0.01});
  const RectangleFit fit = fit_rectangle(e);
  EXPECT_LT(fit.rectangle.width.value, 0.01);
  EXPECT_GE(fit.rectangle.width.high, 0.02);
  EXPECT_LE(fit.rectangle.width.high, 0.0401);
}

// The first row of points may be on the wrong side where another surface begins, and nowhere else.
TEST(RectangleFit, ASideThatTouchesAnotherSurfaceIsKnownLessWell) {
  SequentialRandom random(21);
  RectangleEvidence e = evidence_of({1.2, 0.6, 0.3, {0.1, 0.2}}, 0.02, 0.0, random);
  e.foot = Eigen::Vector2d(5.0, 5.0);
  e.inside_height.assign(e.inside.size(), 0.0);
  const auto breadth = [&](double beyond) {
    e.outside_height.assign(e.outside.size(), beyond);
    const FittedRectangle r = fit_rectangle(e).rectangle;
    return r.width.high - r.width.low;
  };
  const double far = breadth(-50.0);
  const double near = breadth(-4.0);
  EXPECT_GT(near, far + 0.01);
  EXPECT_LT(near, far + 0.05);  // 2 x 1.96 x sqrt(2 x 0.1) gaps
}

}  // namespace
}  // namespace scanchor
