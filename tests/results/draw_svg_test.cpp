#include "results/draw_svg.hpp"

#include <gtest/gtest.h>

#include "results/draw_surfaces.hpp"
#include "tests/results/samples.hpp"
#include "tests/results/surface_samples.hpp"

namespace scanchor {
namespace {

TEST(DrawSvg, FarPiecesComeFirst) {
  Drawing drawing;
  for (const double z : {2.0, 0.0, 1.0}) {
    DrawnPolygon polygon;
    polygon.outer = {{-1, -1, z}, {1, -1, z}, {1, 1, z}};
    polygon.fill = {std::uint8_t(100 + 10 * z), 0, 0, 255};
    drawing.polygons.push_back(polygon);
  }
  drawing.bounds = bounds_of(drawing);
  const VectorPicture picture = draw_outlines(drawing, samples::from_above());
  std::vector<int> order;
  for (const auto& item : picture.items) {
    const auto* shape = std::get_if<VectorShape>(&item);
    if (shape != nullptr && shape->fill.g == 0 && shape->fill.r >= 100)
      order.push_back(shape->fill.r);
  }
  EXPECT_EQ(order, (std::vector<int>{100, 110, 120}));
}

TEST(DrawSvg, HolesAreRingsOfTheSamePath) {
  const Drawing drawing = draw_surfaces(samples::two_surfaces());
  const VectorPicture picture = draw_outlines(drawing, perspective_view(drawing.bounds));
  bool found = false;
  for (const auto& item : picture.items) {
    const auto* shape = std::get_if<VectorShape>(&item);
    found = found || (shape != nullptr && shape->paths.size() == 2);
  }
  EXPECT_TRUE(found);
  EXPECT_EQ(to_svg(picture), to_svg(draw_outlines(drawing, perspective_view(drawing.bounds))));
}

TEST(DrawSvg, HugeCloudsAreSampled) {
  Drawing drawing;
  drawing.points.push_back({std::vector<Eigen::Vector3d>(50000, Eigen::Vector3d(0, 0, 1)),
                            std::vector<Color>(50000, Color{9, 9, 9}), 2, 0});
  drawing.bounds = bounds_of(drawing);
  const VectorPicture picture = draw_outlines(drawing, samples::from_above(), {}, 1000);
  EXPECT_LT(picture.items.size(), 1100u);
  EXPECT_GT(picture.items.size(), 900u);
}

TEST(DrawSvg, WhatIsBehindTheEyeIsLeftOut) {
  Drawing drawing;
  DrawnLines lines;
  lines.ends = {{0, 0, 0}, {0, -50, 0}};
  lines.color = {1, 2, 3};
  drawing.lines.push_back(lines);
  drawing.bounds = {Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(1, 1, 1)};
  const VectorPicture picture = draw_outlines(drawing, perspective_view(drawing.bounds, -90, 10));
  for (const auto& item : picture.items) {
    if (const auto* shape = std::get_if<VectorShape>(&item)) {
      EXPECT_FALSE(shape->stroke == (Color{1, 2, 3}));
    }
  }
}

}  // namespace
}  // namespace scanchor
