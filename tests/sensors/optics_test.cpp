#include "sensors/optics.hpp"

#include <gtest/gtest.h>

namespace scanchor {
namespace {

TEST(Optics, SchlickFromNormalToGrazing) {
  EXPECT_DOUBLE_EQ(schlick(0.04, 1.0), 0.04);
  EXPECT_DOUBLE_EQ(schlick(0.04, 0.0), 1.0);
  EXPECT_NEAR(schlick(0.04, 0.5), 0.04 + 0.96 / 32.0, 1e-15);
}

TEST(Optics, GlassSharesFAndOneMinusFSquared) {
  const LidarOptions o;
  const Material pane{"pane", 0.0, 0.0, 1.0, {}};
  const LightSplit split = split_light(o, pane, 1.0);
  EXPECT_NEAR(split.own, 0.04, 1e-15);
  EXPECT_NEAR(split.through, 0.96 * 0.96, 1e-15);
  EXPECT_EQ(split.mirrored, 0.0);
}

TEST(Optics, MirrorSendsItsShareOutAndBack) {
  const Material mirror{"mirror", 0.02, 0.9, 0.0, {}};
  const LightSplit split = split_light(LidarOptions(), mirror, 0.7);
  EXPECT_NEAR(split.mirrored, 0.81, 1e-15);
  EXPECT_NEAR(split.own, 0.02, 1e-15);
}

TEST(Optics, SwitchedOffItIsPaint) {
  LidarOptions o;
  o.glass = o.mirrors = false;
  const LightSplit split = split_light(o, {"both", 0.1, 0.3, 0.5, {}}, 0.7);
  EXPECT_EQ(split.through, 0.0);
  EXPECT_EQ(split.mirrored, 0.0);
  EXPECT_NEAR(split.own, 0.9, 1e-15);
}

}  // namespace
}  // namespace scanchor
