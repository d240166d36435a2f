#include "scenes/import.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/error.hpp"
#include "core/file.hpp"
#include "tests/scenes/support/scene_checks.hpp"

namespace scanchor {
namespace {

std::filesystem::path temporary(const std::string& name, const std::string& content) {
  const auto path = std::filesystem::temp_directory_path() / ("scanchor_import_" + name);
  write_file(path, content);
  return path;
}

// A table top of 2 x 1 m at y = 0.7 (y is up), as two quads back to back and a stool of one
// triangle.
const char* const obj = R"(o Kitchen_Table
v 0 0.7 0
v 2 0.7 0
v 2 0.7 1
v 0 0.7 1
v 5 0 0
v 6 0 0
v 5 1 0
f 1 4 3 2
o bar_stool
f 5 6 7
)";

TEST(Import, ObjectsBecomeInstancesWithClassesByName) {
  if (!can_import_meshes()) {
    EXPECT_THROW(import_scene("x.obj"), Error);
    return;
  }
  const Scene scene = import_scene(temporary("table.obj", obj));
  ASSERT_EQ(scene.instances.size(), 2U);
  EXPECT_EQ(class_info(scene.instances[0].class_id).name, "table");
  EXPECT_EQ(class_info(scene.instances[1].class_id).name, "stool");
  const WorldFace top = world_face(scene, {0, 0, 0});
  EXPECT_NEAR(top.area, 2.0, 1e-6);
  EXPECT_NEAR(top.center.z(), 0.7, 1e-6) << "y-up files are turned";
  EXPECT_NEAR(std::abs(top.normal.z()), 1.0, 1e-6);
}

TEST(Import, TheCallersNamesWinAndScaleIsApplied) {
  if (!can_import_meshes()) return;
  MeshImport options;
  options.scale = 0.001;
  const Scene scene =
      import_scene(temporary("desk.obj", obj), {{"kitchen", *find_class("desk")}}, options);
  EXPECT_EQ(class_info(scene.instances[0].class_id).name, "desk");
  EXPECT_NEAR(world_face(scene, {0, 0, 0}).size.x(), 0.002, 1e-9);
}

TEST(Import, BadFilesGiveOneLine) {
  if (!can_import_meshes()) return;
  const auto line = [](const std::filesystem::path& path) {
    try {
      import_scene(path);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::bad_data);
      EXPECT_NE(std::string(error.what()).find(path.filename().string()), std::string::npos);
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(line("no_such_file.obj").find("no such mesh file"), std::string::npos);
  EXPECT_NE(line(temporary("noise.obj", "this is no mesh\n")), "");
  EXPECT_NE(line(temporary("noise.xyzw", "this is no mesh\n")), "");
}

// Meshes of real furniture: the planes that a person sees are there.
TEST(Import, RealFurniture) {
  const std::filesystem::path folder = std::filesystem::path(SCANCHOR_SHARED_DATA) / "meshes";
  if (!can_import_meshes() || !std::filesystem::exists(folder)) GTEST_SKIP() << "no shared meshes";
  int files = 0;
  for (const auto& [name, class_name] : {std::pair{"KitchenTable_01_visual.obj", "table"},
                                         std::pair{"ReadingDesk_01_visual.obj", "desk"}}) {
    if (!std::filesystem::exists(folder / name)) continue;
    ++files;
    MeshImport z_up;
    z_up.y_up = false;
    const Scene scene = import_scene(folder / name, {}, z_up);
    ASSERT_FALSE(scene.instances.empty());
    EXPECT_EQ(class_info(scene.instances[0].class_id).name, class_name) << name;
    double largest = 0.0;
    for (const auto& address : all_faces(scene)) {
      const auto& face = scene.instances[static_cast<std::size_t>(address.instance)]
                             .parts[static_cast<std::size_t>(address.part)]
                             .faces[static_cast<std::size_t>(address.face)];
      if (face.planar && std::abs(world_face(scene, address).normal.z()) > 0.99)
        largest = std::max(largest, face.area);
    }
    EXPECT_GT(largest, 0.3) << name << ": a table has a top";
    EXPECT_LT(largest, 5.0) << name;
  }
  EXPECT_GT(files, 0);
}

}  // namespace
}  // namespace scanchor
