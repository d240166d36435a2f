#include <gtest/gtest.h>

#include <filesystem>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json.hpp"
#include "scenes/generator.hpp"
#include "scenes/scene.hpp"
#include "tests/scenes/support/scene_checks.hpp"

namespace scanchor {
namespace {

Scene read_text(const std::string& text) { return scene_from_json(Json::parse(text), "room.json"); }

std::string error_of(const std::string& text) {
  try {
    read_text(text);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::bad_data);
    return error.what();
  }
  return "no error";
}

TEST(SceneJsonRead, ShortFormByHand) {
  const Scene scene = read_text(R"({
    "room": {"size": [6, 5, 2.8]},
    "instances": [
      {"class": "desk", "kind": "desk", "variant": "four legs", "parameters": {"width": 1.6, "depth": 0.8, "height": 0.75},
       "pose": {"position": [3, 4.5, 0], "yaw_deg": 0}},
      {"class": "box", "id": 40, "loose": true, "pose": {"position": [3, 4.5, 0.753]},
       "parts": [{"name": "box", "material": "cardboard", "box": {"size": [0.3, 0.2, 0.2]}}]},
      {"class": "pillar", "parts": [{"cylinder": {"from": [1, 1, 0.002], "to": [1, 1, 2.798], "radius": 0.2}, "material": "concrete"}]}
    ],
    "sensor_poses": [{"position": [0.9, 2.3, 1.4], "yaw_deg": 30}]
  })");
  ASSERT_EQ(scene.instances.size(), 9U) << "floor, ceiling, four walls and three things";
  EXPECT_EQ(class_info(scene.instances[0].class_id).name, "floor");
  const Instance& desk = scene.instances[6];
  EXPECT_EQ(desk.parameters.at("width"), 1.6);
  EXPECT_NEAR(testing::find_face(*testing::find_part(desk, "top"), "top")->area, 1.28, 1e-12);
  EXPECT_EQ(scene.instances[7].id, 40);
  EXPECT_TRUE(scene.instances[7].loose);
  EXPECT_NEAR(local_bounds(scene.instances[7]).min().z(), 0.0, 1e-12);
  EXPECT_NEAR(scene.bounds.max().x(), 6.0, 1e-12);
}

TEST(SceneJsonRead, TheReferenceRoomIsSound) {
  const Scene scene = read_scene(std::filesystem::path(SCANCHOR_SOURCE_DIR) /
                                 "scenes/examples/reference_room.json");
  testing::expect_no_close_faces(scene, "reference room");
  for (const auto& line : interpenetrations(scene, 0.0)) ADD_FAILURE() << line;
  int boxes = 0;
  for (const auto& instance : scene.instances) boxes += instance.loose ? 1 : 0;
  EXPECT_EQ(boxes, 17);
  EXPECT_EQ(scene.sensor_poses.size(), 1U);
}

TEST(SceneJsonRead, MeshPartsGetTheirFacesFound) {
  const Scene scene = read_text(R"({"instances": [{"class": "table", "parts": [
    {"vertices": [[0,0,1],[2,0,1],[2,1,1],[0,1,1]], "triangles": [[0,1,2],[0,2,3]]}]}]})");
  const Part& part = scene.instances[0].parts[0];
  ASSERT_EQ(part.faces.size(), 1U);
  EXPECT_NEAR(part.faces[0].area, 2.0, 1e-12);
  EXPECT_NEAR(part.faces[0].size.x(), 2.0, 1e-12);
}

TEST(SceneJsonRead, EachMistakeGivesOneClearLine) {
  const struct {
    const char* text;
    const char* place;
    const char* cause;
  } table[] = {
      {R"({"instances": [{"class": "desl", "parts": [{"box": {"size": [1,1,1]}}]}]})",
       "instances[0].class", "did you mean 'desk'"},
      {R"({"instances": [{"class": "box", "parts": [{"box": {"size": [1,-1,1]}}]}]})",
       "parts[0].box.size", "above 0"},
      {R"({"instances": [{"class": "box", "parts": [{"box": {"size": [1,0,1]}}]}]})",
       "parts[0].box.size", "above 0"},
      {R"({"instances": [{"class": "box", "parts": [{"box": {"size": [1,null,1]}}]}]})", "size[1]",
       "must be a number"},
      {R"({"instances": [{"class": "box", "pose": {"position": [1e9,0,0]}, "parts": [{"box": {"size": [1,1,1]}}]}]})",
       "pose.position", "10 km"},
      {R"({"instances": [{"class": "table", "mesh": "no/such.obj"}]})", "instances[0].mesh",
       "no mesh file"},
      {R"({"instances": [{"id": 3, "class": "box", "parts": [{"box": {"size": [1,1,1]}}]}, {"id": 3, "class": "box", "parts": [{"box": {"size": [1,1,1]}}]}]})",
       "instances[1].id", "used twice"},
      {R"({"instances": [{"id": 0, "class": "box", "parts": [{"box": {"size": [1,1,1]}}]}]})",
       "instances[0].id", "1 .. 65535"},
      {R"({"instances": [{"class": "desk", "kind": "desk", "variant": "four lges"}]})",
       "instances[0]", "did you mean 'four legs'"},
      {R"({"instances": [{"class": "desk", "kind": "desk", "variant": "three legs"}]})",
       "instances[0]", "known are: four legs"},
      {R"({"instances": [{"kind": "desk", "parameters": {"widht": 2}}]})", "instances[0]",
       "did you mean 'width'"},
      {R"({"instances": [{"kind": "dask"}]})", "instances[0]", "did you mean 'desk'"},
      {R"({"instances": [{"class": "box", "parts": [{"material": "cardbord", "box": {"size": [1,1,1]}}]}]})",
       "material", "did you mean 'cardboard'"},
      {R"({"instances": [{"class": "box"}]})", "instances[0]", "has no shape"},
      {R"({"instances": [{"class": "box", "parts": [{"name": "x"}]}]})", "parts[0]",
       "has no shape"},
      {R"({"instances": [{"class": "box", "parts": [{"vertices": [[0,0,0]], "triangles": [[0,0,7]]}]}]})",
       "triangles[0][2]", "no index"},
      {R"({"instances": [{"class": "box", "mas": 3, "parts": [{"box": {"size": [1,1,1]}}]}]})",
       "instances[0]", "did you mean 'mass'"},
      {R"({"instances": [{"class": "box", "mass": 0, "parts": [{"box": {"size": [1,1,1]}}]}]})",
       "mass", "above 0"},
      {R"({"instances": [{"class": "box", "pose": {"rotation": [[1,0,0],[0,1,0],[0,0,2]]}, "parts": [{"box": {"size": [1,1,1]}}]}]})",
       "rotation", "no rotation"},
      {R"({"format": "something else", "instances": []})", "format", "scanchor scene 1"},
      {R"({"materials": [{"name": "x", "reflectance": 2}], "instances": []})", "reflectance",
       "0 .. 1"},
      {R"({})", "room.json", "'instances' is missing"},
      {R"([])", "room.json", "object"},
  };
  for (const auto& row : table) {
    const std::string line = error_of(row.text);
    EXPECT_NE(line.find("room.json"), std::string::npos) << line;
    EXPECT_NE(line.find(row.place), std::string::npos) << line << "\n  for " << row.text;
    EXPECT_NE(line.find(row.cause), std::string::npos) << line << "\n  for " << row.text;
    EXPECT_EQ(line.find('\n'), std::string::npos) << line;
  }
}

TEST(SceneJsonRead, NanInAFileNamesLineAndColumn) {
  const auto path = std::filesystem::temp_directory_path() / "scanchor_scene_nan_test.json";
  write_file(path, std::string("{\"instances\": [\n  {\"class\": \"box\", \"mass\": NaN}\n]}\n"));
  try {
    read_scene(path);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("line 2"), std::string::npos) << error.what();
  }
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace scanchor
