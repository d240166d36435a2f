#include <gtest/gtest.h>

#include <cmath>

#include "tests/scenes/support/scene_checks.hpp"

namespace scanchor {
namespace {

using testing::alone;
using testing::find_face;
using testing::find_part;

TEST(Seating, FourLeggedChairHasAFlatSeat) {
  const Scene scene = alone({"chair", "four legs", 1, {{"seat_height", 0.45}}, 0.0});
  const Face* seat = find_face(*find_part(scene.instances[0], "seat"), "top");
  EXPECT_TRUE(seat->planar);
  EXPECT_NEAR(seat->center.z(), 0.45, 1e-12);
}

TEST(Seating, OfficeChairIsRoundWherePeopleSit) {
  const Scene scene = alone({"chair", "office star base", 1, {}, 0.0});
  for (const char* name : {"seat", "backrest"}) {
    for (const auto& face : find_part(scene.instances[0], name)->faces) EXPECT_FALSE(face.planar);
  }
  for (int i = 1; i <= 5; ++i)
    EXPECT_NE(find_part(scene.instances[0], "castor " + std::to_string(i)), nullptr);
}

// The sitter looks to -y: the backrest is behind the seat.
TEST(Seating, BackrestsAreBehind) {
  for (const char* variant : {"office star base", "four legs", "cantilever"}) {
    const Scene scene = alone({"chair", variant, 2, {}, 0.0});
    const Part* back = find_part(scene.instances[0], "backrest");
    EXPECT_GT(back->T_instance_part.translation().y(), 0.1) << variant;
  }
}

TEST(Seating, SofasGrowWithTheirSeats) {
  const auto width = [](double seats) {
    return local_bounds(alone({"sofa", "with arms", 3, {{"seats", seats}}, 0.0}).instances[0])
        .sizes()
        .x();
  };
  const double seat =
      alone({"sofa", "with arms", 3, {}, 0.0}).instances[0].parameters.at("seat_width");
  EXPECT_NEAR(width(3) - width(2), seat, 1e-9);
}

}  // namespace
}  // namespace scanchor
