#include "results/gl_geometry.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace scanchor {
namespace {

constexpr int width = 200, height = 100;

/// From above onto the unit square about the origin; 100 px are 2 m.
Projection from_above() {
  View view;
  view.eye = {0, 0, 5};
  view.target = {0, 0, 0};
  view.up = {0, 1, 0};
  view.vertical_fov_deg = 0.0;
  view.parallel_height = 2.0;
  return {view, width, height,
          Eigen::AlignedBox3d(Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(1, 1, 1))};
}

TEST(GlGeometry, ALineIsAsWideAsItSaysInPixels) {
  Drawing drawing;
  DrawnLines lines;
  lines.ends = {{-0.5, 0, 0}, {0.5, 0, 0}};
  lines.width_px = 4.0;
  drawing.lines.push_back(lines);
  const auto vertices = line_vertices(drawing, from_above(), width, height, false);
  ASSERT_EQ(vertices.size(), 6U);
  float low = 1e9F, high = -1e9F, left = 1e9F, right = -1e9F;
  for (const auto& vertex : vertices) {
    const float x = vertex.clip[0] / vertex.clip[3] * width / 2;
    const float y = vertex.clip[1] / vertex.clip[3] * height / 2;
    low = std::min(low, y);
    high = std::max(high, y);
    left = std::min(left, x);
    right = std::max(right, x);
  }
  EXPECT_NEAR(high - low, 4.0F, 1e-3F);
  EXPECT_NEAR(right - left, 50.0F + 4.0F, 1e-3F);  // 1 m, and half a width beyond each end
}

TEST(GlGeometry, HiddenLinesAndOutlinesAreApart) {
  Drawing drawing;
  DrawnLines through;
  through.ends = {{0, 0, 0}, {1, 0, 0}};
  through.hidden = true;
  drawing.lines.push_back(through);
  DrawnPolygon polygon;
  polygon.outer = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
  drawing.polygons.push_back(polygon);
  EXPECT_EQ(line_vertices(drawing, from_above(), width, height, true).size(), 6U);
  EXPECT_EQ(line_vertices(drawing, from_above(), width, height, false).size(), 18U);
}

TEST(GlGeometry, WhatIsBehindTheEyeIsCutOff) {
  View view;
  view.eye = {0, 0, 0};
  view.target = {1, 0, 0};
  const Projection projection(
      view, width, height,
      Eigen::AlignedBox3d(Eigen::Vector3d(1, -1, -1), Eigen::Vector3d(9, 1, 1)));
  Drawing drawing;
  DrawnLines lines;
  lines.ends = {{-5, 0, 0}, {-2, 0, 0}, {-5, 1, 0}, {5, 1, 0}};
  drawing.lines.push_back(lines);
  const auto vertices = line_vertices(drawing, projection, width, height, false);
  EXPECT_EQ(vertices.size(), 6U);  // the first line is behind altogether
  for (const auto& vertex : vertices) EXPECT_GT(vertex.clip[3], 0.0F);
}

TEST(GlGeometry, AFillingLeavesItsHoleOut) {
  DrawnPolygon polygon;
  polygon.outer = {{0, 0, 2}, {4, 0, 2}, {4, 4, 2}, {0, 4, 2}};
  polygon.holes = {{{1, 1, 2}, {1, 2, 2}, {2, 2, 2}, {2, 1, 2}}};
  const DrawnMesh mesh = filling(polygon);
  double area = 0.0;
  for (const auto& t : mesh.triangles) {
    const auto& a = mesh.vertices[std::size_t(t[0])];
    area +=
        0.5 *
        (mesh.vertices[std::size_t(t[1])] - a).cross(mesh.vertices[std::size_t(t[2])] - a).norm();
  }
  EXPECT_NEAR(area, 15.0, 1e-9);
  EXPECT_EQ(mesh.colors.size(), mesh.vertices.size());
  polygon.outer = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};  // on a line
  polygon.holes.clear();
  EXPECT_TRUE(filling(polygon).triangles.empty());
}

}  // namespace
}  // namespace scanchor
