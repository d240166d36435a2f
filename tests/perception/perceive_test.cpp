#include "perception/perceive.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace scanchor {
namespace {

TEST(Perceive, OptionsByName) {
  PerceiveOptions options;
  OptionList list;
  list.add_group("perception", options);
  list.set_assignment("perception.noise_sigma=0.02");
  list.set_assignment("perception.method=paper");
  EXPECT_EQ(options.noise_sigma, 0.02);
  EXPECT_EQ(options.method, "paper");
  EXPECT_THROW(list.set("perception.method", "ransac"), Error);
  EXPECT_THROW(list.set("perception.noise_sigma", "-1"), Error);
}

TEST(Perceive, ShapesOnlyWhenAsked) {
  PointCloud cloud;
  for (int i = 0; i < 40; ++i) {
    for (int j = 0; j < 30; ++j) cloud.points.emplace_back(0.02 * i, 0.02 * j, 0.0);
  }
  PerceiveOptions options;
  const Surfaces with = perceive(cloud, options);
  ASSERT_EQ(with.surfaces.size(), 1U);
  EXPECT_FALSE(with.surfaces[0].polygons.empty());
  options.shapes = false;
  const Surfaces without = perceive(cloud, options);
  ASSERT_EQ(without.surfaces.size(), 1U);
  EXPECT_TRUE(without.surfaces[0].polygons.empty());
}

}  // namespace
}  // namespace scanchor
