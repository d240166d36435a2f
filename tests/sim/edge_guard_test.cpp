#include "sim/edge_guard.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "scenes/generator.hpp"
#include "sim/world.hpp"

namespace scanchor {
namespace {

// Rays at the very edges of things, from a place to scan from: the worst there is. What is left are
// edges of curved things seen edge-on, whose rims are too.
std::vector<Ray> rays_at_edges(const World& world, const Eigen::Vector3d& eye) {
  SequentialRandom random(3);
  std::vector<Ray> rays;
  for (const FaceEdge& edge : world.outline()) {
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d at = edge.from + random.uniform() * (edge.to - edge.from);
      Eigen::Vector3d d = at - eye;
      if (d.norm() < 0.1) continue;
      // Within some ten nanometres of it.
      d += 1e-8 * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
      rays.push_back({eye, d.normalized()});
    }
  }
  return rays;
}

TEST(EdgeGuard, RaysAtEdgesMeetTheSameOnEveryProcessor) {
  RoomOptions options;
  options.family = "living room";
  const Scene scene = generate_room(options, 60);
  const World reference(scene);
  const auto rays = rays_at_edges(reference, scene.sensor_poses[0].translation());
  ASSERT_GT(rays.size(), 10000U);
  std::vector<Hit> first(rays.size());
  reference.trace(rays, first);
  for (const char* isa : {"sse2", "avx2", ""}) {
    for (const int width : {1, 8, 16}) {
      WorldOptions how;
      how.embree_isa = isa;
      how.packet_width = width;
      std::vector<Hit> hits(rays.size());
      World(scene, how).trace(rays, hits);
      std::size_t differ = 0;
      for (std::size_t i = 0; i < rays.size(); ++i)
        differ += hits[i].triangle != first[i].triangle || hits[i].range != first[i].range ? 1 : 0;
      EXPECT_LT(differ, rays.size() / 1000) << isa << " width " << width;
    }
  }
}

// Against all triangles one by one, which is what it promises; and no closed room leaks.
TEST(EdgeGuard, TheRimChangesNoAnswer) {
  const Scene scene = generate_room({}, 61);
  const World world(scene);
  std::vector<Eigen::Vector3d> corners;
  for (std::uint32_t t = 0; t < world.triangles().size(); ++t) {
    for (int c = 0; c < 3; ++c) corners.push_back(world.corner(t, c));
  }
  const EdgeGuard guard(corners, {0});
  const Eigen::Vector3d eye = scene.sensor_poses[0].translation();
  const auto rays = rays_at_edges(world, eye);
  std::vector<Hit> hits(rays.size());
  world.trace(rays, hits);
  std::size_t asked = 0, other = 0;
  for (std::size_t i = 0; i < rays.size(); i += 7) {
    const std::uint32_t alone = guard.nearest(rays[i].origin, rays[i].direction, 1e-4);
    ASSERT_NE(alone, no_hit);
    ASSERT_NE(hits[i].triangle, no_hit);
    // Two triangles of one face are as good as each other.
    other += world.triangles()[alone].face != world.triangles()[hits[i].triangle].face ? 1 : 0;
    ++asked;
  }
  EXPECT_LT(other, asked / 500) << "of " << asked;
}

TEST(EdgeGuard, TheRimIsAMillionthOfTheSceneAndLiesAroundTheTriangle) {
  const std::vector<Eigen::Vector3d> corners = {{0, 0, 0}, {8, 0, 0}, {0, 6, 0}};
  const EdgeGuard guard(corners, {0});
  EXPECT_NEAR(guard.rim(), 1e-5, 1e-12);
  Eigen::Vector3f wide[3];
  guard.with_rim(0, wide);
  EXPECT_NEAR(wide[0].x(), -1e-5, 1e-9);
  EXPECT_NEAR(wide[0].y(), -1e-5, 1e-9);
  EXPECT_NEAR(wide[1].y(), -1e-5, 1e-6);
  EXPECT_FALSE(guard.on_rim(0, 0.3F, 0.3F));
  EXPECT_TRUE(guard.on_rim(0, 1e-6F, 0.3F));
  EXPECT_TRUE(guard.on_rim(0, 0.3F, 0.7F));
  // A triangle without an area is never believed.
  const std::vector<Eigen::Vector3d> line = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  EXPECT_TRUE(EdgeGuard(line, {0}).on_rim(0, 0.3F, 0.3F));
}

}  // namespace
}  // namespace scanchor
