#include "perception/smooth_planes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "core/parallel.hpp"
#include "core/random.hpp"

namespace scanchor {
namespace {

// A sensor at the origin looks along x at two sheets at x = 3, the right one `step` metres nearer,
// in 2 cm of noise; each point is labelled by the plane it is nearer to, as if nothing were known
// of its neighbours.
struct Step {
  CanonicalCloud cloud;
  PlaneLabels labels;
  BeamNoise noise{0.02};
  std::vector<std::int32_t> truth;

  explicit Step(double step) {
    SequentialRandom random(5);
    std::vector<Eigen::Vector3d> points;
    std::vector<std::int32_t> side;
    for (double a = -0.3; a <= 0.3; a += 0.01) {
      for (double b = -0.2; b <= 0.2; b += 0.01) {
        const Eigen::Vector3d d = Eigen::Vector3d(1.0, a, b);
        side.push_back(a < 0.0 ? 0 : 1);
        const double x = a < 0.0 ? 3.0 : 3.0 - step;
        points.push_back(d * (x + 0.02 * random.normal() / d.norm()));
      }
    }
    std::vector<std::uint32_t> all(points.size());
    std::iota(all.begin(), all.end(), 0U);
    cloud = canonical_cloud(points, all);
    noise = BeamNoise(0.02, cloud.T_cloud_canonical.inverse() * Eigen::Vector3d::Zero());
    see_from(noise.sensor, cloud);
    std::vector<Moments> sums(2);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const auto source = cloud.source[cloud.first[i]];
      truth.push_back(side[source]);
      const double x = points[source].x();
      labels.of_point.push_back(std::abs(x - 3.0) < std::abs(x - 3.0 + step) ? 0 : 1);
      sums[static_cast<std::size_t>(truth.back())].add(cloud.x[i], cloud.y[i], cloud.z[i]);
    }
    for (const auto& sum : sums) labels.planes.push_back(grown_plane(sum, noise));
  }
  [[nodiscard]] double right() const {
    double count = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i) count += labels.of_point[i] == truth[i];
    return count / static_cast<double>(truth.size());
  }
};

TEST(SmoothPlanes, NeighboursTellSheetsOfOneNoiseApart) {
  for (const double step : {0.03, 0.04}) {  // 1.5 and 2 sigma
    Step scene(step);
    const double before = scene.right();
    EXPECT_LT(before, 0.87);
    smooth_planes(scene.cloud, BeamGrid(scene.cloud, scene.noise.sensor), scene.labels,
                  scene.noise);
    EXPECT_GT(scene.right(), 0.95) << step << " before " << before;
  }
}

// Ten scatters from each other no neighbours talk anybody over, and points without a plane get one.
TEST(SmoothPlanes, APlaneOutOfReachIsNotChosen) {
  Step scene(0.2);
  for (std::size_t i = 0; i < scene.truth.size(); i += 7) scene.labels.of_point[i] = -1;
  smooth_planes(scene.cloud, BeamGrid(scene.cloud, scene.noise.sensor), scene.labels, scene.noise);
  EXPECT_GT(scene.right(), 0.99);
  for (std::size_t i = 0; i < scene.truth.size(); ++i)
    EXPECT_NE(scene.labels.of_point[i], 1 - scene.truth[i]);
}

// Moments are those of the points, whatever was won and lost.
TEST(SmoothPlanes, PlanesFollowTheirPoints) {
  Step scene(0.04);
  const auto sums_of_labels = [&] {
    std::vector<Moments> sums(2);
    for (std::size_t i = 0; i < scene.truth.size(); ++i) {
      const auto label = scene.labels.of_point[i];
      if (label >= 0)
        sums[static_cast<std::size_t>(label)].add(scene.cloud.x[i], scene.cloud.y[i],
                                                  scene.cloud.z[i]);
    }
    return sums;
  };
  const auto before = sums_of_labels();
  for (std::size_t r = 0; r < 2; ++r) scene.labels.planes[r] = grown_plane(before[r], scene.noise);
  smooth_planes(scene.cloud, BeamGrid(scene.cloud, scene.noise.sensor), scene.labels, scene.noise);
  const auto after = sums_of_labels();
  for (std::size_t r = 0; r < 2; ++r) {
    EXPECT_NE(after[r].n, before[r].n);
    EXPECT_EQ(scene.labels.planes[r].moments.n, after[r].n);
    EXPECT_NEAR(scene.labels.planes[r].moments.xx, after[r].xx, 1e-8);
    EXPECT_NEAR(std::abs(scene.labels.planes[r].plane.normal.dot(fit_plane_fast(after[r]).normal)),
                1.0, 1e-9);
  }
}

TEST(SmoothPlanes, OneThreadOrTwo) {
  std::vector<std::vector<std::int32_t>> found;
  for (const int threads : {1, 2}) {
    const ThreadLimit limit(threads);
    Step scene(0.03);
    smooth_planes(scene.cloud, BeamGrid(scene.cloud, scene.noise.sensor), scene.labels,
                  scene.noise);
    found.push_back(scene.labels.of_point);
  }
  EXPECT_EQ(found[0], found[1]);
}

}  // namespace
}  // namespace scanchor
