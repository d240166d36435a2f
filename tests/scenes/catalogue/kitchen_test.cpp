#include <gtest/gtest.h>

#include <cmath>

#include "tests/scenes/support/scene_checks.hpp"

namespace scanchor {
namespace {

using testing::alone;
using testing::find_face;
using testing::find_part;

TEST(Kitchen, WorktopsAreLevel) {
  const Scene counter = alone({"kitchen counter", "plain", 1, {{"height", 0.9}}, 0.0});
  EXPECT_NEAR(find_face(*find_part(counter.instances[0], "worktop"), "top")->center.z(), 0.9,
              1e-12);
  const Scene sink = alone({"sink counter", "single basin", 1, {{"height", 0.9}}, 0.0});
  const Part* top = find_part(sink.instances[0], "worktop");
  const Face* front = find_face(*top, "front");
  EXPECT_NEAR((top->T_instance_part * front->center).z(), 0.9, 1e-12);
  EXPECT_NEAR((top->T_instance_part.linear() * front->normal).z(), 1.0, 1e-12);
  // The basin is cut out of it.
  EXPECT_NEAR(front->area, front->size.prod() - 0.34 * 0.36, 1e-9);
}

TEST(Kitchen, TwoBasinsAreTwo) {
  for (const double width : {0.8, 1.2, 0.56}) {
    const Scene sink = alone({"sink counter", "two basins", 1, {{"width", width}}, 0.0});
    const Face* front = find_face(*find_part(sink.instances[0], "worktop"), "front");
    EXPECT_NEAR(front->area, front->size.prod() - 2 * (width < 0.8 ? 0.18 : 0.30) * 0.36, 1e-9);
    const Part* left = find_part(sink.instances[0], "second basin floor");
    const Part* right = find_part(sink.instances[0], "basin floor");
    ASSERT_TRUE(left != nullptr && right != nullptr);
    testing::expect_no_close_faces(sink, "two basins");
  }
}

TEST(Kitchen, FridgeFreezerHasTwoDoorsInOnePlane) {
  const Scene scene = alone({"refrigerator", "fridge-freezer", 1, {}, 0.0});
  const Face* low = find_face(*find_part(scene.instances[0], "freezer door"), "front");
  const Face* high = find_face(*find_part(scene.instances[0], "fridge door"), "front");
  EXPECT_EQ(low->center.y(), high->center.y());
  EXPECT_LT(low->center.z(), high->center.z());
}

TEST(Kitchen, AppliancesFitTheGrid) {
  for (const char* kind : {"dishwasher", "oven", "washing machine"}) {
    for (std::uint64_t seed = 0; seed < 6; ++seed)
      EXPECT_LE(local_bounds(alone({kind, "", seed, {}, 0.0}).instances[0]).sizes().x(),
                0.6 + 1e-9);
  }
}

}  // namespace
}  // namespace scanchor
