#include "reasoning/corner.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "tests/reasoning/support/built.hpp"

namespace scanchor {
namespace {

const Eigen::Vector3d viewer(-3.0, -3.0, 2.0);

std::vector<Item> items(const std::vector<test::Plate>& plates) {
  return make_items(test::make_surfaces(plates), Eigen::Matrix3d::Identity());
}

// Front (towards -y), side (towards -x) and top of a box of 0.6 x 0.4 x 0.8 m at the origin.
const test::Plate front_face{{0.3, 0.0, 0.4}, {0, 1, 0}, {1, 0, 0}, 0.6, 0.8};
const test::Plate side_face{{0.0, 0.2, 0.4}, {1, 0, 0}, {0, 1, 0}, 0.4, 0.8};
const test::Plate top_face{{0.3, 0.2, 0.8}, {0, 0, 1}, {1, 0, 0}, 0.6, 0.4};

TEST(OuterEdge, JoinsTheFacesOfABox) {
  const auto box = items({front_face, side_face, top_face});
  for (const auto& a : box) {
    for (const auto& b : box) {
      if (a.id == b.id) continue;
      EXPECT_GT(outer_edge(a, b, viewer).likelihood, 0.9) << a.id << " " << b.id;
      EXPECT_EQ(outer_edge(a, b, viewer).likelihood, outer_edge(b, a, viewer).likelihood);
    }
  }
}

TEST(OuterEdge, InsideARoomThereIsNone) {
  // The same three planes seen from within the box are the corner of a room.
  const auto room = items({front_face, side_face, top_face});
  for (const auto& a : room) {
    for (const auto& b : room) {
      if (a.id != b.id) {
        EXPECT_LT(outer_edge(a, b, {0.5, 0.3, 0.4}).likelihood, 0.05);
      }
    }
  }
}

TEST(OuterEdge, WhatSticksOutOrStandsApartIsNoBody) {
  // A board in the middle of a panel, a screen on a desk, a front and a side 0.3 m apart.
  const test::Plate board{{-0.3, 0.2, 0.4}, {0, 0, 1}, {1, 0, 0}, 0.6, 0.3};
  const test::Plate screen{{0.3, 0.2, 0.97}, {0, 1, 0}, {1, 0, 0}, 0.5, 0.3};
  const test::Plate apart{{-0.3, 0.2, 0.4}, {1, 0, 0}, {0, 1, 0}, 0.4, 0.8};
  const auto all = items({side_face, board, top_face, screen, front_face, apart});
  EXPECT_LT(outer_edge(all[0], all[1], viewer).likelihood, 0.05);
  EXPECT_LT(outer_edge(all[2], all[3], viewer).likelihood, 0.05);
  EXPECT_LT(outer_edge(all[4], all[5], viewer).likelihood, 0.05);
}

TEST(Cornered, IsTheBestOfAllEdges) {
  const test::Plate floor{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 6.0, 6.0};
  const auto all = items({floor, front_face, side_face, top_face});
  Surrounding around;
  around.viewpoint = viewer;
  for (const auto& item : all) {
    double best = 0.0;
    for (const auto& other : all) {
      if (other.id != item.id) best = std::max(best, outer_edge(item, other, viewer).likelihood);
    }
    EXPECT_EQ(cornered(all, item, around).likelihood, best) << item.id;
  }
  EXPECT_LT(cornered(all, all[0], around).likelihood, 0.05) << "boxes stand on floors";
  EXPECT_GT(cornered(all, all[1], around).likelihood, 0.9);
}

TEST(Cornered, CannotBeToldWithoutAViewpoint) {
  const auto all = items({front_face, side_face});
  EXPECT_EQ(cornered(all, all[0], {}).likelihood, 0.5);
}

TEST(OuterEdge, TurnsAndMovesWithTheBody) {
  SequentialRandom random(11);
  for (int i = 0; i < 50; ++i) {
    const double yaw = random.uniform(-3.1, 3.1);
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    T.linear() = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    T.translation() = Eigen::Vector3d(random.uniform(-5, 5), random.uniform(-5, 5), 0.0);
    auto plates = std::vector<test::Plate>{front_face, side_face};
    for (auto& plate : plates) {
      plate.center = T * plate.center;
      plate.normal = T.linear() * plate.normal * (random.chance(0.5) ? 1.0 : -1.0);
      plate.along = T.linear() * plate.along;
    }
    const auto moved = items(plates);
    EXPECT_NEAR(
        outer_edge(moved[0], moved[1], T * viewer).likelihood,
        outer_edge(items({front_face, side_face})[0], items({front_face, side_face})[1], viewer)
            .likelihood,
        1e-6);
  }
}

}  // namespace
}  // namespace scanchor
