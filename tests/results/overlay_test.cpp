#include "results/overlay.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/random.hpp"
#include "tests/results/samples.hpp"

namespace scanchor {
namespace {

std::vector<std::string> words_of(const VectorPicture& picture) {
  std::vector<std::string> words;
  for (const auto& item : picture.items) {
    if (const auto* text = std::get_if<VectorText>(&item)) words.push_back(text->text);
  }
  return words;
}

bool has(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

Drawing sample_overlay() {
  Drawing drawing;
  drawing.title = "A room";
  drawing.subtitle = "seed 1";
  drawing.bounds = {Eigen::Vector3d(-3, -3, 0), Eigen::Vector3d(3, 3, 2)};
  drawing.legend = {{"desk", palette(1)}, {"chair", palette(2)}};
  return drawing;
}

TEST(Overlay, WritesTitleLegendScaleAndAxes) {
  const Drawing drawing = sample_overlay();
  RenderOptions options;
  const View view = framed_view(drawing, options, ViewKind::top);
  const auto words =
      words_of(make_overlay(drawing, projection_for(drawing, view, options), options, {}).picture);
  for (const char* word : {"A room", "seed 1", "desk", "chair", "1 m", "x", "y"})
    EXPECT_TRUE(has(words, word)) << word;
  options.legend = options.scale_bar = options.axes = false;
  const auto fewer =
      words_of(make_overlay(drawing, projection_for(drawing, view, options), options, {}).picture);
  EXPECT_EQ(fewer.size(), 2u);
}

TEST(Overlay, ScaleBarIsTrue) {
  Drawing drawing = sample_overlay();
  drawing.legend.clear();
  RenderOptions options;
  options.axes = false;
  const Projection projection =
      projection_for(drawing, framed_view(drawing, options, ViewKind::top), options);
  const Overlay overlay = make_overlay(drawing, projection, options, {});
  // The first line is the bar; its text says how long it is.
  for (const auto& item : overlay.picture.items) {
    if (const auto* shape = std::get_if<VectorShape>(&item)) {
      const double px = (shape->paths[0][1] - shape->paths[0][0]).norm();
      EXPECT_NEAR(px / projection.pixels_per_metre(1.0), 1.0, 1e-9);
      break;
    }
  }
  EXPECT_TRUE(has(words_of(overlay.picture), "1 m"));
}

TEST(Overlay, ALongLegendEndsWithWhatIsMissing) {
  Drawing drawing = sample_overlay();
  for (int i = 0; i < 100; ++i) drawing.legend.push_back({"class " + std::to_string(i), ink});
  RenderOptions options;
  const Projection projection = projection_for(drawing, framed_view(drawing, options), options);
  const auto words = words_of(make_overlay(drawing, projection, options, {}).picture);
  EXPECT_TRUE(std::any_of(words.begin(), words.end(),
                          [](const auto& w) { return w.rfind("and ", 0) == 0; }));
}

TEST(Overlay, LabelsDoNotOverlapEachOtherNorTheLegend) {
  Drawing drawing = sample_overlay();
  SequentialRandom random(5);
  for (int i = 0; i < 60; ++i) {
    drawing.labels.push_back({{random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(0, 2)},
                              "thing number " + std::to_string(i),
                              palette(std::size_t(i)),
                              0});
  }
  RenderOptions options;
  const Projection projection = projection_for(drawing, framed_view(drawing, options), options);
  const Overlay overlay = make_overlay(drawing, projection, options, {});
  EXPECT_EQ(overlay.labels.size() + overlay.labels_left_out, 60u);
  // More have no free place near their thing: 35 as measured. What is left out is counted, never
  // laid over another.
  EXPECT_GT(overlay.labels.size(), 30u);
  for (std::size_t i = 0; i < overlay.labels.size(); ++i) {
    EXPECT_LE(overlay.labels[i].box.x + overlay.labels[i].box.w,
              options.width - legend_width(drawing, options));
    EXPECT_GE(overlay.labels[i].box.y, title_height(drawing));
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_FALSE(overlay.labels[i].box.overlaps(overlay.labels[k].box));
  }
}

TEST(Overlay, LeavesOutTheNamesOfWhatIsTooSmallToSee) {
  Drawing drawing = sample_overlay();
  drawing.labels.push_back({{0, 0, 1}, "desk", ink, 0, 1.5});
  drawing.labels.push_back({{1, 0, 1}, "crumb", ink, 0, 0.05});
  drawing.labels.push_back({{-1, 0, 1}, "of unknown size", ink, 0});
  RenderOptions options;
  const Projection projection = projection_for(drawing, framed_view(drawing, options), options);
  const Overlay overlay = make_overlay(drawing, projection, options, {});
  EXPECT_EQ(overlay.labels_left_out, 1u);
  EXPECT_FALSE(has(words_of(overlay.picture), "crumb"));
  EXPECT_TRUE(has(words_of(overlay.picture), "desk"));
}

TEST(Overlay, KnowsWhichAnchorsAreHidden) {
  Drawing drawing = sample_overlay();
  drawing.labels.push_back({{0, 0, 1}, "seen", ink, 0});
  RenderOptions options;
  const Projection projection = projection_for(drawing, framed_view(drawing, options), options);
  const std::vector<float> wall_in_front(std::size_t(options.width * options.height), 0.5F);
  EXPECT_FALSE(make_overlay(drawing, projection, options, wall_in_front).labels.at(0).visible);
  const std::vector<float> nothing(std::size_t(options.width * options.height), 0.0F);
  EXPECT_TRUE(make_overlay(drawing, projection, options, nothing).labels.at(0).visible);
}

TEST(Overlay, SaysWhenThereIsNothing) {
  RenderOptions options;
  const Drawing drawing;
  const Projection projection = projection_for(drawing, framed_view(drawing, options), options);
  EXPECT_TRUE(
      has(words_of(make_overlay(drawing, projection, options, {}).picture), "nothing to show"));
}

TEST(Overlay, ArrowsCarryTheirWords) {
  Drawing drawing = sample_overlay();
  drawing.arrows.push_back({{-2, 0, 1}, {2, 0, 1}, ink, 1.5, "above 0.98"});
  RenderOptions options;
  const Projection projection = projection_for(drawing, framed_view(drawing, options), options);
  EXPECT_TRUE(has(words_of(make_overlay(drawing, projection, options, {}).picture), "above 0.98"));
}

}  // namespace
}  // namespace scanchor
