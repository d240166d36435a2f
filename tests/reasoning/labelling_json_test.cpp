#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "reasoning/reason.hpp"
#include "tests/reasoning/support/built.hpp"

namespace scanchor {
namespace {

TEST(LabellingJson, RoundTripKeepsEverything) {
  auto plates = test::paper_room();
  for (const auto& board : test::shelf_boards(3)) plates.push_back(board);
  const auto labelling = reason(test::make_surfaces(plates), test::shipped("office"), {});
  const std::vector<std::size_t> points(plates.size(), 100);
  const auto json = labelling_to_json(labelling, points);
  const auto again = labelling_from_json(json, "labels.json");
  EXPECT_EQ(labelling_to_json(again, points).dump(), json.dump());
  EXPECT_EQ(json["objects"][0]["class"], "floor");
  EXPECT_EQ(json["objects"][0]["points"], 100);
  EXPECT_EQ(json["objects"].back()["points"], 300);
}

TEST(LabellingJson, RefusesWhatIsBroken) {
  const auto labelling =
      reason(test::make_surfaces(test::paper_room()), test::shipped("paper"), {});
  const auto json = labelling_to_json(labelling, {});
  for (const auto& [pointer, value] :
       std::vector<std::pair<std::string, nlohmann::ordered_json>>{{"/format", "scanchor labels 9"},
                                                                   {"/objects/1/id", 7},
                                                                   {"/objects/0/probability", 1.5},
                                                                   {"/entity_of_surface/0", 99},
                                                                   {"/objects/0/surfaces/0", 99},
                                                                   {"/objects/0/surfaces/0", -1},
                                                                   {"/objects/0/part_of", 99},
                                                                   {"/objects/0/part_of", -1},
                                                                   {"/up", "z"}}) {
    auto broken = json;
    broken[nlohmann::ordered_json::json_pointer(pointer)] = value;
    EXPECT_THROW(labelling_from_json(broken, "labels.json"), Error) << pointer;
  }
}

}  // namespace
}  // namespace scanchor
