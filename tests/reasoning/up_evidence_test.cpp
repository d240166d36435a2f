#include "reasoning/up_evidence.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "tests/reasoning/support/built.hpp"

namespace scanchor {
namespace {

/// A galley between two walls: everything is square to the walls, cabinets stand along one of them,
/// and the room is as wide as it is high. By area alone a wall is as good a floor.
std::vector<test::Plate> galley() {
  std::vector<test::Plate> plates = {{{2, 0, 0}, {0, 0, 1}, {1, 0, 0}, 4, 2.5},
                                     {{2, 0, 2.5}, {0, 0, -1}, {1, 0, 0}, 4, 2.5},
                                     {{2, 1.25, 1.25}, {0, -1, 0}, {1, 0, 0}, 4, 2.5},
                                     {{2, -1.25, 1.25}, {0, 1, 0}, {1, 0, 0}, 4, 2.5}};
  for (int i = 0; i < 5; ++i)
    plates.push_back({{0.5 + 0.6 * i, 0.65, 0.45}, {0, -1, 0}, {0, 0, 1}, 0.8, 0.58});
  plates.push_back({{1.8, 0.95, 0.9}, {0, 0, 1}, {1, 0, 0}, 3.0, 0.6});
  return plates;
}

TEST(UpEvidence, CountsWhatStandsHangsAndLies) {
  auto plates = galley();
  plates.push_back({{2.0, 1.0, 2.1}, {0, -1, 0}, {1, 0, 0}, 0.8, 0.7});  // a wall cabinet
  auto room = test::make_surfaces(plates);
  room.sensor_positions = {Eigen::Vector3d(2, -0.5, 1.2)};
  const auto up = up_evidence(room, Eigen::Vector3d::UnitZ());
  const auto down = up_evidence(room, -Eigen::Vector3d::UnitZ());
  EXPECT_NEAR(up.aligned, 11.0, 1e-6);
  EXPECT_NEAR(up.standing, 5.0, 1e-6);
  EXPECT_NEAR(up.hanging, 1.0, 1e-6);
  EXPECT_NEAR(up.tops, 1.0, 1e-6) << "a top has one square metre at most";
  EXPECT_NEAR(up.undersides, 0.0, 1e-6);
  EXPECT_TRUE(up.height_of_room);
  EXPECT_TRUE(up.sensor_height);
  EXPECT_EQ(down.standing, up.hanging);
  EXPECT_EQ(down.hanging, up.standing);
  EXPECT_EQ(down.undersides, up.tops);
  EXPECT_GT(up.score(), down.score() + 5.0);
}

TEST(UpEvidence, WhatIsTurnedIsStillUpright) {
  auto plates = galley();
  const double before = up_evidence(test::make_surfaces(plates), Eigen::Vector3d::UnitZ()).score() -
                        up_evidence(test::make_surfaces(plates), Eigen::Vector3d::UnitY()).score();
  plates.push_back({{2, -0.4, 0.45}, Eigen::Vector3d(1, 1, 0).normalized(), {0, 0, 1}, 0.5, 0.45});
  const double after = up_evidence(test::make_surfaces(plates), Eigen::Vector3d::UnitZ()).score() -
                       up_evidence(test::make_surfaces(plates), Eigen::Vector3d::UnitY()).score();
  EXPECT_GT(after, before + 0.9);
}

TEST(UpEvidence, CandidatesAreRankedInAnyPoseAndAddUp) {
  SequentialRandom random(4);
  auto plates = galley();
  plates.push_back({{2, -0.4, 0.45}, Eigen::Vector3d(1, 1, 0).normalized(), {0, 0, 1}, 0.5, 0.45});
  auto room = test::make_surfaces(plates);
  room.sensor_positions = {Eigen::Vector3d(2, -0.5, 1.2)};
  for (int i = 0; i < 30; ++i) {
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    T.linear() =
        Eigen::Quaterniond(random.normal(), random.normal(), random.normal(), random.normal())
            .normalized()
            .toRotationMatrix();
    const auto candidates = up_candidates(test::moved(room, T));
    EXPECT_GT(candidates.front().up.dot(T.linear().col(2)), 0.999);
    EXPECT_GT(candidates.front().probability, 0.7);
    double sum = 0.0;
    for (std::size_t k = 0; k < candidates.size(); ++k) {
      sum += candidates[k].probability;
      if (k > 0) {
        EXPECT_GE(candidates[k - 1].probability, candidates[k].probability);
      }
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
  }
}

TEST(UpEvidence, NothingIsLittleAndNotSure) {
  const auto candidates = up_candidates(Surfaces{});
  ASSERT_EQ(candidates.size(), 2U);
  EXPECT_GT(candidates.front().probability, 0.9) << "frames have z up as a rule";
  // One wall in a turned frame: its normal is no better than the opposite.
  auto wall = test::make_surfaces({{{2, 2, 2},
                                    Eigen::Vector3d(1, 2, 3).normalized(),
                                    Eigen::Vector3d(2, -1, 0).normalized(),
                                    3,
                                    2}});
  for (const auto& candidate : up_candidates(wall)) EXPECT_LT(candidate.probability, 0.9);
}

}  // namespace
}  // namespace scanchor
