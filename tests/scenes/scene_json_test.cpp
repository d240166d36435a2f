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

TEST(SceneJson, ReadsBackToTheSameBits) {
  for (const char* family : {"office", "kitchen"}) {
    RoomOptions options;
    options.family = family;
    const Scene scene = generate_room(options, 11);
    const Json json = scene_to_json(scene);
    const Scene again = scene_from_json(json, "room.json");
    EXPECT_EQ(scene_to_json(again).dump(), json.dump());
    ASSERT_EQ(again.instances.size(), scene.instances.size());
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
      const Instance& a = scene.instances[i];
      const Instance& b = again.instances[i];
      EXPECT_TRUE(a.T_world_instance.matrix() == b.T_world_instance.matrix());
      ASSERT_EQ(a.parts.size(), b.parts.size());
      for (std::size_t p = 0; p < a.parts.size(); ++p) {
        EXPECT_EQ(a.parts[p].vertices, b.parts[p].vertices) << a.kind << " " << a.parts[p].name;
        EXPECT_EQ(a.parts[p].triangle_face, b.parts[p].triangle_face);
        for (std::size_t f = 0; f < a.parts[p].faces.size(); ++f) {
          EXPECT_EQ(a.parts[p].faces[f].center, b.parts[p].faces[f].center)
              << a.kind << " " << a.parts[p].name;
          EXPECT_EQ(a.parts[p].faces[f].area, b.parts[p].faces[f].area);
        }
      }
    }
  }
}

TEST(SceneJson, WrittenFilesAreShortAndReadBack) {
  const auto path = std::filesystem::temp_directory_path() / "scanchor_scene_json_test.json";
  const Scene scene = generate_room({}, 3);
  write_scene(path, scene);
  const std::string text = read_file(path);
  EXPECT_EQ(scene_to_json(read_scene(path)).dump(), scene_to_json(scene).dump());
  std::size_t longest = 0;
  std::size_t start = 0;
  for (std::size_t end = text.find('\n'); end != std::string::npos;
       start = end + 1, end = text.find('\n', start))
    longest = std::max(longest, end - start);
  EXPECT_LT(longest, 400U) << "lines that a person can look at";
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace scanchor
