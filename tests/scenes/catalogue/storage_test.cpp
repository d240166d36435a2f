#include <gtest/gtest.h>

#include <cmath>

#include "tests/scenes/support/scene_checks.hpp"

namespace scanchor {
namespace {

using testing::alone;
using testing::find_face;
using testing::find_part;

TEST(Storage, ShelfHasItsBoardsOneAboveTheOther) {
  for (const char* variant : {"open", "with sides", "with back"}) {
    for (int boards = 2; boards <= 8; ++boards) {
      const Scene scene =
          alone({"shelf", variant, 4, {{"boards", 1.0 * boards}, {"spacing", 0.3}}, 0.0});
      double last = -0.1;  // the lowest board lies 7 cm and its thickness above the floor
      for (int i = 1; i <= boards; ++i) {
        const Part* board = find_part(scene.instances[0], "board " + std::to_string(i));
        ASSERT_NE(board, nullptr) << variant << boards;
        const Face* top = find_face(*board, "top");
        EXPECT_GT(top->center.z(), last + 0.1);
        last = top->center.z();
        EXPECT_NEAR(top->center.x(), 0.0, 1e-12);
        EXPECT_EQ(top->size, find_face(*find_part(scene.instances[0], "board 1"), "top")->size);
      }
      EXPECT_EQ(find_part(scene.instances[0], "board " + std::to_string(boards + 1)), nullptr);
    }
  }
}

TEST(Storage, BooksStandBetweenTheBoards) {
  const Scene scene = alone({"bookcase", "books", 8, {{"boards", 5}}, 0.0});
  EXPECT_GT(scene.instances[0].parameters.at("books"), 4);
  const double width = scene.instances[0].parameters.at("width");
  for (const auto& part : scene.instances[0].parts) {
    if (part.name.rfind("books", 0) != 0) continue;
    EXPECT_LT(std::abs(find_face(part, "left")->center.x()), 0.5 * width - 0.02);
    EXPECT_LT(std::abs(find_face(part, "right")->center.x()), 0.5 * width - 0.02);
  }
}

TEST(Storage, CabinetDoorsShareAPlaneWithASeamBetween) {
  const Scene scene = alone({"cabinet", "low", 2, {}, 0.0});
  const Face* left = find_face(*find_part(scene.instances[0], "door 1"), "front");
  const Face* right = find_face(*find_part(scene.instances[0], "door 2"), "front");
  EXPECT_EQ(left->center.y(), right->center.y());
  const double seam = right->center.x() - left->center.x() -
                      0.5 * (find_face(*find_part(scene.instances[0], "door 1"), "top")->size.x() +
                             find_face(*find_part(scene.instances[0], "door 2"), "top")->size.x());
  EXPECT_NEAR(seam, 0.006, 1e-9);
}

}  // namespace
}  // namespace scanchor
