#include "sim/world.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/parallel.hpp"
#include "tests/sim/support/boxes.hpp"

namespace scanchor {
namespace {

using testing::at;
using testing::box_instance;
using testing::random_direction;

std::vector<Ray> random_rays(std::size_t count, std::uint64_t seed) {
  SequentialRandom random(seed);
  std::vector<Ray> rays(count);
  for (auto& ray : rays) {
    ray.origin = {random.uniform(0.1, 5.9), random.uniform(0.1, 4.9), random.uniform(0.1, 2.9)};
    ray.direction = random_direction(random);
  }
  return rays;
}

std::string bytes(const std::vector<Hit>& hits) {
  std::string text;
  for (const Hit& hit : hits) {
    text.append(reinterpret_cast<const char*>(&hit.triangle), sizeof hit.triangle);
    text.append(reinterpret_cast<const char*>(&hit.range), sizeof hit.range);
  }
  return sha256(text);
}

TEST(World, AgreesWithTheSlabMethodOnAMillionRays) {
  const Scene scene = testing::random_boxes(60, 11);
  const World world(scene);
  const auto rays = random_rays(1'000'000, 12);
  std::vector<Hit> hits(rays.size());
  world.trace(rays, hits);
  std::vector<int> differ(1000, 0), near_edge(1000, 0);
  std::vector<double> worst(1000, 0.0);
  parallel_blocks(rays.size(), 1000, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto truth = testing::trace_boxes(scene, rays[i]);
      // Within the reach of single precision of an edge, or where two surfaces cross, either answer
      // is right.
      if (truth.edge_distance < 1e-5 || truth.runner_up - truth.range < 1e-4) {
        ++near_edge[begin / 1000];
        continue;
      }
      const bool same = hits[i].triangle != no_hit &&
                        world.triangles()[hits[i].triangle].instance == truth.instance;
      if (!same) {
        ++differ[begin / 1000];
      } else {
        worst[begin / 1000] = std::max(worst[begin / 1000], std::fabs(hits[i].range - truth.range));
      }
    }
  });
  EXPECT_LT(*std::max_element(worst.begin(), worst.end()), 1e-9);
  EXPECT_LT(std::accumulate(near_edge.begin(), near_edge.end(), 0), 2000);
  // A ray that passes an edge of another box by less than a micrometre may be told either way.
  EXPECT_LE(std::accumulate(differ.begin(), differ.end(), 0), 20);
}

TEST(World, FindsTheTriangleThatALoopOverAllFinds) {
  const Scene scene = testing::random_boxes(20, 3);
  const World world(scene);
  const auto rays = random_rays(3000, 4);
  std::vector<Hit> hits(rays.size());
  world.trace(rays, hits);
  int differ = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    std::uint32_t best = no_hit;
    double range = 1e300;
    for (std::uint32_t t = 0; t < world.triangles().size(); ++t) {
      // Moeller & Trumbore 1997, from the corners alone.
      const Eigen::Vector3d e1 = world.corner(t, 1) - world.corner(t, 0);
      const Eigen::Vector3d e2 = world.corner(t, 2) - world.corner(t, 0);
      const Eigen::Vector3d p = rays[i].direction.cross(e2);
      const double det = e1.dot(p);
      if (std::fabs(det) < 1e-15) continue;
      const Eigen::Vector3d s = rays[i].origin - world.corner(t, 0);
      const double u = s.dot(p) / det;
      const double v = rays[i].direction.dot(s.cross(e1)) / det;
      const double along = e2.dot(s.cross(e1)) / det;
      if (u < 0 || v < 0 || u + v > 1 || along < 1e-4 || along >= range) continue;
      best = t;
      range = along;
    }
    ASSERT_NE(best, no_hit) << "the room is closed";
    if (hits[i].triangle != best) {
      ++differ;
      continue;
    }
    EXPECT_NEAR(hits[i].range, range, 1e-9);
  }
  EXPECT_LE(differ, 1);
}

TEST(World, ClosedRoomHasNoLeak) {
  Scene scene = testing::empty_scene();
  testing::add_room(scene, {6, 5, 3});
  const World world(scene);
  // Rays at the edges and corners of the room are where a tracer that is not robust leaks.
  SequentialRandom random(5);
  std::vector<Ray> rays;
  for (int i = 0; i < 200000; ++i) {
    Eigen::Vector3d target(random.uniform(0, 6), random.uniform(0, 5), random.uniform(0, 3));
    target[static_cast<int>(random.below(3))] = 0.0;
    target[static_cast<int>(random.below(3))] = 0.0;
    const Eigen::Vector3d origin(2.1, 3.3, 1.2);
    rays.push_back({origin, (target - origin).normalized()});
  }
  std::vector<Hit> hits(rays.size());
  world.trace(rays, hits);
  EXPECT_EQ(std::count_if(hits.begin(), hits.end(),
                          [](const Hit& hit) { return hit.triangle == no_hit; }),
            0);
}

// A beam at 90 degrees on a line that is tilted by less than a degree has a component of about
// -1e-18: its packet must not be lost.
TEST(World, ComponentsNextToZeroLoseNoRay) {
  const Scene scene = testing::random_boxes(0, 1);
  for (const int width : {1, 4, 8, 16}) {
    WorldOptions options;
    options.packet_width = width;
    const World world(scene, options);
    for (const double tiny : {1e-12, 1e-15, 1e-17, 1e-18, 8e-19, 1e-20, 1e-30, 1e-40, 0.0}) {
      for (const double sign : {-1.0, 1.0}) {
        for (int axis = 0; axis < 3; ++axis) {
          std::vector<Ray> rays(16);
          for (std::size_t i = 0; i < rays.size(); ++i) {
            rays[i].origin = {2.5, 2.2, 1.3};
            const double angle = 0.01 * static_cast<double>(i);
            rays[i].direction[axis] = i == 0 ? sign * tiny : -2e-4 * static_cast<double>(i);
            rays[i].direction[(axis + 1) % 3] = std::cos(angle);
            rays[i].direction[(axis + 2) % 3] = std::sin(angle);
          }
          std::vector<Hit> hits(rays.size());
          world.trace(rays, hits);
          for (const Hit& hit : hits)
            EXPECT_NE(hit.triangle, no_hit)
                << "width " << width << " component " << sign * tiny << " of axis " << axis;
        }
      }
    }
  }
}

TEST(World, SameBytesForEveryInstructionSetAndPacketWidth) {
  const Scene scene = testing::random_boxes(60, 21);
  const auto rays = random_rays(200'000, 22);
  std::vector<Hit> hits(rays.size());
  std::string first;
  for (const char* isa : {"", "sse2", "avx2"}) {
    for (const int width : {1, 4, 8, 16}) {
      WorldOptions options;
      options.embree_isa = isa;
      options.packet_width = width;
      World(scene, options).trace(rays, hits);
      if (first.empty()) first = bytes(hits);
      EXPECT_EQ(bytes(hits), first) << "isa '" << isa << "', packets of " << width;
    }
  }
  WorldOptions slow_build;
  slow_build.high_quality = true;
  World(scene, slow_build).trace(rays, hits);
  EXPECT_EQ(bytes(hits), first) << "high quality";
}

TEST(World, TrianglesKnowWhatTheyBelongTo) {
  Scene scene = testing::empty_scene();
  scene.instances.push_back(box_instance(7, {1, 1, 1}, at(3, 0, 0)));
  scene.instances.push_back(box_instance(9, {1, 1, 1}, at(0, 3, 0)));
  const World world(scene);
  ASSERT_EQ(world.triangles().size(), 24U);
  const std::vector<Ray> rays = {
      {{0, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, {0, 1, 0}}, {{0, 0, 0}, {0, 0, 1}}};
  std::vector<Hit> hits(3);
  world.trace(rays, hits);
  EXPECT_DOUBLE_EQ(hits[0].range, 2.5);
  const TriangleTruth& truth = world.triangles()[hits[0].triangle];
  EXPECT_EQ(truth.instance, 0);
  const FaceAddress& address = world.faces()[static_cast<std::size_t>(truth.face)];
  EXPECT_EQ(scene.instances[0].parts[0].faces[static_cast<std::size_t>(address.face)].name, "left");
  EXPECT_EQ(world.normal(hits[0].triangle), Eigen::Vector3d(-1, 0, 0));
  const SurfaceRecord& record = world.surfaces()[hits[1].triangle];
  EXPECT_EQ(record.instance_id, 9);
  EXPECT_EQ(record.face, world.triangles()[hits[1].triangle].face);
  EXPECT_TRUE(record.plain);
  EXPECT_EQ(hits[2].triangle, no_hit);
  EXPECT_EQ(hits[2].range, 0.0);
}

TEST(World, TrianglesOfAFaceShareItsPlaneToTheBit) {
  const Scene scene = testing::random_boxes(30, 8);
  const World world(scene);
  for (std::uint32_t t = 1; t < world.triangles().size(); ++t) {
    if (world.triangles()[t].face != world.triangles()[t - 1].face) continue;
    EXPECT_EQ(world.plane(t).normal, world.plane(t - 1).normal);
    EXPECT_EQ(world.plane(t).offset, world.plane(t - 1).offset);
  }
}

TEST(World, MinimumRangeSkipsWhatIsNearer) {
  Scene scene = testing::empty_scene();
  scene.instances.push_back(box_instance(1, {0.2, 1, 1}, at(1, 0, 0)));
  scene.instances.push_back(box_instance(2, {0.2, 1, 1}, at(2, 0, 0)));
  const World world(scene);
  const std::vector<Ray> rays = {{{0, 0, 0}, {1, 0, 0}}};
  std::vector<Hit> hits(1);
  world.trace(rays, hits, 1.5);
  EXPECT_NEAR(hits[0].range, 1.9, 1e-12);
}

TEST(World, RangeOfAFaceSeenEdgeOnStaysOnTheFace) {
  Scene scene = testing::empty_scene();
  scene.instances.push_back(box_instance(1, {1, 1, 0.5}, at(3, 0, -0.25)));
  const World world(scene);
  for (std::uint32_t t = 0; t < world.triangles().size(); ++t) {
    const double range = world.range_to(t, {0, 0, 0}, Eigen::Vector3d(1, 0, -1e-12).normalized());
    if (std::fabs(world.normal(t).x()) > 0.5) continue;
    EXPECT_GE(range, 2.5 - 1e-9);
    EXPECT_LE(range, 3.5 + 1e-9);
  }
}

TEST(World, OutlineHasTheTwelveEdgesOfABoxOnceAFace) {
  Scene scene = testing::empty_scene();
  scene.instances.push_back(box_instance(1, {1, 2, 3}, at(0, 0, 0)));
  const World world(scene);
  double length = 0.0;
  for (const auto& edge : world.outline()) length += (edge.to - edge.from).norm();
  EXPECT_EQ(world.outline().size(), 24U) << "each edge from both of its faces, no diagonal";
  EXPECT_NEAR(length, 2 * 4 * (1 + 2 + 3), 1e-12);
}

TEST(World, UnknownPacketWidthIsWrongUsage) {
  WorldOptions options;
  options.packet_width = 3;
  try {
    const World world(testing::empty_scene(), options);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::wrong_usage);
  }
}

TEST(World, EmptySceneIsHitByNothing) {
  const World world(testing::empty_scene());
  const std::vector<Ray> rays = {{{0, 0, 0}, {1, 0, 0}}};
  std::vector<Hit> hits(1);
  world.trace(rays, hits);
  EXPECT_EQ(hits[0].triangle, no_hit);
}

}  // namespace
}  // namespace scanchor
