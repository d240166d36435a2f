// Pictures from the command line: every kind of input, every place to stand, and what cannot be
// drawn.

#include <gtest/gtest.h>

#include <filesystem>

#include "core/file.hpp"
#include "core/json.hpp"
#include "results/gl_context.hpp"
#include "results/image.hpp"
#include "tests/apps/support/command.hpp"

namespace scanchor {
namespace {

using testing_support::lines_of;
using testing_support::run_scanchor;
using testing_support::scratch;

/// A small room with its scan, surfaces and labels, made once: its folder in the scratch folder.
const std::string& room() {
  static const std::string name = [] {
    const auto ran = run_scanchor(
        "run --scenes 1 --no-pictures --out drawn --set lidar.lines=60 --set "
        "lidar.beams_per_line=120 -q");
    EXPECT_EQ(ran.code, 0) << ran.error;
    return std::string("drawn/00/");
  }();
  return name;
}

/// How many pixels are not background.
std::size_t drawn_pixels(const Image& image) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < image.rgb.size(); i += 3)
    count += image.rgb[i] < 250 || image.rgb[i + 1] < 250 || image.rgb[i + 2] < 250 ? 1 : 0;
  return count;
}

struct Drawn {
  const char* name;
  std::string arguments;  ///< ROOM stands for the room's folder
  friend void PrintTo(const Drawn& drawn, std::ostream* out) { *out << drawn.name; }
};

class Render : public testing::TestWithParam<Drawn> {
 protected:
  void SetUp() override {
    if (gl_context_name() == "none") GTEST_SKIP() << "a build without OpenGL";
  }
};

TEST_P(Render, ShowsMoreThanItsTitle) {
  std::string arguments = GetParam().arguments;
  for (std::size_t at = 0; (at = arguments.find("ROOM/")) != std::string::npos;)
    arguments.replace(at, 5, room());
  const auto ran = run_scanchor("render " + arguments +
                                " --out drawn.png --set render.width=320 --set render.height=200 "
                                "--set render.legend=false");
  ASSERT_EQ(ran.code, 0) << ran.error;
  const Image image = read_png(scratch() + "drawn.png");
  EXPECT_GE(image.width, 320);
  EXPECT_GT(drawn_pixels(image), 3000U);
}

INSTANTIATE_TEST_SUITE_P(
    Table, Render,
    testing::Values(Drawn{"scene", "ROOM/scene.json"},
                    Drawn{"scene_from_above", "ROOM/scene.json --view top"},
                    Drawn{"scene_from_the_side", "ROOM/scene.json --view side --azimuth 0"},
                    Drawn{"cloud_from_the_sensor", "ROOM/scan.pcd --view sensor"},
                    Drawn{"cloud_by_class", "ROOM/scan.pcd --color class"},
                    Drawn{"surfaces", "ROOM/surfaces.json"},
                    Drawn{"labels_with_relations", "ROOM/labels.json --relations -2"},
                    Drawn{"before_and_after",
                          "ROOM/scan.pcd ROOM/labels.json --title before --title after"},
                    Drawn{"rooms_together", "ROOM/scene.json ROOM/scene.json --together"}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(RenderLimits, OnePointIsAPicture) {
  if (gl_context_name() == "none") GTEST_SKIP() << "a build without OpenGL";
  write_file(scratch() + "one.xyz", "1 2 3\n");
  EXPECT_EQ(run_scanchor("render one.xyz --out one.png").code, 0);
  EXPECT_GT(drawn_pixels(read_png(scratch() + "one.png")), 10U);
}

TEST(RenderOutlines, SvgHoldsEveryPolygonAndEveryName) {
  const auto surfaces = run_scanchor("render " + room() + "surfaces.json --out surfaces.svg");
  ASSERT_EQ(surfaces.code, 0) << surfaces.error;
  const std::string drawn = read_file(scratch() + "surfaces.svg");
  EXPECT_EQ(drawn.rfind("<svg ", 0), 0U);
  std::size_t paths = 0;
  for (std::size_t at = 0; (at = drawn.find("<path", at)) != std::string::npos; ++at) ++paths;
  const Json json = read_json(scratch() + room() + "surfaces.json");
  EXPECT_GT(paths, json["surfaces"].size() / 2) << "some look away";

  const auto labels = run_scanchor("render " + room() + "labels.json --out labels.svg");
  ASSERT_EQ(labels.code, 0) << labels.error;
  EXPECT_NE(read_file(scratch() + "labels.svg").find(">floor"), std::string::npos);
}

TEST(RenderLimits, WhatCannotBeDrawnIsOneLine) {
  write_file(scratch() + "one.xyz", "1 2 3\n");
  write_file(scratch() + "empty.xyz", "");
  write_file(scratch() + "file", "not a folder");
  room();
  std::filesystem::create_directories(scratch() + "alone");
  std::filesystem::copy_file(scratch() + room() + "labels.json", scratch() + "alone/labels.json",
                             std::filesystem::copy_options::overwrite_existing);
  const struct {
    std::string arguments;
    int code;
    const char* message;
  } cases[] = {
      {"render empty.xyz --out x.png", 3, "empty.xyz: is empty"},
      {"render one.xyz --out file/below/x.png", 3, "file"},
      {"render one.xyz --out /proc/nowhere/x.png", 3, "cannot be written"},
      {"render one.xyz --view below --out x.png", 2, "perspective"},
      {"render alone/labels.json --out x.png", 3, "surfaces.json"},
      {"render " + room() + "labels.json --relations 100000 --out x.png", 2, "has no thing"},
      {"render one.xyz --out x.svg", 2, "surfaces.json or labels.json"},
      {"render nosuch.json --out x.svg", 3, "cannot be opened"},
      {"render " + room() + "labels.json " + room() + "labels.json --out x.svg", 2, "one thing"},
      {"render one.xyz --out x.bmp", 2, ".png or .svg"},
      {"figures --out file/below", 3, "file"},
      {"report drawn --sweep nowhere", 3, "there is no sweep here"},
  };
  for (const auto& bad : cases) {
    std::filesystem::remove(scratch() + "x.png");
    const auto ran = run_scanchor(bad.arguments);
    EXPECT_EQ(ran.code, bad.code) << bad.arguments << "\n" << ran.error;
    EXPECT_EQ(lines_of(ran.error), 1) << ran.error;
    EXPECT_NE(ran.error.find(bad.message), std::string::npos) << ran.error;
    EXPECT_FALSE(std::filesystem::exists(scratch() + "x.png")) << bad.arguments;
  }
}

}  // namespace
}  // namespace scanchor
