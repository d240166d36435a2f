// The whole way from a seed to names: rooms that no number of this project was chosen on (the background rates were counted on
// seeds below 1000).

#include <gtest/gtest.h>

#include <map>

#include "reasoning/check_proof.hpp"
#include "reasoning/reason.hpp"
#include "tests/reasoning/support/built.hpp"
#include "tests/reasoning/support/simulated.hpp"

namespace scanchor {
namespace {

TEST(Chain, OfficesAtOneCentimetre) {
  const auto ontology = test::shipped("office");
  std::map<std::string, double> right, said, there;
  std::size_t faults = 0;
  for (std::uint64_t seed = 9001; seed <= 9006; ++seed) {
    const auto room = test::simulated_room("office", seed);
    const auto labelling = reason(room.surfaces, ontology, {});
    for (std::size_t i = 0; i < room.classes.size(); ++i) {
      const auto& label = labelling.entities[labelling.entity_of_surface[i]].label;
      const double points = static_cast<double>(room.points[i]);
      said[label] += points;
      there[room.classes[i]] += points;
      if (label == room.classes[i]) right[label] += points;
    }
    for (const auto& entity : labelling.entities) faults += check_proof(room.surfaces, ontology, labelling, entity.id).size();
  }
  for (const std::string name : {"floor", "wall"}) {
    EXPECT_GT(right[name] / said[name], 0.9) << name << " precision";
    EXPECT_GT(right[name] / there[name], 0.9) << name << " recall";
  }
  EXPECT_GT(right["desk"] / said["desk"], 0.7);
  EXPECT_GT(right["desk"] / there["desk"], 0.5);
  EXPECT_EQ(faults, 0U);
}

}  // namespace
}  // namespace scanchor
