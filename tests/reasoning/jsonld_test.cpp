#include "reasoning/jsonld.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "reasoning/reason.hpp"
#include "tests/reasoning/support/built.hpp"

namespace scanchor {
namespace {

TEST(Jsonld, NamesClassesRelationsAndMembers) {
  auto plates = test::paper_room();
  for (const auto& board : test::shelf_boards(3)) plates.push_back(board);
  const auto labelling = reason(test::make_surfaces(plates), test::shipped("paper"), {});
  const auto document = labelling_to_jsonld(labelling, "room 1");
  EXPECT_EQ(document["@context"]["class"], "https://scanchor.example/ontology/paper#");
  const auto find = [&](const std::string& id) {
    for (const auto& node : document["@graph"]) {
      if (node["@id"] == id) return node;
    }
    return nlohmann::ordered_json();
  };
  const auto screen = find("urn:scanchor:room_1:7");
  EXPECT_EQ(screen["@type"], "class:screen");
  EXPECT_EQ(screen["above"], nlohmann::ordered_json::array({"urn:scanchor:room_1:6"}));
  EXPECT_EQ(screen["orthogonalTo"], nlohmann::ordered_json::array({"urn:scanchor:room_1:6"}));
  EXPECT_EQ(find("urn:scanchor:room_1:12")["hasMember"].size(), 3U);
  EXPECT_EQ(find("urn:scanchor:room_1:9")["partOf"], "urn:scanchor:room_1:12");
  EXPECT_TRUE(find("urn:scanchor:room_1:1").is_null())
      << "a wall is unknown to the paper's classes";
}

}  // namespace
}  // namespace scanchor
