#include "cloud/point_cloud.hpp"

#include <gtest/gtest.h>

namespace scanchor {
namespace {

TEST(PointCloud, FieldsAreFoundByName) {
  PointCloud cloud;
  cloud.points.resize(2);
  cloud.set({"intensity", std::vector<float>{1.5F, 2.5F}});
  cloud.set({"label", std::vector<std::uint8_t>{7, 255}});
  ASSERT_NE(cloud.find("label"), nullptr);
  EXPECT_EQ(cloud.find("label")->at(1), 255.0);
  EXPECT_EQ(cloud.find("intensity")->size(), 2U);
  EXPECT_EQ(cloud.find("Label"), nullptr);
}

TEST(PointCloud, SetReplacesAFieldInItsPlace) {
  PointCloud cloud;
  cloud.points.resize(1);
  cloud.set({"a", std::vector<float>{1.0F}});
  cloud.set({"b", std::vector<float>{2.0F}});
  cloud.set({"a", std::vector<std::int32_t>{-3}});
  ASSERT_EQ(cloud.fields.size(), 2U);
  EXPECT_EQ(cloud.fields[0].name, "a");
  EXPECT_EQ(cloud.fields[0].at(0), -3.0);
}

}  // namespace
}  // namespace scanchor
