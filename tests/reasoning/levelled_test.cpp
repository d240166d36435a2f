#include "reasoning/levelled.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "tests/reasoning/support/built.hpp"

namespace scanchor {
namespace {

TEST(Levelled, TurnsUpToTheAxisAndTheSensorWithIt) {
  auto surfaces = test::make_surfaces({test::desk_plate()});
  surfaces.sensor_positions = {Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(9, 9, 9)};
  ReasonOptions options;
  options.up = "1,0,0";
  const Levelled levelled = level(surfaces, options);
  EXPECT_NEAR((levelled.R_level_cloud * levelled.up.up - Eigen::Vector3d::UnitZ()).norm(), 0,
              1e-12);
  EXPECT_EQ(levelled.around.up_sigma, levelled.up.sigma);
  ASSERT_TRUE(levelled.around.viewpoint);
  EXPECT_NEAR(levelled.around.viewpoint->z(), levelled.up.up.dot(Eigen::Vector3d(1, 2, 3)), 1e-12);
}

TEST(Levelled, WithoutASensorThereIsNoViewpoint) {
  auto surfaces = test::make_surfaces({test::desk_plate()});
  surfaces.sensor_positions.clear();
  EXPECT_FALSE(level(surfaces, {}).around.viewpoint);
  ReasonOptions options;
  options.up = "somewhere";
  EXPECT_THROW(level(surfaces, options), Error);
}

}  // namespace
}  // namespace scanchor
