#include "reasoning/proof.hpp"

#include <gtest/gtest.h>

#include "reasoning/reason.hpp"
#include "tests/reasoning/support/built.hpp"

namespace scanchor {
namespace {

TEST(Proof, ScreenLeadsToDeskToFloor) {
  const auto labelling =
      reason(test::make_surfaces(test::paper_room()), test::shipped("paper"), {});
  const auto& screen = labelling.entities[7];
  ASSERT_EQ(screen.proof.size(), 4U);
  EXPECT_EQ(screen.proof[0].text, "area 0.1..0.35 m2");
  EXPECT_NEAR(screen.proof[0].measured, 0.57 * 0.42, 1e-9);
  EXPECT_EQ(screen.proof[0].unit, "m2");
  EXPECT_EQ(screen.proof[3].text, "orthogonal to and above a desk");
  EXPECT_EQ(screen.proof[3].targets, std::vector<std::int32_t>{6});
  EXPECT_EQ(screen.proof[3].target_class, "desk");
  EXPECT_GT(screen.proof[3].likelihood, 0.5);
  const auto& desk = labelling.entities[6];
  EXPECT_EQ(desk.proof[3].targets, std::vector<std::int32_t>{0});
  EXPECT_NEAR(desk.proof[4].measured, 0.74, 1e-6);
}

}  // namespace
}  // namespace scanchor
