#include "sensors/dataset_card.hpp"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "core/error.hpp"
#include "core/json.hpp"
#include "tests/sensors/support/temporary_folder.hpp"

namespace scanchor {
namespace {
using testing::TemporaryFolder;

SequenceCard card(const std::string& name, const std::string& split) {
  SequenceCard card;
  card.name = name;
  card.split = split;
  card.family = "office";
  card.seed = 18446744073709551615ULL;
  card.settled = split == "train";
  card.problems = {"a cup still moves"};
  card.scan_seeds = {1, 2};
  card.scan_points = {30, 10};
  card.scan_beams = {100, 100};
  card.classes[0] = {10, 0, 1};
  card.classes[8] = {30, 2, 1};
  card.flagged = {1, 2, 3, 4};
  card.files["sequences/" + name + "/poses.txt"] = {3, "ab"};
  return card;
}

TEST(DatasetCard, SequenceCardsReadBack) {
  const TemporaryFolder folder;
  const SequenceCard a = card("07", "train");
  write_sequence_card(folder / "c.json", a);
  const SequenceCard b = read_sequence_card(folder / "c.json");
  EXPECT_EQ(b.seed, a.seed);
  EXPECT_EQ(b.problems, a.problems);
  EXPECT_EQ(b.scan_points, a.scan_points);
  EXPECT_EQ(b.flagged, a.flagged);
  EXPECT_EQ(b.classes.at(8).instances, 2U);
  EXPECT_EQ(b.files.at("sequences/07/poses.txt").sha256, "ab");
  write_file(folder / "bad.json", "{\"name\": \"07\"}");
  EXPECT_THROW((void)read_sequence_card(folder / "bad.json"), Error);
}

TEST(DatasetCard, LabelMapIsWhatSemanticKittiApiReads) {
  const YAML::Node map = YAML::Load(
      label_map_yaml({card("08", "train"), card("09", "train"), card("100", "test")}, "a \"b\""));
  for (const auto& info : class_list()) {
    EXPECT_EQ(map["labels"][info.id].as<std::string>(), std::string(info.name));
    EXPECT_EQ(map["color_map"][info.id][0].as<int>(), info.color[2]) << "blue first";
    EXPECT_EQ(map["color_map"][info.id][2].as<int>(), info.color[0]);
    // Each original id has a learning id, and the inverse leads back.
    const int learning = map["learning_map"][info.id].as<int>();
    EXPECT_EQ(map["learning_map_inv"][learning].as<int>(), info.id);
    EXPECT_EQ(map["learning_ignore"][learning].as<bool>(), info.id == unlabelled);
  }
  EXPECT_EQ(map["content"][8].as<double>(), 0.75);
  EXPECT_EQ(map["split"]["train"].as<std::vector<int>>(), (std::vector<int>{8, 9}));
  EXPECT_EQ(map["split"]["valid"].size(), 0U);
  EXPECT_EQ(map["split"]["test"].as<std::vector<int>>(), (std::vector<int>{100}));
}

TEST(DatasetCard, TheCardOfTheWholeAddsUp) {
  const TemporaryFolder folder;
  Suite suite;
  suite.seed = 77;
  write_dataset_card(folder / "", suite, {}, {card("00", "train"), card("01", "valid")});
  const Json json = read_json(folder / "dataset.json");
  EXPECT_EQ(json["scenes"], 2);
  EXPECT_EQ(json["scans"], 4);
  EXPECT_EQ(json["points"], 80);
  EXPECT_EQ(json["classes"][1]["points"], 60);
  EXPECT_EQ(json["flagged_points"]["ghost"], 4);
  EXPECT_EQ(json["scenes_not_at_rest"].dump(), R"(["01"])");
  EXPECT_EQ(json["suite"]["seed"], 77);
  EXPECT_EQ(json["files"]["label_map.yaml"]["sha256"],
            sha256(read_file(folder / "label_map.yaml")));
  EXPECT_TRUE(json["suite"]["lidar"].contains("range_sigma"));
}

}  // namespace
}  // namespace scanchor
