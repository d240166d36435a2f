#include "eval/relation_training.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "eval/truth.hpp"
#include "tests/eval/support/small_scan.hpp"

namespace scanchor {
namespace {

TEST(RelationTraining, TellsWhatTrulyHoldsBetweenWhatWasFound) {
  const SmallScan made = small_scan();
  const RelationScene scene = relation_scene(made.scan, made.scene, Protocol{}, {}, {});
  ASSERT_FALSE(scene.normals.empty());
  EXPECT_EQ(scene.items.size(), scene.surfaces.surfaces.size());
  // The found normals are near the true ones.
  for (const auto& sample : scene.normals) {
    const auto& found = scene.surfaces.surfaces[static_cast<std::size_t>(sample.surface)].plane;
    EXPECT_GT(std::abs(found.normal.dot(sample.normal)), 0.95);
  }
  // Of two level faces one is parallel to the other, and the upper one above the lower one.
  int parallel = 0, above = 0;
  for (const auto& sample : scene.samples) {
    const Item& a = scene.items[static_cast<std::size_t>(sample.a)];
    const Item& b = scene.items[static_cast<std::size_t>(sample.b)];
    if (std::abs(a.normal.z()) < 0.99 || std::abs(b.normal.z()) < 0.99) continue;
    if (sample.relation == Relation::parallel) {
      EXPECT_TRUE(sample.holds);
      ++parallel;
    }
    if (sample.relation == Relation::above && sample.holds) {
      EXPECT_GT(a.z, b.z);
      ++above;
    }
  }
  EXPECT_GT(parallel, 0);
  EXPECT_GT(above, 0);
}

TEST(RelationTraining, KeepsNoPoints) {
  const SmallScan made = small_scan();
  const RelationScene scene = relation_scene(made.scan, made.scene, Protocol{}, {}, {});
  EXPECT_TRUE(scene.surfaces.plane_of_point.empty());
  for (const auto& surface : scene.surfaces.surfaces) {
    EXPECT_TRUE(surface.inliers.empty());
    EXPECT_GT(surface.inlier_count, 0U);
  }
}

}  // namespace
}  // namespace scanchor
