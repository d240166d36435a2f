#include "results/draw_cloud.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "core/error.hpp"
#include "tests/results/samples.hpp"

namespace scanchor {
namespace {

PointCloud sample() {
  PointCloud cloud;
  for (int i = 0; i < 100; ++i) cloud.points.emplace_back(i % 10, i / 10, 0.01 * i);
  cloud.set({"label", std::vector<std::int32_t>(100, *find_class("desk"))});
  std::vector<float> truth(100);
  for (std::size_t i = 0; i < 100; ++i)
    truth[i] = float(cloud.points[i].norm() - (i < 50 ? 0.01 : -0.01));
  cloud.set({"true_range", truth});
  std::vector<std::uint8_t> flags(100, 0);
  flags[3] = point_mixed;
  flags[4] = point_ghost | point_mixed;
  cloud.set({"flags", flags});
  return cloud;
}

DrawCloudOptions by(CloudColor color) {
  DrawCloudOptions options;
  options.color = color;
  return options;
}

TEST(DrawCloud, ByClass) {
  const Drawing drawing = draw_cloud(sample(), by(CloudColor::class_id));
  EXPECT_EQ(drawing.points[0].colors[7], color_of_class(*find_class("desk")));
  ASSERT_EQ(drawing.legend.size(), 1u);
  EXPECT_EQ(drawing.legend[0].text, "desk");
}

TEST(DrawCloud, ByHeight) {
  const Drawing drawing = draw_cloud(sample(), by(CloudColor::height));
  ASSERT_TRUE(drawing.legend_bar);
  EXPECT_NEAR(drawing.legend_bar->high, 0.99, 0.02);
  EXPECT_EQ(drawing.points[0].colors[0], color_map(ColorMap::viridis, 0));
  EXPECT_EQ(drawing.points[0].colors[99], color_map(ColorMap::viridis, 1));
}

TEST(DrawCloud, ByRangeErrorIsSigned) {
  const Drawing drawing = draw_cloud(sample(), by(CloudColor::range_error));
  const Color too_far = drawing.points[0].colors[20];
  const Color too_near = drawing.points[0].colors[70];
  EXPECT_GT(too_far.r, too_far.b);
  EXPECT_GT(too_near.b, too_near.r);
  EXPECT_NEAR(drawing.legend_bar->high, 10.0, 0.1);  // mm
}

TEST(DrawCloud, ByFlagsCountsThem) {
  const Drawing drawing = draw_cloud(sample(), by(CloudColor::flags));
  std::string all;
  for (const LegendEntry& entry : drawing.legend) all += entry.text + ";";
  EXPECT_NE(all.find("mixed: 1"), std::string::npos) << all;
  EXPECT_NE(all.find("ghost (mirror): 1"), std::string::npos) << all;
}

TEST(DrawCloud, AMissingFieldIsNamedWithThoseThatAreThere) {
  try {
    draw_cloud(sample(), by(CloudColor::intensity));
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("intensity"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("true_range"), std::string::npos);
  }
}

TEST(DrawCloud, PointsWithoutAPositionAreCounted) {
  PointCloud cloud = sample();
  cloud.points[5].x() = std::numeric_limits<double>::quiet_NaN();
  const Drawing drawing = draw_cloud(cloud);
  EXPECT_EQ(drawing.points[0].positions.size(), 99u);
  EXPECT_NE(drawing.subtitle.find("1 point"), std::string::npos);
}

TEST(DrawCloud, SheetsSeenFromBehindAreLeftOut) {
  DrawCloudOptions options;
  options.sheet_normals.assign(100, Eigen::Vector3d::Zero());
  for (std::size_t i = 0; i < 30; ++i) options.sheet_normals[i] = {0, 0, -1};  // a ceiling
  options.towards_eye = {0, 0, 1};
  EXPECT_EQ(draw_cloud(sample(), options).points[0].positions.size(), 70u);
  options.towards_eye = {0, 0, -1};
  EXPECT_EQ(draw_cloud(sample(), options).points[0].positions.size(), 100u);
}

TEST(DrawCloud, EmptyIsEmpty) {
  for (const CloudColor color : {CloudColor::plain, CloudColor::height}) {
    EXPECT_TRUE(draw_cloud(PointCloud{}, by(color)).bounds.isEmpty());
  }
}

TEST(DrawCloud, SpacingOfAGrid) {
  PointCloud cloud;
  for (int i = 0; i < 200; ++i) {
    for (int k = 0; k < 200; ++k) cloud.points.emplace_back(0.01 * i, 0.01 * k, 0);
  }
  EXPECT_NEAR(typical_spacing(cloud), 0.01, 0.001);
  EXPECT_EQ(typical_spacing(PointCloud{}), 0.0);
}

TEST(DrawCloud, PlanesComeFromTheSurfaces) {
  Surfaces surfaces;
  surfaces.plane_of_point.assign(100, -1);
  surfaces.plane_of_point[2] = 0;
  surfaces.surfaces.resize(1);
  surfaces.surfaces[0].area.value = 3.0;
  surfaces.surfaces[0].plane.normal = {0, 1, 0};
  EXPECT_EQ(draw_cloud(with_planes(sample(), surfaces), by(CloudColor::plane)).points[0].colors[2],
            color_of_number(0));
  EXPECT_EQ(sheets_of_surfaces(surfaces)[2], Eigen::Vector3d(0, 1, 0));
  EXPECT_EQ(sheets_of_surfaces(surfaces, 4.0)[2], Eigen::Vector3d::Zero());
  surfaces.plane_of_point.pop_back();
  EXPECT_THROW(with_planes(sample(), surfaces), Error);
}

TEST(DrawCloud, SheetsOfAScanAreWallsFloorsAndCeilings) {
  const Scene scene = samples::room();
  Scan scan;
  scan.truth.resize(3);
  scan.truth.face = {0, 1, 4};  // floor, near wall, a face of the desk
  scan.T_world_sensor.rotate(Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ()));
  const auto normals = sheets_of_scan(scan, scene);
  EXPECT_TRUE(normals[0].isApprox(Eigen::Vector3d::UnitZ()));
  EXPECT_TRUE(
      normals[1].isApprox(Eigen::Vector3d::UnitX()));  // +y of the world in the sensor's frame
  EXPECT_EQ(normals[2], Eigen::Vector3d::Zero());
}

}  // namespace
}  // namespace scanchor
