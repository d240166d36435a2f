#include "reasoning/plan_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/random.hpp"

namespace scanchor {
namespace {

double gap_along(const Eigen::AlignedBox3d& a, const Eigen::AlignedBox3d& b) {
  double gap = 0.0;
  for (int k = 0; k < 2; ++k)
    gap = std::max({gap, a.min()[k] - b.max()[k], b.min()[k] - a.max()[k]});
  return gap;
}

TEST(PlanGrid, LeavesOutNothingThatIsNear) {
  SequentialRandom random(3);
  std::size_t returned = 0, all = 0;
  for (int round = 0; round < 60; ++round) {
    const double side = random.uniform(0.5, 60.0);
    const Eigen::Vector3d far(round % 3 == 0 ? 4.5e5 : 0.0, round % 3 == 0 ? 5.6e6 : 0.0, 0.0);
    std::vector<Eigen::AlignedBox3d> boxes;
    std::vector<std::int32_t> everywhere;
    for (int i = 0; i < 80; ++i) {
      const Eigen::Vector3d at(random.uniform(-side, side), random.uniform(-side, side),
                               random.uniform(0, 3));
      const Eigen::Vector3d size(random.uniform(0, 2), random.uniform(0, i % 20 == 0 ? side : 2),
                                 random.uniform(0, 1));
      boxes.emplace_back(far + at, far + at + size);
      if (i % 17 == 0) everywhere.push_back(i);
    }
    const PlanGrid grid(boxes, everywhere);
    std::vector<std::int32_t> near = {12345};
    for (const auto& box : boxes) {
      const double reach = random.uniform(0, 3);
      grid.near(box, reach, near);
      EXPECT_TRUE(std::is_sorted(near.begin(), near.end()));
      EXPECT_EQ(std::adjacent_find(near.begin(), near.end()), near.end());
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        const bool there =
            std::binary_search(near.begin(), near.end(), static_cast<std::int32_t>(i));
        EXPECT_TRUE(there || (gap_along(box, boxes[i]) > reach && i % 17 != 0)) << i;
      }
      if (side > 20.0) {
        returned += near.size();
        all += boxes.size();
      }
    }
  }
  EXPECT_LT(static_cast<double>(returned), 0.4 * static_cast<double>(all)) << "it has to pay";
}

TEST(PlanGrid, OfNothingReturnsNothing) {
  std::vector<std::int32_t> near = {1};
  PlanGrid().near({Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones()}, 1.0, near);
  EXPECT_TRUE(near.empty());
  PlanGrid({}, {}).near({Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones()}, 1.0, near);
  EXPECT_TRUE(near.empty());
}

}  // namespace
}  // namespace scanchor
