#include "results/gl_draw.hpp"

#include <gtest/gtest.h>

#include <thread>

#include "results/gl_context.hpp"
#include "tests/results/samples.hpp"

namespace scanchor {
namespace {

using samples::count;
using samples::pixel;

class GlDraw : public ::testing::Test {
 protected:
  void SetUp() override {
    if (gl_context_name() == "none") GTEST_SKIP() << "a build without OpenGL";
  }
  static Frame shoot(const Drawing& drawing, int samples = 4) {
    Eigen::AlignedBox3d box(Eigen::Vector3d(-4, -4, -1), Eigen::Vector3d(4, 4, 5));
    const Projection projection(samples::from_above(), 400, 400, box);
    return draw_with_gl(drawing, projection, 400, 400, samples, paper_white);
  }
};

constexpr Color red{255, 0, 0};
constexpr Color blue{0, 0, 255};

// 50 pixels a metre: a square of 2 m around (1, 0) covers columns 200..299 and rows 150..249,
// exactly.
TEST_F(GlDraw, ASquareCoversItsPixels) {
  Drawing drawing;
  drawing.meshes.push_back(samples::square(1, 0, 0, red));
  const Image image = shoot(drawing).image;
  EXPECT_EQ(count(image, red), 10000u);
  EXPECT_EQ(pixel(image, 200, 150), red);
  EXPECT_EQ(pixel(image, 299, 249), red);
  EXPECT_EQ(pixel(image, 199, 200), paper_white);
  EXPECT_EQ(pixel(image, 300, 200), paper_white);
}

TEST_F(GlDraw, NearHidesFarInAnyOrder) {
  for (const bool swap : {false, true}) {
    Drawing drawing;
    drawing.meshes.push_back(samples::square(0, 0, swap ? 2 : 0, red));
    drawing.meshes.push_back(samples::square(0, 0, swap ? 0 : 2, blue));
    const Image image = shoot(drawing).image;
    EXPECT_EQ(count(image, swap ? red : blue), 10000u);
    EXPECT_EQ(count(image, swap ? blue : red), 0u);
  }
}

TEST_F(GlDraw, DistanceIsThatOfTheSurface) {
  Drawing drawing;
  drawing.meshes.push_back(samples::square(0, 0, 2, red));
  const Frame frame = shoot(drawing);
  EXPECT_NEAR(frame.distance[200 * 400 + 200], 8.0, 1e-3);
  EXPECT_EQ(frame.distance[5 * 400 + 5], 0.0F);
}

TEST_F(GlDraw, APointIsADiscOfItsDiameter) {
  Drawing drawing;
  drawing.points.push_back({{{0, 0, 0}}, {red}, 41.0, 0.0});
  const Image image = shoot(drawing).image;
  int across = 0;
  int down = 0;
  for (int i = 0; i < 400; ++i) {
    across += pixel(image, i, 200).g < 128 ? 1 : 0;
    down += pixel(image, 200, i).g < 128 ? 1 : 0;
  }
  EXPECT_NEAR(across, 41, 1);
  EXPECT_NEAR(down, 41, 1);
  double covered = 0;
  for (int y = 0; y < 400; ++y) {
    for (int x = 0; x < 400; ++x) covered += (255 - pixel(image, x, y).g) / 255.0;
  }
  EXPECT_NEAR(covered, 3.14159 / 4 * 41 * 41, 40.0);
}

TEST_F(GlDraw, APointInMetresGrowsWithTheScale) {
  Drawing drawing;
  drawing.points.push_back(
      {{{0, 0, 0}}, {red}, 1.0, 0.3});  // 15 pixels; at most a twentieth of the height
  const Image image = shoot(drawing).image;
  int across = 0;
  for (int i = 0; i < 400; ++i) across += pixel(image, i, 200).g < 128 ? 1 : 0;
  EXPECT_NEAR(across, 15, 1);
}

TEST_F(GlDraw, ALineHasItsWidthAndLiesOverItsFace) {
  Drawing drawing;
  drawing.meshes.push_back(samples::square(0, 0, 0, red, 6.0));
  DrawnLines lines;
  lines.ends = {{-2, 0, 0}, {2, 0, 0}};
  lines.color = blue;
  lines.width_px = 6.0;
  drawing.lines.push_back(lines);
  const Image image = shoot(drawing).image;
  int thick = 0;
  for (int y = 0; y < 400; ++y) thick += pixel(image, 200, y) == blue ? 1 : 0;
  EXPECT_EQ(thick, 6);
}

TEST_F(GlDraw, HiddenLinesShowThrough) {
  Drawing drawing;
  drawing.meshes.push_back(samples::square(0, 0, 2, red, 6.0));
  DrawnLines lines;
  lines.ends = {{-2, 0, 0}, {2, 0, 0}};
  lines.color = blue;
  lines.width_px = 4.0;
  drawing.lines.push_back(lines);
  EXPECT_EQ(count(shoot(drawing).image, blue), 0u);
  drawing.lines[0].hidden = true;
  EXPECT_GT(count(shoot(drawing).image, blue), 700u);
}

// Points are drawn last unless something translucent is there: what is nearer wins on both ways.
TEST_F(GlDraw, PointsAndLinesHideEachOtherByDepthOnBothWays) {
  for (const bool translucent : {false, true}) {
    for (const bool point_above : {false, true}) {
      Drawing drawing;
      DrawnLines lines;
      lines.ends = {{-2, 0, 1}, {2, 0, 1}};
      lines.color = blue;
      lines.width_px = 6.0;
      drawing.lines.push_back(lines);
      DrawnPoints points;
      points.positions = {{0, 0, point_above ? 2.0 : 0.0}};
      points.colors = {red};
      points.size_px = 20.0;
      drawing.points.push_back(points);
      if (translucent) drawing.meshes.push_back(samples::square(3, 3, 0, {0, 255, 0, 100}, 0.5));
      const Image image = shoot(drawing).image;
      EXPECT_EQ(pixel(image, 200, 200), point_above ? red : blue) << translucent;
      EXPECT_EQ(pixel(image, 200, 193), red) << translucent;  // beside the line, on the disc
      EXPECT_EQ(pixel(image, 150, 200), blue) << translucent;
    }
  }
}

TEST_F(GlDraw, PolygonsHaveTheirHolesAndAreBlended) {
  Drawing drawing;
  DrawnPolygon polygon;
  polygon.outer = {{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}};
  polygon.holes = {{{-1, -1, 0}, {-1, 1, 0}, {1, 1, 0}, {1, -1, 0}}};
  polygon.fill = {255, 0, 0, 128};
  polygon.outline = {0, 0, 0, 0};
  drawing.polygons.push_back(polygon);
  const Image image = shoot(drawing).image;
  EXPECT_EQ(pixel(image, 200, 200), paper_white);
  EXPECT_NEAR(pixel(image, 125, 200).g, 127, 2);
  EXPECT_EQ(count(image, pixel(image, 125, 200)), 200u * 200u - 100u * 100u);
}

TEST_F(GlDraw, EdgesAreSmoothedByFourSamples) {
  Drawing drawing;
  drawing.meshes.push_back(samples::square(0.01, 0, 0, red));  // half a pixel to the right
  const Color edge = pixel(shoot(drawing, 4).image, 250, 200);
  EXPECT_EQ(edge.r, 255);
  EXPECT_NEAR(edge.g, 128, 1);
}

TEST_F(GlDraw, SameBytesTwiceAndFromAnotherThread) {
  Drawing drawing;
  drawing.meshes.push_back(samples::square(0.3, 0.2, 0.5, red));
  drawing.points.push_back({{{0, 0, 1}, {1, 1, 1}}, {blue, blue}, 7.0, 0.0});
  const Frame first = shoot(drawing);
  Frame other;
  std::thread([&] { other = shoot(drawing); }).join();
  EXPECT_EQ(first.image.rgb, other.image.rgb);
  EXPECT_EQ(first.image.rgb, shoot(drawing).image.rgb);
}

TEST_F(GlDraw, NamesItsDriver) { EXPECT_GT(gl_driver().size(), 10u); }

}  // namespace
}  // namespace scanchor
