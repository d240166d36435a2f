#include "eval/blame.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"
#include "eval/truth.hpp"
#include "tests/eval/support/small_scan.hpp"

namespace scanchor {
namespace {

TEST(Blame, PerfectScanTakesTheNoiseOffAgain) {
  const SmallScan made = small_scan();
  Scan noisy = made.scan;
  SequentialRandom random(1);
  for (auto& point : noisy.cloud.points) point *= 1.0 + 0.01 * random.normal();
  noisy.truth.flags[3] = point_ghost;
  const Eigen::Vector3d ghost = noisy.cloud.points[3];
  const Scan clean = perfect_scan(noisy);
  for (std::size_t i = 0; i < clean.cloud.size(); ++i) {
    if (i == 3) continue;
    EXPECT_LT((clean.cloud.points[i] - made.scan.cloud.points[i]).norm(),
              1e-6);  // true_range is float
  }
  EXPECT_EQ(clean.cloud.points[3], ghost);
}

TEST(Blame, PerfectPlanesAreThoseOfTheTruth) {
  const SmallScan made = small_scan();
  const ScanTruth truth = truth_of(made.scan, &made.scene, Protocol{});
  const Surfaces surfaces = perfect_planes(made.scan, truth, Protocol{});
  for (std::size_t s = 0; s < surfaces.surfaces.size(); ++s) {
    const auto& surface = surfaces.surfaces[s];
    EXPECT_EQ(surface.id, static_cast<std::int32_t>(s));
    const auto& plane = truth.planes[static_cast<std::size_t>(truth.plane[surface.inliers[0]])];
    EXPECT_NEAR(std::abs(surface.plane.normal.dot(plane.normal)), 1.0, 1e-9);
    EXPECT_LE(surface.plane.normal.dot(surface.plane.centroid), 0.0);  // towards the sensor
    if (s > 0) {
      EXPECT_LE(surface.inliers.size(), surfaces.surfaces[s - 1].inliers.size());
    }
  }
  EXPECT_NEAR(surfaces.point_spacing, 0.04, 1e-4);
  EXPECT_LT(surfaces.noise_sigma, 1e-3);
}

TEST(Blame, PerfectShapesAreThoseOfTheFaces) {
  const SmallScan made = small_scan();
  const ScanTruth truth = truth_of(made.scan, &made.scene, Protocol{});
  const Surfaces surfaces = perfect_shapes(made.scan, made.scene, truth, Protocol{});
  bool desk = false;
  for (const auto& surface : surfaces.surfaces) {
    const auto& plane = truth.planes[static_cast<std::size_t>(truth.plane[surface.inliers[0]])];
    EXPECT_NEAR(surface.area.value, plane.area, 1e-9);
    EXPECT_NEAR(surface.polygons[0].outer.size(), 4U, 0);
    EXPECT_NEAR(surface.rectangle.length.value, plane.length, 1e-9);
    EXPECT_NEAR(surface.rectangularness, 1.0, 1e-9);
    desk = desk || std::abs(plane.area - 1.28) < 1e-9;
  }
  EXPECT_TRUE(desk);
}

TEST(Blame, LossesAddUpToOne) {
  BlameResult result;
  double recall = 0.5;
  for (const auto stage : {PerfectUpTo::nothing, PerfectUpTo::scan, PerfectUpTo::planes,
                           PerfectUpTo::shapes, PerfectUpTo::labels}) {
    BlameRow row;
    row.perfect = stage;
    row.score.protocol = protocol_stamp(result.protocol);
    row.score.objects.classes.resize(class_list().size());
    row.score.objects.classes[8] = {100, static_cast<std::int64_t>(100 * recall + 0.5), 0, 0};
    recall += 0.1;
    result.rows.push_back(row);
  }
  double sum = 0.5;
  for (const auto& [stage, loss] : result.losses("objects.recall")) sum += loss;
  EXPECT_NEAR(sum, 1.0, 1e-12);
  EXPECT_NEAR(result.losses("objects.recall")[3].second, 0.1, 1e-12);
  const auto text = blame_to_markdown(result, {"objects.recall"});
  EXPECT_THAT(text, testing::HasSubstr("| perfect planes | 70.00 |"));
  EXPECT_THAT(text, testing::HasSubstr("| loss: reasoning | 10.00 |"));
  EXPECT_THAT(text, testing::HasSubstr("| loss: limit | 10.00 |"));
}

}  // namespace
}  // namespace scanchor
