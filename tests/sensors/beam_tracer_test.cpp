#include "sensors/beam_tracer.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/sensors/support/targets.hpp"

namespace scanchor {
namespace {

using testing::at;
using testing::box_instance;

/// Two plates whose edges meet at y = 0: the left one at `near`, the right one at `far`.
Scene step(double near, double far) {
  Scene scene = testing::empty_scene();
  scene.instances.push_back(box_instance(1, {0.02, 8, 8}, at(near + 0.01, 4, 0)));
  scene.instances.push_back(box_instance(2, {0.02, 16, 8}, at(far + 0.01, 0, 0)));
  return scene;
}

/// `count` times the same beam: parallel to x at the offset y.
BeamColumns beams_at(double y, std::size_t count) {
  BeamColumns beams;
  beams.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    beams.origin_x[k] = beams.origin_z[k] = beams.direction_y[k] = beams.direction_z[k] = 0.0;
    beams.origin_y[k] = y;
    beams.direction_x[k] = 1.0;
  }
  return beams;
}

LineReturns trace(const World& world, const LidarOptions& o, const BeamColumns& beams,
                  std::uint8_t straddles = 1) {
  const BeamTracer tracer(world, o, 3);
  LineReturns returns;
  tracer.trace_middles(beams, returns);
  const std::vector<std::uint8_t> mask(returns.size(), straddles);
  tracer.refine(0, beams, mask, returns);
  return returns;
}

/// Share of a disc of diameter 1 left of x (circular segment).
double left_of(double x) {
  const double h = std::clamp(2.0 * x, -1.0, 1.0);
  return 1.0 - (std::acos(h) - h * std::sqrt(1.0 - h * h)) / pi;
}

TEST(BeamTracer, MixedProfileOverAStepIsTheIntegralWithinAMillimetre) {
  const double near = 2.0, far = 2.2, diameter = 0.04;
  const World world(step(near, far));
  LidarOptions o;
  o.aperture = diameter;  // a parallel beam: the same diameter on both plates
  o.subrays = 64;
  for (const char* profile : {"uniform", "gaussian"}) {
    o.profile = profile;
    for (double y = -0.03; y <= 0.03; y += 0.0025) {
      const LineReturns r = trace(world, o, beams_at(y, 400));
      // A pattern of 64 rays is turned by chance for each beam; their mean must be the integral.
      double sum = 0.0, formula = 0.0;
      for (const double range : r.range) sum += range;
      const double share =
          o.profile == "uniform" ? left_of(y / diameter) : normal_cdf(4.0 * y / diameter);
      const double e_near = share / (near * near), e_far = (1.0 - share) / (far * far);
      formula = (e_near * near + e_far * far) / (e_near + e_far);
      EXPECT_NEAR(sum / 400.0, formula, 0.001) << profile << " at " << y;
    }
  }
}

TEST(BeamTracer, LabelOfAMixedPointIsTheStrongerSurface) {
  const World world(step(2.0, 2.2));
  LidarOptions o;
  o.aperture = 0.04;
  o.subrays = 200;
  const LineReturns left = trace(world, o, beams_at(0.005, 1));
  const LineReturns right = trace(world, o, beams_at(-0.008, 1));
  const auto& s = world.surfaces();
  EXPECT_EQ(s[left.triangle[0]].instance_id, 1);
  EXPECT_EQ(s[left.runner_up[0]].instance_id, 2);
  EXPECT_EQ(left.flags[0], point_mixed);
  EXPECT_NEAR(left.true_range[0], 2.0, 1e-3);
  EXPECT_EQ(s[right.triangle[0]].instance_id, 2);
  EXPECT_NEAR(right.true_range[0], 2.2, 1e-3);
}

TEST(BeamTracer, EchoesApartAreNotMixed) {
  const World world(step(2.0, 4.0));
  LidarOptions o;
  o.aperture = 0.04;
  o.subrays = 100;
  o.echo = "last";
  EXPECT_NEAR(trace(world, o, beams_at(0.012, 1)).range[0], 4.0, 1e-3);
  o.echo = "first";
  const LineReturns first = trace(world, o, beams_at(-0.012, 1));
  EXPECT_NEAR(first.range[0], 2.0, 1e-3);
  EXPECT_EQ(first.flags[0], 0);
}

TEST(BeamTracer, ComputedAndTracedSubraysGiveTheSameBits) {
  const World world(testing::plate(3.0, 0.7));
  LidarOptions o;
  o.aperture = 0.01, o.divergence = 0.01, o.subrays = 31;
  const LineReturns computed = trace(world, o, beams_at(0.1, 50), 0);
  const LineReturns traced = trace(world, o, beams_at(0.1, 50), 1);
  for (std::size_t k = 0; k < 50; ++k) {
    EXPECT_EQ(computed.range[k], traced.range[k]);
    EXPECT_EQ(computed.reflected[k], traced.reflected[k]);
    EXPECT_EQ(computed.cosine[k], traced.cosine[k]);
  }
}

Scene mirror_room(Material special) {
  Scene scene = testing::empty_scene();
  scene.materials.push_back(std::move(special));
  // The special plate 2 m ahead, turned by 45 degrees; a wall to the left at y = 3, another
  // straight behind it at x = 5.
  Eigen::Isometry3d pose = at(2, 0, 0);
  pose.linear() = Eigen::AngleAxisd(radians(-45.0), Eigen::Vector3d::UnitZ()).toRotationMatrix();
  Instance plate = box_instance(1, {0.002, 1, 1}, pose);
  plate.parts[0].material = 1;
  scene.instances.push_back(plate);
  scene.instances.push_back(box_instance(2, {6, 0.1, 4}, at(2, 3.05, 0)));
  scene.instances.push_back(box_instance(3, {0.1, 8, 4}, at(5.05, 0, 0)));
  return scene;
}

TEST(BeamTracer, MirrorMakesAGhostAtTheFoldedRange) {
  const World world(mirror_room({"mirror", 0.0, 0.95, 0.0, {}}));
  const LineReturns r = trace(world, LidarOptions(), beams_at(0.0, 1));
  // The near side of the plate is 1 mm of glass before its middle: 2 - 0.001 sqrt(2) along the
  // beam.
  const double to_mirror = 2.0 - 0.001 * std::sqrt(2.0);
  EXPECT_NEAR(r.range[0], to_mirror + 3.0, 1e-6);
  EXPECT_EQ(r.flags[0], point_ghost);
  EXPECT_EQ(world.surfaces()[r.triangle[0]].instance_id, 2) << "a ghost of the wall to the left";
  EXPECT_NEAR(r.reflected[0], 0.95 * 0.95 * 0.5, 1e-6);
}

TEST(BeamTracer, GlassShowsWhatIsBehind) {
  const World world(mirror_room({"glass", 0.0, 0.0, 1.0, {}}));
  const LineReturns r = trace(world, LidarOptions(), beams_at(0.0, 1));
  EXPECT_NEAR(r.range[0], 5.0, 1e-6);
  EXPECT_EQ(r.flags[0], point_behind_glass);
  EXPECT_EQ(world.surfaces()[r.triangle[0]].instance_id, 3);
  // Four passages: two faces there and back, at 45 degrees.
  const double fresnel = 0.04 + 0.96 * std::pow(1.0 - std::sqrt(0.5), 5);
  EXPECT_NEAR(r.reflected[0], 0.5 * std::pow(1.0 - fresnel, 4), 1e-6);
  LidarOptions paint;
  paint.glass = false;
  EXPECT_NEAR(trace(world, paint, beams_at(0.0, 1)).range[0], 2.0, 0.002);
  LidarOptions first;
  first.echo = "first";
  EXPECT_NEAR(trace(world, first, beams_at(0.0, 1)).range[0], 2.0, 0.002) << "the pane itself";
}

TEST(BeamTracer, FacingMirrorsEndAfterTheAllowedBounces) {
  Scene scene = testing::empty_scene();
  scene.materials[0] = {"mirror", 0.0, 1.0, 0.0, {}};
  scene.instances.push_back(box_instance(1, {0.1, 2, 2}, at(1, 0, 0)));
  scene.instances.push_back(box_instance(2, {0.1, 2, 2}, at(-1, 0, 0)));
  const World world(scene);
  EXPECT_EQ(trace(world, LidarOptions(), beams_at(0.0, 1)).triangle[0], no_hit);
}

}  // namespace
}  // namespace scanchor
