#include "results/draw_labels.hpp"

#include <gtest/gtest.h>

#include "tests/results/surface_samples.hpp"

namespace scanchor {
namespace {

TEST(DrawLabels, NamesTheThings) {
  const Drawing drawing = draw_labels(samples::two_surfaces(), samples::two_labels());
  ASSERT_EQ(drawing.labels.size(), 2u);
  EXPECT_EQ(drawing.labels[0].text, "desk 0.97");
  EXPECT_EQ(drawing.polygons[0].fill.r, color_of_class(*find_class("desk")).r);
  ASSERT_EQ(drawing.legend.size(), 2u);
  EXPECT_EQ(drawing.legend[0].text, "desk (1)");
}

TEST(DrawLabels, WhatIsUnknownIsGreyAndSilent) {
  Labelling labelling = samples::two_labels();
  labelling.entities[0].label = "unknown";
  Drawing drawing = draw_labels(samples::two_surfaces(), labelling);
  EXPECT_EQ(drawing.labels.size(), 1u);
  EXPECT_EQ(drawing.legend.back().text, "unknown (1)");
  DrawLabelsOptions options;
  options.unknown = true;
  EXPECT_EQ(draw_labels(samples::two_surfaces(), labelling, options).labels.size(), 2u);
}

TEST(DrawLabels, RelationsAreArrowsToWhatTheyHoldOn) {
  DrawLabelsOptions options;
  options.relations_of = 1;
  const Drawing drawing = draw_labels(samples::two_surfaces(), samples::two_labels(), options);
  ASSERT_EQ(drawing.arrows.size(), 1u);
  EXPECT_EQ(drawing.arrows[0].text, "above a desk 0.99");
  EXPECT_EQ(drawing.arrows[0].to, Eigen::Vector3d(0, 0, 0.72));
  EXPECT_TRUE(draw_labels(samples::two_surfaces(), samples::two_labels()).arrows.empty());
}

TEST(DrawLabels, GroupsAreBoxes) {
  Labelling labelling = samples::two_labels();
  Entity group;
  group.id = 2;
  group.members = {0, 1};
  group.surfaces = {0, 1};
  group.label = "workplace";
  group.probability = 0.7;
  group.size = {1.6, 0.8, 0.6};
  labelling.entities.push_back(group);
  labelling.entity_of_surface = {2, 2};
  const Drawing drawing = draw_labels(samples::two_surfaces(), labelling);
  ASSERT_EQ(drawing.lines.size(), 1u);
  EXPECT_EQ(drawing.lines[0].ends.size(), 24u);
  ASSERT_EQ(drawing.labels.size(), 1u);  // its members do not own a label any more
  EXPECT_EQ(drawing.labels[0].text, "workplace 0.70");
}

TEST(DrawLabels, SynonymsHaveTheClassesColour) {
  EXPECT_EQ(color_of_label("screen"), color_of_class(*find_class("monitor")));
  EXPECT_EQ(color_of_label("unknown"), color_of_number(-1));
  EXPECT_EQ(color_of_label("zeppelin"), color_of_label("zeppelin"));
}

TEST(DrawLabels, ALabellingWithoutSurfacesIsEmpty) {
  const Drawing drawing = draw_labels(Surfaces{}, Labelling{});
  EXPECT_TRUE(drawing.bounds.isEmpty());
}

}  // namespace
}  // namespace scanchor
