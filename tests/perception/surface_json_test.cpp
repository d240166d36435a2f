#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/json.hpp"
#include "core/random.hpp"
#include "perception/surface.hpp"

namespace scanchor {
namespace {

Surfaces example() {
  SequentialRandom random(5);
  Surfaces all;
  all.plane_of_point = {0, -1, 0, 1, 0, 1, 1};
  all.noise_sigma = 0.0101;
  all.point_spacing = 1.0 / 3.0;
  all.set_aside = {3, 4, 5};
  all.sensor_positions = {{0.1, 0.2, 0.3}};
  for (int i = 0; i < 2; ++i) {
    Surface s;
    s.id = i;
    s.plane.normal =
        Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
    s.plane.offset = random.normal();
    s.plane.centroid = {random.normal(), 1e6 + random.normal(), random.normal()};
    s.plane.residual_sigma = random.uniform();
    s.plane.normal_covariance << 1e-7, 2e-9, 0, 2e-9, 3e-8, 0, 0, 0, 0;
    s.plane.centroid_sigma = 1e-4;
    s.T_cloud_surface.linear() =
        Eigen::Quaterniond(random.normal(), random.normal(), random.normal(), 1)
            .normalized()
            .toRotationMatrix();
    s.T_cloud_surface.translation() = s.plane.centroid;
    s.inliers = i == 0 ? std::vector<std::uint32_t>{0, 2, 4} : std::vector<std::uint32_t>{3, 5, 6};
    s.inlier_count = 3;
    s.polygons.push_back({{{0, 0}, {random.uniform(), 0}, {0.3, 0.7}},
                          {{{0.1, 0.1}, {0.1, 0.2}, {0.2, 0.1}}},
                          {EdgeKind::true_edge, EdgeKind::occlusion, EdgeKind::view_limit}});
    s.rectangle.center = {random.normal(), random.normal()};
    s.rectangle.angle = random.normal();
    s.rectangle.length = {0.57, 0.565, 0.58, true};
    s.area = {0.24, 0.23, 0.25, false};
    s.rectangularness = 0.97;
    s.is_rectangle = i == 0;
    s.eccentricity = 0.8;
    s.occluded_outline = 0.25;
    s.confidence = 0.5;
    all.surfaces.push_back(s);
  }
  return all;
}

TEST(SurfaceJson, WhatIsReadBackWritesTheSameBytes) {
  const Surfaces all = example();
  for (const bool with_inliers : {true, false}) {
    const Json json = surfaces_to_json(all, with_inliers);
    const Surfaces back = surfaces_from_json(Json::parse(json.dump()), "surfaces.json");
    EXPECT_EQ(surfaces_to_json(back, with_inliers).dump(), json.dump());
    EXPECT_EQ(back.surfaces[1].plane.centroid, all.surfaces[1].plane.centroid);
    EXPECT_EQ(back.surfaces[1].T_cloud_surface.matrix(), all.surfaces[1].T_cloud_surface.matrix());
    EXPECT_EQ(back.surfaces[0].inlier_count, 3U);
  }
}

TEST(SurfaceJson, InliersRestoreThePlaneOfEachPoint) {
  const Surfaces all = example();
  EXPECT_EQ(surfaces_from_json(surfaces_to_json(all, true), "f").plane_of_point,
            all.plane_of_point);
  EXPECT_EQ(surfaces_from_json(surfaces_to_json(all, false), "f").plane_of_point,
            std::vector<std::int32_t>(7, -1));
}

/// The error's line for a change to the example.
std::string complaint(const std::function<void(Json&)>& change) {
  Json json = surfaces_to_json(example(), true);
  change(json);
  try {
    surfaces_from_json(json, "s.json");
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::bad_data);
    return error.what();
  }
  return "no error";
}

TEST(SurfaceJson, ErrorsNameFileAndPlace) {
  EXPECT_NE(complaint([](Json& j) { j["format"] = "map"; }).find("s.json"), std::string::npos);
  EXPECT_NE(complaint([](Json& j) { j["version"] = 9; }).find("version"), std::string::npos);
  EXPECT_NE(complaint([](Json& j) {
              j["surfaces"][1]["inliers"][0] = 0;
            }).find("point 0 belongs to surface 0"),
            std::string::npos);
  EXPECT_NE(complaint([](Json& j) {
              j["surfaces"][0]["inliers"][2] = 99;
            }).find("surfaces[0].inliers[2]"),
            std::string::npos);
  EXPECT_NE(complaint([](Json& j) { j["surfaces"][0]["inliers"][1] = 0; }).find("rise"),
            std::string::npos);
  EXPECT_NE(
      complaint([](Json& j) { j["surfaces"][0]["area"]["low"] = 9.0; }).find("surfaces[0].area"),
      std::string::npos);
  EXPECT_NE(
      complaint([](Json& j) { j["surfaces"][0]["plane"]["normal"][0] = 2.0; }).find("length 1"),
      std::string::npos);
  EXPECT_NE(complaint([](Json& j) {
              j["surfaces"][0]["polygons"][0]["outer_kind"][0] = "shade";
            }).find("shade"),
            std::string::npos);
  EXPECT_NE(complaint([](Json& j) {
              j["surfaces"][0]["polygons"][0]["outer_kind"].erase(0);
            }).find("2 kinds for 3 edges"),
            std::string::npos);
  EXPECT_NE(
      complaint([](Json& j) { j["surfaces"][0]["rectangularity"] = 1; }).find("rectangularness"),
      std::string::npos);
  EXPECT_NE(complaint([](Json& j) { j["surfaces"][1]["id"] = 7; }).find("must be 1"),
            std::string::npos);
  EXPECT_NE(complaint([](Json& j) {
              j["surfaces"][0]["T_cloud_surface"]["x_axis"] = {1, 1, 0};
            }).find("right angles"),
            std::string::npos);
}

TEST(SurfaceJson, TextThatIsNoListOfSurfacesIsRefused) {
  EXPECT_THROW(surfaces_from_json(Json::parse("[]"), "f"), Error);
  EXPECT_THROW(surfaces_from_json(Json::parse("{}"), "f"), Error);
}

}  // namespace
}  // namespace scanchor
