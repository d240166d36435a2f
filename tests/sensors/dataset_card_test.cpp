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

TEST(DatasetCard, RelationsNameInstancesByTheirIds) {
  const TemporaryFolder folder;
  Scene scene;
  scene.materials.resize(1);
  for (int k = 0; k < 2; ++k) {
    Instance instance;
    instance.id = 10 + k;
    instance.class_id = *find_class(k == 0 ? "desk" : "box");
    // A box of 0.4 m stands on a slab whose top is at 0.72 m.
    const double size = k == 0 ? 1.6 : 0.4;
    instance.parts.push_back(box_part("body", 0, Eigen::Vector3d(0, 0, k == 0 ? 0.7 : 0.92),
                                      Eigen::Vector3d(size, size, k == 0 ? 0.04 : 0.4)));
    scene.instances.push_back(instance);
  }
  write_file(folder / "r.json", relations_json(scene));
  bool on = false;
  const Json json = read_json(folder / "r.json");
  for (const auto& fact : json["relations"]) {
    EXPECT_GE(fact["margin"].get<double>(), 0.0);
    on = on || (fact["relation"] == "on" && fact["a"] == 11 && fact["b"] == 10);
  }
  EXPECT_TRUE(on);
}

TEST(DatasetCard, FacesCarryTheirTruthAndWhatWasSeen) {
  const TemporaryFolder folder;
  Scene scene;
  scene.materials.resize(1);
  Instance instance;
  instance.id = 5;
  instance.class_id = *find_class("desk");
  instance.T_world_instance.translation() = Eigen::Vector3d(1, 2, 0);
  instance.parts.push_back(
      box_part("top", 0, Eigen::Vector3d(0, 0, 0.7), Eigen::Vector3d(1.6, 0.8, 0.04)));
  scene.instances.push_back(instance);
  const std::vector<std::vector<FaceVisibility>> seen = {{{0, 40, 0.5}, {3, 7, 0.125}},
                                                         {{3, 9, 1.0}}};
  write_file(folder / "faces.json", faces_json(scene, seen));
  const Json faces = read_json(folder / "faces.json")["faces"];
  ASSERT_EQ(faces.size(), 6U);
  int tops = 0;
  for (const auto& face : faces) {
    EXPECT_EQ(face["instance"], 5);
    EXPECT_EQ(face["class"], "desk");
    if (face["name"] != "top") continue;
    ++tops;
    EXPECT_NEAR(face["center"][2].get<double>(), 0.72, 1e-12);
    EXPECT_NEAR(face["size"][0].get<double>(), 1.6, 1e-12);
    EXPECT_NEAR(face["area"].get<double>(), 1.28, 1e-12);
  }
  EXPECT_EQ(tops, 1);
  const auto first = read_face_visibility(folder / "faces.json", 0);
  ASSERT_EQ(first.size(), 2U);
  EXPECT_EQ(first[1].points, 7);
  EXPECT_EQ(first[1].visible_fraction, 0.125);
  EXPECT_EQ(read_face_visibility(folder / "faces.json", 1).size(), 1U);
  EXPECT_TRUE(read_face_visibility(folder / "faces.json", 2).empty());
}

}  // namespace
}  // namespace scanchor
