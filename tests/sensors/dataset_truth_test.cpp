#include "sensors/dataset_truth.hpp"

#include <gtest/gtest.h>

#include "core/file.hpp"
#include "core/json.hpp"
#include "scenes/generator.hpp"
#include "scenes/relations.hpp"
#include "tests/sensors/support/temporary_folder.hpp"

namespace scanchor {
namespace {
using testing::TemporaryFolder;

TEST(DatasetTruth, RelationsNameInstancesByTheirIds) {
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

TEST(DatasetTruth, FacesCarryTheirTruthAndWhatWasSeen) {
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

// The text is written without a JSON library: it must be JSON all the same, and say what the
// library of relations says, to the bit.
TEST(DatasetTruth, TextReadsBackToTheSameBits) {
  RoomOptions options;
  options.family = "kitchen";
  Scene scene = generate_room(options, 60);
  scene.instances[3].parts[0].name = "a \"quoted\" \\ name\n";
  const Json relations = Json::parse(relations_json(scene))["relations"];
  const auto facts = instance_relations(scene);
  ASSERT_EQ(relations.size(), facts.size());
  for (std::size_t i = 0; i < facts.size(); ++i) {
    EXPECT_EQ(relations[i]["relation"], relation_name(facts[i].relation));
    EXPECT_EQ(relations[i]["margin"].get<double>(), facts[i].value.margin);
    EXPECT_EQ(relations[i]["value"].get<double>(), facts[i].value.value);
  }
  const Json faces = Json::parse(faces_json(scene, {}))["faces"];
  const auto addresses = all_faces(scene);
  ASSERT_EQ(faces.size(), addresses.size());
  bool renamed = false;
  for (std::size_t f = 0; f < addresses.size(); ++f) {
    renamed = renamed || faces[f]["part_name"] == scene.instances[3].parts[0].name;
    if (!faces[f]["planar"].get<bool>()) continue;
    const WorldFace world = world_face(scene, addresses[f]);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(faces[f]["center"][k].get<double>(), world.center[static_cast<int>(k)]);
      EXPECT_EQ(faces[f]["normal"][k].get<double>(), world.normal[static_cast<int>(k)]);
    }
    EXPECT_EQ(faces[f]["size"][1].get<double>(), world.size.y());
  }
  EXPECT_TRUE(renamed);
}

}  // namespace
}  // namespace scanchor
