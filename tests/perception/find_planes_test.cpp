#include "perception/find_planes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>

#include "core/error.hpp"
#include "core/math.hpp"
#include "core/parallel.hpp"
#include "core/random.hpp"
#include "tests/perception/support/plane_score.hpp"
#include "tests/perception/support/room.hpp"

namespace scanchor {
namespace {

using support::RayGrid;
using support::RoomScan;

PerceiveOptions planes_only(const std::string& method = "default", double sigma = 0.0) {
  PerceiveOptions options;
  options.method = method;
  options.noise_sigma = sigma;
  options.shapes = false;
  return options;
}

RoomScan room(std::uint64_t seed, double sigma, int beams = 300, int lines = 150) {
  RayGrid grid;
  grid.beams = beams;
  grid.lines = lines;
  grid.range_sigma = sigma;
  grid.seed = seed;
  return support::scan_boxes(support::reference_room(seed), grid);
}

// A rectangle in z = height, centred, on a jittered grid.
void add_sheet(std::vector<Eigen::Vector3d>& points, SequentialRandom& random, double length,
               double width, double height, double spacing, double sigma) {
  for (double x = -0.5 * length; x <= 0.5 * length; x += spacing) {
    for (double y = -0.5 * width; y <= 0.5 * width; y += spacing) {
      points.emplace_back(x + 0.3 * spacing * random.uniform(),
                          y + 0.3 * spacing * random.uniform(), height + sigma * random.normal());
    }
  }
}

std::vector<std::size_t> sizes(const Surfaces& surfaces) {
  std::vector<std::size_t> out;
  for (const auto& s : surfaces.surfaces) out.push_back(s.inliers.size());
  return out;
}

TEST(FindPlanes, KeepsItsContract) {
  const auto scan = room(21, 0.01);
  const Surfaces found = find_planes(scan.cloud, planes_only());
  ASSERT_EQ(found.plane_of_point.size(), scan.cloud.size());
  std::vector<std::int32_t> from_inliers(scan.cloud.size(), -1);
  for (std::size_t s = 0; s < found.surfaces.size(); ++s) {
    const Surface& surface = found.surfaces[s];
    EXPECT_EQ(surface.id, static_cast<std::int32_t>(s));
    EXPECT_TRUE(std::is_sorted(surface.inliers.begin(), surface.inliers.end()));
    if (s > 0) {
      EXPECT_GE(found.surfaces[s - 1].inliers.size(), surface.inliers.size());
    }
    EXPECT_NEAR(surface.plane.normal.norm(), 1.0, 1e-12);
    EXPECT_GE(surface.plane.normal.dot(found.sensor_positions[0] - surface.plane.centroid), 0.0);
    EXPECT_GE(surface.confidence, 0.0);
    EXPECT_LE(surface.confidence, 1.0);
    for (const auto i : surface.inliers) from_inliers[i] = surface.id;
  }
  EXPECT_EQ(from_inliers, found.plane_of_point);
  EXPECT_THROW(find_planes(scan.cloud, planes_only("ransac")), Error);
}

TEST(FindPlanes, SameBytesForAnyOrderAndThreads) {
  const auto scan = room(22, 0.01);
  const auto mixed = support::shuffled(scan, 5);
  const auto again = support::shuffled(mixed, 6);
  for (const std::string method : {"default", "paper"}) {
    Surfaces one, two;
    {
      const ThreadLimit limit(1);
      one = find_planes(mixed.cloud, planes_only(method));
    }
    {
      const ThreadLimit limit(2);
      two = find_planes(again.cloud, planes_only(method));
    }
    ASSERT_EQ(sizes(one), sizes(two)) << method;
    EXPECT_EQ(one.noise_sigma, two.noise_sigma);
    EXPECT_EQ(one.point_spacing, two.point_spacing);
    // Surfaces of equal size may change places, since only their point indices tell them apart:
    // compare as sets of planes.
    const auto planes = [](const Surfaces& s) {
      std::vector<std::array<double, 8>> rows;
      for (const auto& f : s.surfaces) {
        rows.push_back({static_cast<double>(f.inliers.size()), f.plane.normal.x(),
                        f.plane.normal.y(), f.plane.normal.z(), f.plane.offset,
                        f.plane.residual_sigma, f.plane.centroid_sigma, f.confidence});
      }
      std::sort(rows.begin(), rows.end());
      return rows;
    };
    EXPECT_EQ(planes(one), planes(two)) << method;  // bit for bit
  }
}

// Up to rounding: a point on the border of a cell may change sides. Of 190 motions of three rooms
// at four noises none lost a surface, and at most two points in 100,000 changed theirs.
TEST(FindPlanes, SameSurfacesAfterARigidMotion) {
  const auto scan = room(23, 0.01);
  const Surfaces before = find_planes(scan.cloud, planes_only());
  SequentialRandom random(31);
  for (int k = 0; k < 12; ++k) {
    const Eigen::Quaterniond turn(random.normal(), random.normal(), random.normal(),
                                  random.normal());
    const double far = k < 6 ? 20.0 : 1e5;
    const Eigen::Isometry3d motion =
        Eigen::Translation3d(random.uniform(-far, far), random.uniform(-far, far),
                             random.uniform(-far, far)) *
        turn.normalized();
    PointCloud moved = scan.cloud;
    for (auto& p : moved.points) p = motion * p;
    for (auto& pose : moved.sensor_poses) pose = motion * pose;
    const Surfaces after = find_planes(moved, planes_only());
    ASSERT_EQ(before.surfaces.size(), after.surfaces.size()) << k;
    std::map<std::pair<std::int32_t, std::int32_t>, std::size_t> pairs;
    for (std::size_t i = 0; i < moved.size(); ++i)
      ++pairs[{before.plane_of_point[i], after.plane_of_point[i]}];
    std::map<std::int32_t, std::pair<std::size_t, std::int32_t>> best;
    for (const auto& [pair, n] : pairs)
      best[pair.first] = std::max(best[pair.first], {n, pair.second});
    std::size_t same = 0;
    for (const auto& [id, most] : best) {
      same += most.first;
      if (id < 0) continue;
      const Surface &one = before.surfaces[static_cast<std::size_t>(id)],
                    &two = after.surfaces[static_cast<std::size_t>(most.second)];
      EXPECT_GT(static_cast<double>(most.first), 0.98 * static_cast<double>(one.inliers.size()));
      EXPECT_GT(static_cast<double>(most.first), 0.98 * static_cast<double>(two.inliers.size()));
    }
    EXPECT_GT(static_cast<double>(same), 0.9998 * static_cast<double>(moved.size())) << k;
    for (std::size_t s = 0; s < 5; ++s) {
      const Eigen::Vector3d turned = motion.linear() * before.surfaces[s].plane.normal;
      EXPECT_LT((turned - after.surfaces[s].plane.normal).norm(), 1e-5) << s;
    }
  }
}

// Cells that an edge runs through are not flat; their points find their walls all the same.
TEST(FindPlanes, WallsOfABoxToTheirEdges) {
  SequentialRandom random(2);
  PointCloud cloud;
  for (int i = 0; i < 60000; ++i) {
    Eigen::Vector3d p(3.0 * random.uniform(), 2.0 * random.uniform(), 1.5 * random.uniform());
    p[i % 3] = (i % 6 < 3 ? 0.0 : Eigen::Vector3d(3.0, 2.0, 1.5)[i % 3]) + 0.006 * random.normal();
    cloud.points.push_back(p);
  }
  const Surfaces found = find_planes(cloud, planes_only());
  // Bevels of some 20-60 points may be left at the edges, where no sensor says what was seen.
  ASSERT_GE(found.surfaces.size(), 6U);
  std::size_t in_walls = 0;
  for (std::size_t s = 0; s < 6; ++s) in_walls += found.surfaces[s].inliers.size();
  EXPECT_GT(in_walls, 59000U);
  std::map<std::pair<std::size_t, std::int32_t>, int> count;
  for (std::size_t i = 0; i < cloud.size(); ++i) ++count[{i % 6, found.plane_of_point[i]}];
  for (std::size_t wall = 0; wall < 6; ++wall) {
    int most = 0;
    for (const auto& [key, n] : count) {
      if (key.first == wall && key.second >= 0) most = std::max(most, n);
    }
    EXPECT_GT(most, 9700) << wall;  // of 10,000; three sigma hold 99.7 %, edges mix
  }
}

// One binary, nothing re-tuned; told nothing. The bounds are of issue 5, for rooms that no
// threshold was chosen on.
TEST(FindPlanes, NoiseFromZeroToFourCentimetres) {
  for (const double sigma : {0.0, 0.005, 0.01, 0.02, 0.04}) {
    const auto scan = room(24, sigma, 500, 200);
    const Surfaces found = find_planes(scan.cloud, planes_only());
    const auto score =
        support::score_planes(scan.plane, found.plane_of_point, 0.8, scan.plane.size() / 2000);
    EXPECT_GT(score.recall, sigma > 0.03 ? 0.85 : 0.94) << sigma;
    EXPECT_GT(score.precision, sigma > 0.03 ? 0.85 : 0.94) << sigma;
    EXPECT_GE(score.correct, sigma > 0.03    ? 8
                             : sigma > 0.015 ? 16
                                             : 25)
        << sigma << " of " << score.planes;
  }
}

TEST(FindPlanes, PerfectlyFlatNoiseFreeSheet) {
  PointCloud cloud;
  for (int i = 0; i < 60; ++i) {
    for (int j = 0; j < 40; ++j) cloud.points.emplace_back(0.02 * i, 0.02 * j, 1.0);
  }
  for (const std::string method : {"default", "paper"}) {
    const Surfaces found = find_planes(cloud, planes_only(method));
    ASSERT_EQ(found.surfaces.size(), 1U) << method;
    EXPECT_EQ(found.surfaces[0].inliers.size(), 2400U);
    EXPECT_NEAR(std::abs(found.surfaces[0].plane.normal.z()), 1.0, 1e-9);
  }
}

TEST(FindPlanes, FarFromTheOrigin) {
  auto scan = room(25, 0.01);
  const Surfaces near = find_planes(scan.cloud, planes_only());
  const Eigen::Vector3d far(1e6, 2e6, 1e6);
  for (auto& p : scan.cloud.points) p += far;
  for (auto& pose : scan.cloud.sensor_poses) pose.translation() += far;
  const Surfaces there = find_planes(scan.cloud, planes_only());
  std::size_t same = 0;
  for (std::size_t i = 0; i < scan.cloud.size(); ++i)
    same += near.plane_of_point[i] == there.plane_of_point[i];
  EXPECT_GT(static_cast<double>(same), 0.99 * static_cast<double>(scan.cloud.size()));
  EXPECT_NEAR(near.noise_sigma, there.noise_sigma, 1e-4);
}

TEST(FindPlanes, ThousandsOfDuplicates) {
  SequentialRandom random(1);
  PointCloud cloud;
  add_sheet(cloud.points, random, 1.0, 0.6, 0.0, 0.02, 0.003);
  const std::size_t sheet = cloud.size();
  for (int i = 0; i < 5000; ++i) cloud.points.push_back(cloud.points[777]);
  for (int i = 0; i < 5000; ++i) cloud.points.emplace_back(3.0, 3.0, 3.0);
  const Surfaces found = find_planes(cloud, planes_only());
  ASSERT_EQ(found.surfaces.size(), 1U);  // no plane through one place
  EXPECT_GT(found.surfaces[0].inliers.size(), 5000 + sheet * 95 / 100);
  EXPECT_EQ(found.plane_of_point.back(), -1);
}

TEST(FindPlanes, ALineIsNoPlane) {
  SequentialRandom random(2);
  for (const double sigma : {0.0, 0.005}) {
    PointCloud cloud;
    for (int i = 0; i < 2000; ++i) {
      cloud.points.emplace_back(0.003 * i, sigma * random.normal(), sigma * random.normal());
    }
    for (const auto& surface : find_planes(cloud, planes_only("default", sigma)).surfaces) {
      // What is claimed on a noisy line must say that its tilt is open.
      EXPECT_GT(surface.plane.normal_covariance.trace(), 0.001) << sigma;
    }
    EXPECT_LE(find_planes(cloud, planes_only("default", 0.005)).surfaces.size(), 0U);
  }
}

TEST(FindPlanes, TwoSheetsThreeCentimetresApart) {
  SequentialRandom random(3);
  for (const double sigma : {0.001, 0.003, 0.005}) {
    PointCloud cloud;
    add_sheet(cloud.points, random, 0.8, 0.6, 0.00, 0.012, sigma);
    const std::size_t first = cloud.size();
    add_sheet(cloud.points, random, 0.8, 0.6, 0.03, 0.012, sigma);
    const Surfaces found = find_planes(cloud, planes_only("default", sigma));
    ASSERT_GE(found.surfaces.size(), 2U) << sigma;
    std::vector<std::int32_t> truth(cloud.size(), 1);
    std::fill(truth.begin(), truth.begin() + static_cast<std::ptrdiff_t>(first), 0);
    // Both come out whole, and next to nothing of one is counted to the other.
    const auto score = support::score_planes(truth, found.plane_of_point, 0.95, 100);
    EXPECT_EQ(score.correct, 2) << sigma;
    EXPECT_EQ(score.spurious, 0) << sigma;
    std::size_t mixed = 0;
    for (const auto& surface : found.surfaces) {
      std::size_t low = 0;
      for (const auto i : surface.inliers) low += i < first;
      mixed += std::min(low, surface.inliers.size() - low);
    }
    EXPECT_LE(static_cast<double>(mixed), 0.002 * static_cast<double>(cloud.size())) << sigma;
  }
}

TEST(FindPlanes, AVeilOfMixedPixelsIsNoSurface) {
  // A screen 40 cm before a wall; along its outline every beam that hits both returns something
  // between.
  SequentialRandom random(4);
  PointCloud cloud;
  add_sheet(cloud.points, random, 2.0, 2.0, 0.0, 0.02, 0.005);
  const std::size_t wall = cloud.size();
  add_sheet(cloud.points, random, 0.6, 0.4, 0.4, 0.01, 0.005);
  const std::size_t screen = cloud.size() - wall;
  for (int i = 0; i < 200; ++i) {
    const double t = random.uniform(), side = random.uniform();
    const double x = t < 0.5 ? (side < 0.5 ? -0.31 : 0.31) : random.uniform(-0.31, 0.31);
    const double y = t < 0.5 ? random.uniform(-0.21, 0.21) : (side < 0.5 ? -0.21 : 0.21);
    cloud.points.emplace_back(x + 0.004 * random.normal(), y + 0.004 * random.normal(),
                              random.uniform(0.02, 0.38));
  }
  const Surfaces found = find_planes(cloud, planes_only("default", 0.005));
  ASSERT_GE(found.surfaces.size(), 2U);
  EXPECT_NEAR(static_cast<double>(found.surfaces[0].inliers.size()), static_cast<double>(wall),
              0.03 * wall);
  EXPECT_NEAR(static_cast<double>(found.surfaces[1].inliers.size()), static_cast<double>(screen),
              0.05 * screen);
  EXPECT_GT(std::abs(found.surfaces[1].plane.normal.z()), 0.9995);  // the veil has not tilted it
}

TEST(FindPlanes, NoPlaneOnASphereWithConfidence) {
  SequentialRandom random(5);
  for (const double sigma : {0.0, 0.002, 0.01}) {
    PointCloud cloud;
    for (int i = 0; i < 4000; ++i) {
      const Eigen::Vector3d d =
          Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
      cloud.points.push_back((0.2 + sigma * random.normal()) * d);
    }
    for (const auto& surface : find_planes(cloud, planes_only("default", sigma)).surfaces) {
      const bool large = surface.inliers.size() > 200;  // 5 % of the sphere
      EXPECT_TRUE(!large || surface.confidence < 0.5)
          << sigma << ": " << surface.inliers.size() << " points, confidence "
          << surface.confidence;
    }
  }
}

TEST(FindPlanes, NothingToFind) {
  EXPECT_TRUE(find_planes(PointCloud{}, planes_only()).surfaces.empty());
  PointCloud few;
  few.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_TRUE(find_planes(few, planes_only()).surfaces.empty());
  PointCloud nan;
  nan.points.assign(100, Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()));
  const Surfaces found = find_planes(nan, planes_only());
  EXPECT_TRUE(found.surfaces.empty());
  EXPECT_EQ(found.set_aside.not_finite, 100U);
  PointCloud same;
  same.points.assign(5000, Eigen::Vector3d(1, 2, 3));
  EXPECT_TRUE(find_planes(same, planes_only()).surfaces.empty());
}

}  // namespace
}  // namespace scanchor
