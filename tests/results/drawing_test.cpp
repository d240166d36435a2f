#include "results/drawing.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "core/error.hpp"
#include "tests/results/samples.hpp"

namespace scanchor {
namespace {

Drawing sample_drawing() {
  Drawing drawing;
  drawing.meshes.push_back(samples::square(0, 0, 0, ink));
  drawing.points.push_back({{{1, 2, 3}}, {ink}, 2, 0});
  drawing.lines.push_back({{{0, 0, 0}, {0, 0, 4}}, ink, 1, false});
  drawing.polygons.push_back({{{5, 0, 0}, {6, 0, 0}, {6, 1, 0}}, {}, ink, ink, 1});
  drawing.labels.push_back({{9, 9, 9}, "x", ink, 0});
  drawing.bounds = bounds_of(drawing);
  return drawing;
}

TEST(Drawing, BoundsHoldEverythingButLabels) {
  const auto box = sample_drawing().bounds;
  EXPECT_EQ(box.min(), Eigen::Vector3d(-1, -1, 0));
  EXPECT_EQ(box.max(), Eigen::Vector3d(6, 2, 4));
  EXPECT_TRUE(bounds_of(Drawing{}).isEmpty());
}

TEST(Drawing, NotANumberIsRefusedWithItsPlace) {
  Drawing drawing = sample_drawing();
  drawing.points[0].positions.emplace_back(0, std::numeric_limits<double>::quiet_NaN(), 0);
  try {
    bounds_of(drawing);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("point 1"), std::string::npos) << error.what();
    EXPECT_EQ(error.code(), ExitCode::bad_data);
  }
}

TEST(Drawing, MovesAsAWhole) {
  Drawing drawing = sample_drawing();
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translate(Eigen::Vector3d(10, 0, 0));
  T.rotate(Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ()));
  drawing.move(T);
  EXPECT_TRUE(drawing.points[0].positions[0].isApprox(Eigen::Vector3d(8, 1, 3)));
  EXPECT_TRUE(drawing.labels[0].anchor.isApprox(Eigen::Vector3d(1, 9, 9)));
  EXPECT_TRUE(drawing.bounds.isApprox(bounds_of(drawing)));
}

TEST(Drawing, AddKeepsTheFirstTitle) {
  Drawing a = sample_drawing();
  a.title = "a";
  Drawing b = sample_drawing();
  b.title = "b";
  b.legend.push_back({"thing", ink});
  a.add(b);
  EXPECT_EQ(a.title, "a");
  EXPECT_EQ(a.meshes.size(), 2u);
  EXPECT_EQ(a.legend.size(), 1u);
}

TEST(Drawing, ABoxHasTwelveEdges) {
  DrawnLines lines;
  add_box_lines(lines, Eigen::Isometry3d::Identity(), {2, 4, 6});
  ASSERT_EQ(lines.ends.size(), 24u);
  double length = 0;
  for (std::size_t i = 0; i < 24; i += 2) length += (lines.ends[i] - lines.ends[i + 1]).norm();
  EXPECT_DOUBLE_EQ(length, 4 * (2 + 4 + 6));
}

TEST(Drawing, FramesASampleOfHugeClouds) {
  Drawing drawing;
  drawing.points.push_back(
      {std::vector<Eigen::Vector3d>(350000, Eigen::Vector3d::Zero()), {}, 1, 0});
  EXPECT_LE(places_to_frame(drawing).size(), 100000u);
  EXPECT_GE(places_to_frame(drawing).size(), 50000u);
}

}  // namespace
}  // namespace scanchor
