#include "results/draw_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/results/samples.hpp"

namespace scanchor {
namespace {

std::size_t triangles(const Drawing& drawing) {
  std::size_t n = 0;
  for (const DrawnMesh& mesh : drawing.meshes) n += mesh.triangles.size();
  return n;
}

TEST(DrawScene, OpensTheRoomTowardsTheViewer) {
  DrawSceneOptions options;
  options.towards_eye = towards_eye(-90, 40);  // from -y and above
  const Drawing open = draw_scene(samples::room(), options);
  // Floor, far wall and desk stay: 2 + 2 + 12 triangles. Near wall, ceiling and the door in the
  // near wall are gone.
  EXPECT_EQ(triangles(open), 16u);
  options.towards_eye = towards_eye(90, 40);  // from the other side the door's wall stays
  EXPECT_EQ(triangles(draw_scene(samples::room(), options)), 28u);
  options.towards_eye.setZero();
  EXPECT_EQ(triangles(draw_scene(samples::room(), options)), 32u);
}

/// The sample room with a window in the far wall: a quarter of a metre of reveal on its left side,
/// which looks to +x, and a frame in it.
Scene room_with_window() {
  Scene scene = samples::room();
  Part& wall = scene.instances[2].parts[0];
  const int first = int(wall.vertices.size());
  for (const auto& [y, z] : {std::pair{3.0, 1.0}, {3.25, 1.0}, {3.25, 2.0}, {3.0, 2.0}})
    wall.vertices.emplace_back(1.0, y, z);
  wall.triangles.emplace_back(first, first + 1, first + 2);
  wall.triangles.emplace_back(first, first + 2, first + 3);
  wall.triangle_face.insert(wall.triangle_face.end(), {0, 0});
  Instance window;
  window.id = 99;
  window.class_id = *find_class("window");
  window.parts.push_back(box_part("frame", 0, {1.4, 3.2, 1.5}, {0.8, 0.05, 1.0}));
  scene.instances.push_back(window);
  return scene;
}

TEST(DrawScene, AWindowStaysWhereOnlyItsRevealLooksAway) {
  DrawSceneOptions options;
  options.towards_eye = towards_eye(-135, 40);  // from -x and -y: the reveal turns its back
  const Drawing from_left = draw_scene(room_with_window(), options);
  EXPECT_EQ(triangles(from_left), 28u);  // floor, far wall, desk and the frame
}

TEST(DrawScene, AWallThatIsTurnedAwayGoesWithItsReveals) {
  DrawSceneOptions options;
  options.towards_eye = towards_eye(45, 40);  // from +x and +y: the far wall turns its back
  const Drawing from_behind = draw_scene(room_with_window(), options);
  EXPECT_EQ(triangles(from_behind), 28u);  // floor, near wall, desk and the door in it
}

TEST(DrawScene, ColoursByClassMaterialAndInstance) {
  DrawSceneOptions options;
  options.towards_eye = towards_eye(-90, 40);
  const Color desk = color_of_class(*find_class("desk"));
  const auto uses = [&](Color color) {
    const Drawing drawing = draw_scene(samples::room(), options);
    const auto& colors = drawing.meshes[0].colors;
    return std::count(colors.begin(), colors.end(), color);
  };
  EXPECT_EQ(uses(desk), 36);
  options.color = SceneColor::material;
  EXPECT_EQ(uses({200, 150, 100}), 48);
  options.color = SceneColor::instance;
  EXPECT_EQ(uses(color_of_number(5)), 36);
}

TEST(DrawScene, LegendListsWhatIsThereMostSeenFirst) {
  const Drawing drawing =
      draw_scene(samples::room(), {SceneColor::class_id, towards_eye(-90, 40), true, true, true});
  ASSERT_EQ(drawing.legend.size(), 3u);
  EXPECT_EQ(drawing.legend[0].text, "floor");
  EXPECT_EQ(drawing.legend[1].text, "wall");
  EXPECT_EQ(drawing.legend[2].text, "desk");
  ASSERT_EQ(drawing.labels.size(), 1u);
  EXPECT_EQ(drawing.labels[0].text, "desk");
  EXPECT_NEAR(drawing.labels[0].anchor.z(), 0.74, 1e-9);
}

TEST(DrawScene, EdgesAreThoseOfTheFaces) {
  Scene scene = samples::room();
  scene.instances.erase(scene.instances.begin(), scene.instances.begin() + 4);
  scene.instances.resize(1);  // the desk's top alone: a box has twelve edges, no diagonals
  const Drawing drawing = draw_scene(scene, {});
  ASSERT_EQ(drawing.lines.size(), 1u);
  EXPECT_EQ(drawing.lines[0].ends.size(), 24u);
}

TEST(DrawScene, AnEmptySceneIsAnEmptyDrawing) {
  const Drawing drawing = draw_scene(Scene{});
  EXPECT_TRUE(drawing.bounds.isEmpty());
  EXPECT_TRUE(drawing.legend.empty());
}

TEST(DrawScene, ExplodedRoomsAreApart) {
  Drawing a = draw_scene(samples::room(),
                         {SceneColor::class_id, Eigen::Vector3d::Zero(), true, false, false});
  Drawing b = a;
  b.move(Eigen::Isometry3d(Eigen::Translation3d(4, 0, 0)));
  const Drawing all = explode({a, b}, 0.5);
  EXPECT_NEAR(all.bounds.sizes().x(), 4 + 4 + 2, 1e-9);
  EXPECT_NEAR(all.bounds.sizes().z(), a.bounds.sizes().z(), 1e-9);
}

}  // namespace
}  // namespace scanchor
