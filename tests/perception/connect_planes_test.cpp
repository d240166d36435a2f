#include "perception/connect_planes.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "core/random.hpp"

namespace scanchor {
namespace {

// A sensor at the origin looks along x, beams a degree apart; two boards in the plane x = 2, with a
// strip of `gap` metres between them, before a wall at x = 4; the noise is 5 mm along the beam.
struct TwoBoards {
  CanonicalCloud cloud;
  PlaneLabels labels;
  BeamNoise noise{0.005};
  std::vector<int> truth;  // canonical: 0 left board, 1 right board, 2 wall, 3 post

  // `shelf_noise`: where not 0, they are small, the noise is this, and a strip 2 cm high is before
  // the lower edges of both, as a board that both stand on.
  explicit TwoBoards(double gap, bool post_before, bool one_label, double shelf_noise = 0.0) {
    const bool shelf = shelf_noise > 0.0;
    SequentialRandom random(11);
    std::vector<Eigen::Vector3d> points;
    std::vector<int> kinds;
    const double sigma = shelf ? shelf_noise : 0.005, end = shelf ? 0.3 : 0.6;
    for (double a = -30.0; a <= 30.0; a += 0.5) {
      for (double e = -15.0; e <= 15.0; e += 0.5) {
        const Eigen::Vector3d d =
            Eigen::Vector3d(1.0, std::tan(a * 0.0174532925), std::tan(e * 0.0174532925));
        const double y = 2.0 * d.y();
        int kind = 2;
        double x = 4.0;
        if (std::abs(y) < 0.5 * gap) {
          if (post_before) kind = 3, x = 1.5;
        } else if (std::abs(y) < end && !(shelf && std::abs(e) > 4.9)) {
          kind = y < 0.0 ? 0 : 1, x = 2.0;
        }
        if (shelf && std::abs(e + 5.0) < 0.4 && std::abs(y) < end) kind = 3, x = 1.95;
        points.push_back(d * (x + sigma * random.normal() / d.norm()));
        kinds.push_back(kind);
      }
    }
    std::vector<std::uint32_t> all(points.size());
    std::iota(all.begin(), all.end(), 0U);
    cloud = canonical_cloud(points, all);
    noise = BeamNoise(sigma, cloud.T_cloud_canonical.inverse() * Eigen::Vector3d::Zero());
    see_from(noise.sensor, cloud);
    std::vector<Moments> sums(4);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      truth.push_back(kinds[cloud.source[cloud.first[i]]]);
      const int plane = one_label && truth.back() == 1 ? 0 : truth.back();
      labels.of_point.push_back(plane);
      sums[static_cast<std::size_t>(plane)].add(cloud.x[i], cloud.y[i], cloud.z[i]);
    }
    for (const auto& sum : sums)
      labels.planes.push_back(sum.n > 0.0 ? grown_plane(sum, noise) : GrownPlane{});
  }
  std::set<std::int32_t> labels_of(int kind) const {
    std::set<std::int32_t> found;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      if (truth[i] == kind) found.insert(labels.of_point[i]);
    }
    return found;
  }
};

TEST(ConnectPlanes, AViewThroughMakesTwo) {
  TwoBoards scene(0.25, false, true);
  connect_planes(scene.cloud, BeamGrid(scene.cloud, scene.noise.sensor), scene.noise, 20,
                 scene.labels);
  EXPECT_EQ(scene.labels_of(0).size(), 1U);
  EXPECT_EQ(scene.labels_of(1).size(), 1U);
  EXPECT_NE(scene.labels_of(0), scene.labels_of(1));
  EXPECT_EQ(scene.labels_of(2).size(), 1U);  // the wall is one, seen on both sides and between
}

TEST(ConnectPlanes, AShadowLeavesOne) {
  for (const bool one_label : {true, false}) {
    TwoBoards scene(0.25, true, one_label);
    connect_planes(scene.cloud, BeamGrid(scene.cloud, scene.noise.sensor), scene.noise, 20,
                   scene.labels);
    EXPECT_EQ(scene.labels_of(0).size(), 1U) << one_label;
    EXPECT_EQ(scene.labels_of(0), scene.labels_of(1)) << one_label;
  }
}

TEST(ConnectPlanes, TwoThingsInOnePlaneStayTwo) {
  TwoBoards scene(0.25, false, false);
  connect_planes(scene.cloud, BeamGrid(scene.cloud, scene.noise.sensor), scene.noise, 20,
                 scene.labels);
  EXPECT_NE(scene.labels_of(0), scene.labels_of(1));
}

// A path along the board is no reason: most beams between the two met what is behind.
TEST(ConnectPlanes, ThingsOnOneBoardStayTwo) {
  TwoBoards scene(0.12, false, false, 0.02);
  connect_planes(scene.cloud, BeamGrid(scene.cloud, scene.noise.sensor), scene.noise, 20,
                 scene.labels);
  EXPECT_EQ(scene.labels_of(0).size(), 1U);
  EXPECT_EQ(scene.labels_of(1).size(), 1U);
  EXPECT_NE(scene.labels_of(0), scene.labels_of(1));
}

// As a wall is, left and right of a window: planes that agree to a tenth of a millimetre.
TEST(ConnectPlanes, PiecesThatAgreeByNoAccidentAreOne) {
  TwoBoards scene(0.12, false, false, 0.002);
  connect_planes(scene.cloud, BeamGrid(scene.cloud, scene.noise.sensor), scene.noise, 20,
                 scene.labels);
  EXPECT_EQ(scene.labels_of(0), scene.labels_of(1));
}

TEST(ConnectPlanes, AStrayPointInThePlaneLosesItsLabel) {
  TwoBoards scene(0.25, false, false);
  std::size_t stray = 0;  // a point of the wall that was counted to a board
  const auto beside_the_middle = [&](std::size_t i) {
    return std::abs((scene.cloud.T_cloud_canonical * scene.cloud.point(i).cast<double>()).y());
  };
  while (scene.truth[stray] != 2 || beside_the_middle(stray) > 0.05) ++stray;
  scene.labels.of_point[stray] = 0;
  connect_planes(scene.cloud, BeamGrid(scene.cloud, scene.noise.sensor), scene.noise, 20,
                 scene.labels);
  EXPECT_EQ(scene.labels.of_point[stray], -1);
}

}  // namespace
}  // namespace scanchor
