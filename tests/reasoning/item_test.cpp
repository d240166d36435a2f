#include "reasoning/item.hpp"

#include <gtest/gtest.h>

#include "tests/reasoning/support/built.hpp"

namespace scanchor {
namespace {

TEST(Item, TakesItsNumbersFromTheSurface) {
  const auto items =
      make_items(test::make_surfaces({test::screen_plate(1.0)}), Eigen::Matrix3d::Identity());
  ASSERT_EQ(items.size(), 1U);
  EXPECT_NEAR(items[0].extension.value, 0.57, 1e-12);
  EXPECT_NEAR(items[0].width.value, 0.42, 1e-12);
  EXPECT_NEAR(items[0].z_low, 0.85, 1e-9);
  EXPECT_NEAR(items[0].z_high, 1.27, 1e-9);
  EXPECT_NEAR(items[0].height.value, 0.42, 1e-9);
  EXPECT_NEAR(items[0].area.sigma, 0.005 * 0.99, 1e-9);
  EXPECT_EQ(items[0].area.hidden, 0.0);
  EXPECT_NEAR(items[0].footprint.area(), (0.57 + 0.05) * 0.05, 1e-9)
      << "a standing plate is thickened to 5 cm";
}

TEST(Item, LevellingTurnsUpToZ) {
  const Eigen::Vector3d up = Eigen::Vector3d(0.1, -0.2, 0.9).normalized();
  EXPECT_NEAR((levelling(up) * up - Eigen::Vector3d::UnitZ()).norm(), 0.0, 1e-12);
  EXPECT_NEAR((levelling(-Eigen::Vector3d::UnitZ()) * -Eigen::Vector3d::UnitZ()).z(), 1.0, 1e-12);
}

TEST(Item, WithoutShapeItSaysSo) {
  Surfaces surfaces;
  surfaces.surfaces.resize(1);
  const auto items = make_items(surfaces, Eigen::Matrix3d::Identity());
  EXPECT_FALSE(items[0].has_shape);
}

TEST(Item, GroupIsTheBoxOfItsMembers) {
  auto items = make_items(test::make_surfaces(test::shelf_boards(3)), Eigen::Matrix3d::Identity());
  const Item shelf = make_group(items, {2, 0, 1}, 3);
  EXPECT_EQ(shelf.members, (std::vector<std::int32_t>{0, 1, 2}));
  EXPECT_NEAR(shelf.extension.value, 1.16, 1e-9);
  EXPECT_NEAR(shelf.width.value, 0.35, 1e-9);
  EXPECT_NEAR(shelf.height.value, 0.8, 1e-9);
  EXPECT_NEAR((shelf.center - Eigen::Vector3d(-2, -2, 0.7)).norm(), 0.0, 1e-9);
}

TEST(Item, TheBoxOfUprightPanelsTurnsWithThem) {
  for (const double turn : {0.0, 0.5, 1.2, 2.9}) {
    const Eigen::Matrix3d R = Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    std::vector<test::Plate> plates(2);
    for (int i = 0; i < 2; ++i) {
      plates[i].center = R * Eigen::Vector3d(0.9 * i, 1.0, 0.9);
      plates[i].normal = R * Eigen::Vector3d::UnitX();
      plates[i].along = Eigen::Vector3d::UnitZ();
      plates[i].length = 1.8;
      plates[i].width = 0.4;
    }
    const auto items = make_items(test::make_surfaces(plates), Eigen::Matrix3d::Identity());
    const Item panels = make_group(items, {0, 1}, 2);
    EXPECT_NEAR(panels.extension.value, 0.9, 1e-9) << turn;
    EXPECT_NEAR(panels.width.value, 0.4, 1e-9) << turn;
    EXPECT_NEAR(panels.height.value, 1.8, 1e-9) << turn;
  }
}

TEST(Item, TwinsAreEqualToTheLastBit) {
  std::vector<test::Plate> plates(5, test::desk_plate());
  plates[1].center.x() += 1e-9;
  plates[3].hidden = 0.3;
  const auto items = make_items(test::make_surfaces(plates), Eigen::Matrix3d::Identity());
  EXPECT_EQ(first_of_twins(items), (std::vector<std::int32_t>{0, 1, 0, 3, 0}));
  EXPECT_TRUE(same_geometry(items[0], items[2]));
  EXPECT_FALSE(same_geometry(items[0], items[3]));
}

}  // namespace
}  // namespace scanchor
