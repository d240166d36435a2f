#include "reasoning/relation_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "core/math.hpp"
#include "core/parallel.hpp"
#include "core/random.hpp"

namespace scanchor {
namespace {

double normal(SequentialRandom& random) {
  return std::sqrt(-2.0 * std::log(random.uniform(1e-12, 1.0))) *
         std::cos(2.0 * pi * random.uniform(0.0, 1.0));
}

/// Things seen from the side: a to the left of b, whose bearings are off by `deg`.
RelationScene bearings(double deg, int pairs) {
  SequentialRandom random(11);
  RelationScene scene;
  scene.around.viewpoint = Eigen::Vector3d::Zero();
  for (int i = 0; i < pairs; ++i) {
    Item b;
    b.center = {4.0, 0.0, 1.0};
    Item a = b;
    const double truth = radians(45.0 + deg * random.uniform(-5.0, 5.0));  // off "left"
    const double measured = truth + radians(deg) * normal(random);
    a.center += Eigen::Vector3d(std::sin(measured), std::cos(measured), 0.0);
    b.id = 2 * i;
    a.id = 2 * i + 1;
    scene.items.push_back(b);
    scene.items.push_back(a);
    scene.samples.push_back({Relation::left_of, a.id, b.id, truth <= radians(45.0)});
    scene.surfaces.surfaces.resize(scene.items.size());
  }
  return scene;
}

TEST(RelationFit, FindsTheErrorThatBearingsWereGiven) {
  for (const double deg : {0.5, 2.0}) {
    const RelationFit fit = fit_relations({bearings(deg, 4000)}, RelationModel{});
    EXPECT_NEAR(fit.model.bearing_softness / deg, 1.0, 0.15);
    ASSERT_EQ(fit.parts.size(), 1U);
    EXPECT_LT(fit.parts[0].after, fit.parts[0].before);
  }
}

/// Walls found with a tilt that is `scale` times what their fit says, some of them grossly off.
RelationScene walls(double scale, int count) {
  SequentialRandom random(12);
  RelationScene scene;
  const double said = radians(1.0);
  for (int i = 0; i < count; ++i) {
    Surface surface;
    surface.plane.normal = Eigen::Vector3d::UnitX();
    surface.plane.residual_sigma = 0.01;
    surface.plane.normal_covariance = said * said * Eigen::Vector3d(0, 1, 1).asDiagonal();
    surface.inlier_count = 5;
    Item item;
    item.normal = surface.plane.normal;
    const Eigen::Vector3d truth(1.0, scale * said * normal(random), scale * said * normal(random));
    scene.normals.push_back({i, truth.normalized()});
    scene.surfaces.surfaces.push_back(surface);
    scene.items.push_back(item);
  }
  return scene;
}

TEST(RelationFit, FindsHowFarPlanesAreOff) {
  for (const double scale : {0.8, 1.7}) {
    RelationModel start;
    start.tilt_of_points = 0.01;
    const RelationFit fit = fit_relations({walls(scale, 3000)}, start);
    EXPECT_NEAR(fit.model.tilt_scale / scale, 1.0, 0.12);
  }
}

TEST(RelationFit, LeavesAloneWhatNoSampleDependsOn) {
  const RelationModel start;
  const RelationFit fit = fit_relations({bearings(1.0, 200)}, start);
  for (const auto& constant : relation_constants()) {
    if (std::string(constant.part) == "bearings") continue;
    EXPECT_EQ(fit.model.*constant.value, start.*constant.value) << constant.name;
  }
}

TEST(RelationFit, IsTheSameForAnyNumberOfThreads) {
  const std::vector<RelationScene> scenes = {bearings(1.0, 1500), walls(1.3, 700)};
  const RelationFit many = fit_relations(scenes, RelationModel{});
  const ThreadLimit limit(1);
  const RelationFit one = fit_relations(scenes, RelationModel{});
  for (const auto& constant : relation_constants())
    EXPECT_EQ(many.model.*constant.value, one.model.*constant.value) << constant.name;
}

TEST(RelationFit, NothingToLearnFromIsAnError) {
  EXPECT_THROW(fit_relations({}, RelationModel{}), Error);
  EXPECT_THROW(fit_relations({RelationScene{}}, RelationModel{}), Error);
}

}  // namespace
}  // namespace scanchor
