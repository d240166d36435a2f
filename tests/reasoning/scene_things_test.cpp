#include "reasoning/scene_things.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "tests/reasoning/support/labelled.hpp"

namespace scanchor {
namespace {

using test::Named;

std::vector<int> of(const std::string& name) { return {test::office().find(name)}; }

TEST(SceneThings, PartsAreNoWholesAndMembersAreOfTheirKind) {
  auto scene =
      test::labelled({{test::desk_plate(), "desk", 0.8},
                      {test::shelf_boards(2)[0], "unknown", 1.0},
                      {test::shelf_boards(2)[1], "unknown", 1.0},
                      {{{1, 1.1, 0.4}, {0, 1, 0}, {1, 0, 0}, 1.4, 0.6}, "desk side", 0.7}});
  // A side counts as its desk in a labelling, and is none.
  scene.labelling.entities[3].classes.insert(scene.labelling.entities[3].classes.begin(),
                                             {"desk", 0.75});
  test::add_group(scene, {1, 2}, "shelf", 0.85);
  const SceneThings things(scene.surfaces, test::office(), scene.labelling);
  EXPECT_NEAR(things.probability(0, of("desk")), 0.8, 1e-12);
  EXPECT_NEAR(things.probability(3, of("desk")), 0.05, 1e-12);
  EXPECT_NEAR(things.probability(3, of("desk side")), 0.7, 1e-12);
  EXPECT_NEAR(things.probability(1, of("shelf board")), 0.85, 1e-12);
  EXPECT_EQ(things.probability(1, of("shelf")), 0.0);
  EXPECT_NEAR(things.probability(4, of("shelf")), 0.85, 1e-12);
  EXPECT_EQ(things.probability(1, {}), 0.0) << "a board is no thing of its own";
  EXPECT_EQ(things.probability(3, {}), 1.0);
  EXPECT_TRUE(things.belongs(1, 4));
  EXPECT_FALSE(things.belongs(0, 4));
  EXPECT_EQ(things.relate({Relation::near, {}}, 1, 4).likelihood, 0.0) << "no relation to its own";
}

TEST(SceneThings, AStandThatWasNotSeenHoldsAScreenUpButNoPicture) {
  const auto on = [](double bottom, double wall_y) {
    std::vector<Named> named = {
        {test::desk_plate(), "desk"},
        {{{1, 1.6, 0.74 + bottom + 0.21}, {0, -1, 0}, {1, 0, 0}, 0.57, 0.42}, "monitor"},
        {{{0, wall_y, 1.35}, {0, -1, 0}, {1, 0, 0}, 6.0, 2.7}, "wall"}};
    const auto scene = test::labelled(named);
    return SceneThings(scene.surfaces, test::office(), scene.labelling)
        .relate({Relation::on, {}}, 1, 0)
        .likelihood;
  };
  EXPECT_GT(on(0.05, 2.5), 0.95);
  EXPECT_GT(on(0.30, 2.5), 0.95) << "on a stand";
  EXPECT_LT(on(0.60, 2.5), 0.1) << "nothing holds it up";
  EXPECT_LT(on(0.30, 1.65), 0.2) << "it hangs on the wall behind it";
}

TEST(SceneThings, PicturesAreOnTheirWall) {
  const auto on_wall = [](double before, double x) {
    const auto scene =
        test::labelled({{{{0, 2.5, 1.35}, {0, -1, 0}, {1, 0, 0}, 6.0, 2.7}, "wall"},
                        {{{x, 2.5 - before, 1.5}, {0, -1, 0}, {1, 0, 0}, 1.0, 0.7}, "picture"}});
    return SceneThings(scene.surfaces, test::office(), scene.labelling)
        .relate({Relation::on, {}}, 1, 0);
  };
  EXPECT_GT(on_wall(0.03, 0.0).likelihood, 0.95);
  EXPECT_NEAR(on_wall(0.03, 0.0).measured, 0.03, 1e-6);
  EXPECT_LT(on_wall(0.5, 0.0).likelihood, 0.05) << "it stands before the wall";
  EXPECT_LT(on_wall(0.03, 3.6).likelihood, 0.05) << "it lies in the wall's plane, beside it";
}

TEST(SceneThings, Between) {
  const auto between = [](double x, double y) {
    const auto scene = test::labelled({{{{0, 0, 0.7}, {0, 0, 1}, {1, 0, 0}, 1.0, 0.6}, "desk"},
                                       {{{4, 0, 1}, {-1, 0, 0}, {0, 1, 0}, 6.0, 2.0}, "wall"},
                                       {{{x, y, 0.45}, {0, 0, 1}, {1, 0, 0}, 0.4, 0.4}, "chair"}});
    return SceneThings(scene.surfaces, test::office(), scene.labelling).between(2, 0, 1).likelihood;
  };
  EXPECT_GT(between(2, 0), 0.99);
  EXPECT_GT(between(1.5, 0.3), 0.95);
  EXPECT_LT(between(-2, 0), 0.01) << "beyond the desk";
  EXPECT_LT(between(0, 3), 0.1) << "to the side of it";
  EXPECT_LT(between(0, 0), 0.01) << "under it";
}

TEST(SceneThings, RefusesALabellingOfOtherSurfaces) {
  const auto scene = test::labelled({{test::desk_plate(), "desk"}});
  EXPECT_THROW(SceneThings(test::make_surfaces({}), test::office(), scene.labelling), Error);
}

TEST(SceneThings, RefusesGroupsOfNothingOrOfThemselves) {
  for (const auto& members : {std::vector<std::int32_t>{}, std::vector<std::int32_t>{0, 2}}) {
    auto scene = test::labelled({{test::desk_plate(), "desk"}, {test::screen_plate(), "monitor"}});
    test::add_group(scene, {0, 1}, "shelf");
    scene.labelling.entities.back().members = members;
    EXPECT_THROW(SceneThings(scene.surfaces, test::office(), scene.labelling), Error);
  }
}

}  // namespace
}  // namespace scanchor
