#include "reasoning/reason.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "tests/reasoning/support/built.hpp"

namespace scanchor {
namespace {

using test::labels;
using testing::ElementsAre;

TEST(Reason, NamesThePapersRoom) {
  const auto surfaces = test::make_surfaces(test::paper_room());
  const auto labelling = reason(surfaces, test::shipped("paper"), {});
  EXPECT_THAT(labels(labelling), ElementsAre("floor", "unknown", "unknown", "unknown", "unknown", "unknown", "desk",
                                             "screen", "screen"));
  EXPECT_NEAR(labelling.up.z(), 1.0, 1e-6);
  EXPECT_LT(labelling.up_sigma, 0.02);
}

TEST(Reason, NamesTheOffice) {
  auto plates = test::paper_room();
  for (const auto& board : test::shelf_boards(4)) plates.push_back(board);
  const auto labelling = reason(test::make_surfaces(plates), test::shipped("office"), {});
  EXPECT_THAT(labels(labelling), ElementsAre("floor", "wall", "wall", "wall", "wall", "ceiling", "desk", "monitor",
                                             "monitor", "shelf", "shelf", "shelf", "shelf"));
  EXPECT_EQ(test::count_things(labelling, "shelf"), 1);
}

TEST(Reason, EmptyInputIsAnEmptyAnswer) {
  const auto labelling = reason(Surfaces{}, test::shipped("office"), {});
  EXPECT_TRUE(labelling.entities.empty());
}

TEST(Reason, UnknownModeIsRefused) {
  ReasonOptions options;
  options.mode = "papre";
  EXPECT_THROW(reason(Surfaces{}, test::shipped("paper"), options), Error);
}

}  // namespace
}  // namespace scanchor
