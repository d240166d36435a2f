#include "reasoning/unary_index.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/random.hpp"
#include "reasoning/matcher.hpp"
#include "tests/reasoning/support/built.hpp"

namespace scanchor {
namespace {

TEST(UnaryIndex, LosesNothingAndLeavesOutMost) {
  SequentialRandom random(6);
  std::vector<test::Plate> plates;
  for (int i = 0; i < 600; ++i) {
    test::Plate plate;
    plate.normal = random.chance(0.5) ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitX();
    plate.normal += 0.05 * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
    plate.along = {0.1, 1, 0.2};
    plate.length = random.uniform(0.05, 2.5);
    plate.width = plate.length * random.uniform(0.1, 1.0);
    plate.edge_sigma = random.uniform(0.002, 0.05);
    plate.hidden = random.chance(0.3) ? 0.5 : 0.0;
    plates.push_back(plate);
  }
  const auto items = make_items(test::make_surfaces(plates), Eigen::Matrix3d::Identity());
  std::vector<Evidence> level, upright;
  for (const auto& item : items) {
    level.push_back(horizontal(item, {}));
    upright.push_back(vertical(item, {}));
  }
  const UnaryIndex index(items, level, upright);
  std::size_t kept = 0;
  std::size_t needed = 0;
  for (int round = 0; round < 60; ++round) {
    const double low = random.uniform(0.01, 2.0);
    const auto text = "class a:\n    " +
                      std::string(random.chance(0.5) ? "horizontal" : "vertical") + "\n    area " +
                      std::to_string(low) + ".." + std::to_string(low * 1.4) + " m2\n";
    const auto clauses = parse_ontology(text, "x.sdl").classes[0].clauses;
    const auto ids = index.candidates(clauses);
    kept += ids.size();
    for (const auto& item : items) {
      const double first = clauses[0].kind == ClauseKind::horizontal ? level[item.id].likelihood
                                                                     : upright[item.id].likelihood;
      if (first < required_gate ||
          feature(Feature::area, clauses[1].range, item).likelihood < required_gate)
        continue;
      ++needed;
      EXPECT_TRUE(std::binary_search(ids.begin(), ids.end(), item.id));
    }
  }
  EXPECT_GT(needed, 300U);
  EXPECT_LT(kept, 60U * items.size() / 3U);
}

}  // namespace
}  // namespace scanchor
