#include "reasoning/reference_rooms.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/error.hpp"
#include "core/file.hpp"
#include "reasoning/matcher.hpp"
#include "tests/reasoning/support/built.hpp"

namespace scanchor {
namespace {

namespace fs = std::filesystem;

TrainingScene paper_scene() {
  TrainingScene scene;
  const auto plates = test::paper_room();
  scene.surfaces = test::make_surfaces(plates);
  scene.surfaces.sensor_positions = {Eigen::Vector3d(0.5, -0.5, 1.4)};
  for (std::size_t i = 0; i < plates.size(); ++i)
    scene.classes.push_back(i % 2 == 0 ? "floor" : "");
  return scene;
}

fs::path folder() {
  const fs::path own = fs::path(testing::TempDir()) / "reference_rooms";
  fs::create_directories(own);
  return own;
}

TEST(ReferenceRooms, AreReadAsTheyWereWritten) {
  const ReferenceRoom made = make_reference_room(paper_scene(), {});
  const fs::path file = folder() / "own.rooms.json";
  write_reference_rooms(file, {made, made}, "two rooms");
  const auto read = read_reference_rooms(file);
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[1].classes, made.classes);
  EXPECT_DOUBLE_EQ(read[1].around.up_sigma, made.around.up_sigma);
  EXPECT_EQ(*read[1].around.viewpoint, *made.around.viewpoint);
  // All that reasoning believes of the room is the same, to what the file rounds.
  Matcher before(test::office(), made.items, made.around);
  Matcher after(test::office(), read[1].items, read[1].around);
  before.run();
  after.run();
  int compared = 0;
  for (std::size_t c = 0; c < test::office().classes.size(); ++c) {
    for (const auto& item : made.items) {
      const double belief = before.belief(static_cast<int>(c), item.id);
      EXPECT_NEAR(after.belief(static_cast<int>(c), item.id), belief, 0.02);
      compared += belief > 0.5 ? 1 : 0;
    }
  }
  EXPECT_GT(compared, 5);
  // What was read is written to the same bytes.
  const std::string text = read_file(file);
  write_reference_rooms(file, read, "two rooms");
  EXPECT_EQ(read_file(file), text);
}

TEST(ReferenceRooms, BrokenFilesAreRefused) {
  const fs::path file = folder() / "broken.rooms.json";
  const auto said = [&](const std::string& text) -> std::string {
    write_file(file, text);
    try {
      read_reference_rooms(file);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(
      said("{\"format\": \"another\", \"classes\": [], \"rooms\": []}").find("scanchor rooms 1"),
      std::string::npos);
  const std::string head =
      "{\"format\": \"scanchor rooms 1\", \"classes\": [\"desk\"], \"rooms\": [";
  EXPECT_NE(said(head + "{\"up_sigma\": 0, \"classes\": [0], \"items\": []}]}").find("as many"),
            std::string::npos);
  EXPECT_NE(
      said(head + "{\"up_sigma\": 0, \"classes\": [0], \"items\": [[1, 2]]}]}").find("as long"),
      std::string::npos);
  EXPECT_NE(
      said(head + "{\"up_sigma\": 0, \"classes\": [7], \"items\": [[1, 2]]}]}").find("classes"),
      std::string::npos);
}

}  // namespace
}  // namespace scanchor
