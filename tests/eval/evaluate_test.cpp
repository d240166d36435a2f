#include "eval/evaluate.hpp"

#include <gtest/gtest.h>

namespace scanchor {
namespace {

TEST(Evaluate, WordsOfAnOntologyMeanClasses) {
  const auto is = [](const char* word, const char* name) {
    return class_of_label(word) == find_class(name);
  };
  EXPECT_TRUE(is("desk", "desk"));
  EXPECT_TRUE(is("screen", "monitor"));
  EXPECT_TRUE(is("standing desk", "desk"));
  EXPECT_TRUE(is("coffee table", "coffee table"));
  EXPECT_TRUE(is("small oak table", "table"));
  EXPECT_TRUE(is("fridge", "refrigerator"));
}

TEST(Evaluate, PartsAndAbstentionsMeanNone) {
  for (const char* word :
       {"unknown", "ambiguous", "board", "shelf board", "seat", "table top", "unlabelled", ""}) {
    EXPECT_FALSE(class_of_label(word).has_value()) << word;
  }
}

TEST(Evaluate, EverySynonymIsOfAClassAndNoClass) {
  for (const char* word :
       {"screen", "display", "tv", "couch", "cupboard", "carton", "bin", "column", "heater",
        "bookshelf", "rack", "blackboard", "painting", "closet", "cart", "ground"}) {
    EXPECT_TRUE(class_of_label(word).has_value()) << word;
    EXPECT_FALSE(find_class(word).has_value()) << word;
  }
}

TEST(Evaluate, ClassesOfWordsAreSortedAndUnique) {
  EXPECT_EQ(classes_of_labels({"screen", "board", "floor", "monitor"}),
            (std::vector<ClassId>{*find_class("floor"), *find_class("monitor")}));
}

Surfaces three_surfaces() {
  Surfaces surfaces;
  surfaces.plane_of_point = {0, 0, 1, 1, 2, -1};
  surfaces.surfaces.resize(3);
  for (std::int32_t s = 0; s < 3; ++s) surfaces.surfaces[static_cast<std::size_t>(s)].id = s;
  surfaces.surfaces[0].inliers = {0, 1};
  surfaces.surfaces[1].inliers = {2, 3};
  surfaces.surfaces[2].inliers = {4};
  return surfaces;
}

Labelling group_of_two() {
  Labelling labelling;
  for (const char* label : {"board", "board", "unknown", "shelf"}) {
    Entity entity;
    entity.id = static_cast<std::int32_t>(labelling.entities.size());
    entity.label = label;
    entity.probability = 0.8;
    labelling.entities.push_back(entity);
  }
  labelling.entity_of_surface = {3, 3, 2};
  return labelling;
}

TEST(Evaluate, AGroupOwnsThePointsOfItsMembers) {
  const PointPrediction p = predict_points(three_surfaces(), group_of_two());
  const auto shelf = *find_class("shelf");
  EXPECT_EQ(p.class_id,
            (std::vector<std::int32_t>{shelf, shelf, shelf, shelf, unlabelled, unlabelled}));
  EXPECT_EQ(p.instance, (std::vector<std::int32_t>{3, 3, 3, 3, -1, -1}));
  EXPECT_EQ(p.plane, (std::vector<std::int32_t>{0, 0, 1, 1, 2, -1}));
  EXPECT_FLOAT_EQ(p.confidence[0], 0.8F);
}

TEST(Evaluate, InliersServeWherePlaneOfPointIsMissing) {
  Surfaces surfaces = three_surfaces();
  surfaces.plane_of_point.clear();
  const PointPrediction p = predict_points(surfaces, group_of_two());
  ASSERT_EQ(p.plane.size(), 5U);
  EXPECT_EQ(p.plane[4], 2);
}

TEST(Evaluate, NoSurfacesNoWords) {
  Surfaces surfaces;
  surfaces.plane_of_point = {-1, -1};
  const PointPrediction p = predict_points(surfaces, Labelling{});
  EXPECT_EQ(p.class_id, (std::vector<std::int32_t>{0, 0}));
}

}  // namespace
}  // namespace scanchor
