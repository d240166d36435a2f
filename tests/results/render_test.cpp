#include "results/render.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "results/draw_scene.hpp"
#include "results/gl_context.hpp"
#include "results/paint.hpp"
#include "tests/results/samples.hpp"

namespace scanchor {
namespace {

class Render : public ::testing::Test {
 protected:
  void SetUp() override {
    if (gl_context_name() == "none") GTEST_SKIP() << "a build without OpenGL";
    small.width = 320;
    small.height = 200;
  }
  RenderOptions small;
};

TEST_F(Render, ARoomFillsThePicture) {
  DrawSceneOptions options;
  options.names = true;
  const Drawing drawing = draw_scene(samples::room(), options);
  RenderOptions big;
  const Rendered result = render_with_details(drawing, framed_view(drawing, big), big);
  EXPECT_EQ(result.image.width, 1280);
  EXPECT_EQ(result.image.height, 720);
  const std::size_t empty = samples::count(result.image, paper_white);
  EXPECT_LT(empty, 1280u * 720u * 8 / 10);
  EXPECT_EQ(result.labels.size(), 1u);  // the desk; the door hangs in the wall that was taken away
}

TEST_F(Render, SameBytesForOneAndTwoThreads) {
  const Drawing drawing = draw_scene(samples::room());
  const View view = framed_view(drawing, small);
  Image one;
  {
    const ThreadLimit limit(1);
    one = render(drawing, view, small);
  }
  EXPECT_EQ(one.rgb, render(drawing, view, small).rgb);
}

TEST_F(Render, NothingAndOnePointGiveAPicture) {
  const Drawing nothing;
  const Image empty = render(nothing, framed_view(nothing, small), small);
  EXPECT_GT(samples::count(empty, paper_white), 320u * 200u * 8 / 10);
  Drawing one;
  one.points.push_back({{{3, 4, 5}}, {Color{200, 0, 0}}, 5.0, 0.0});
  const Image point = render(one, framed_view(one, small), small);
  EXPECT_GE(samples::count(point, {200, 0, 0}), 9u);
}

TEST_F(Render, NotANumberIsOneClearLine) {
  Drawing drawing;
  drawing.points.push_back({{{0, 0, std::numeric_limits<double>::infinity()}}, {ink}, 5.0, 0.0});
  EXPECT_THROW(render(drawing, View{}, small), Error);
  EXPECT_THROW(render(Drawing{}, View{},
                      [] {
                        RenderOptions none;
                        none.width = 0;
                        return none;
                      }()),
               Error);
}

TEST_F(Render, LegendTakesNothingAway) {
  Drawing drawing = draw_scene(samples::room());
  const View with = framed_view(drawing, small);
  const Projection projection = projection_for(drawing, with, small);
  for (const Eigen::Vector3d& p : places_to_frame(drawing)) {
    EXPECT_TRUE(free_area(drawing, small).contains(projection.pixel(p).head<2>()));
  }
}

TEST(RenderOptions, AreDescribed) {
  RenderOptions options;
  OptionList list;
  list.add_group("render", options);
  list.set("render.width", "640");
  EXPECT_EQ(options.width, 640);
  EXPECT_THROW(list.set("render.width", "0"), Error);
}

TEST(SideBySide, KeepsTheSizesAndTheOrder) {
  const Image image = side_by_side(
      {blank_image(50, 40, {255, 0, 0}), blank_image(30, 60, {0, 0, 255})}, {"a", "b"});
  EXPECT_GE(image.width, 80);
  EXPECT_GE(image.height, 60);
  EXPECT_EQ(samples::count(image, {255, 0, 0}), 50u * 40u);
  EXPECT_EQ(samples::count(image, {0, 0, 255}), 30u * 60u);
  EXPECT_EQ(samples::pixel(image, 10, image.height - 61 + 5 + 30), (Color{255, 0, 0}));
  EXPECT_THROW(side_by_side({}, {}), Error);
}

}  // namespace
}  // namespace scanchor
