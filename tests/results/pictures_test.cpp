#include "results/pictures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "results/gl_context.hpp"
#include "tests/results/samples.hpp"
#include "tests/results/surface_samples.hpp"

namespace scanchor {
namespace {

class Pictures : public ::testing::Test {
 protected:
  void SetUp() override {
    if (gl_context_name() == "none") GTEST_SKIP() << "a build without OpenGL";
    options.render.width = 480;
    options.render.height = 300;
    options.render.legend = false;
  }
  PictureOptions options;
};

/// Pixels near a colour, whatever its shade: the same hue direction.
std::size_t tinted(const Image& image, Color color) {
  const Eigen::Vector3d want = Eigen::Vector3d(color.r, color.g, color.b).normalized();
  std::size_t n = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const Color c = samples::pixel(image, x, y);
      n += Eigen::Vector3d(c.r, c.g, c.b).normalized().dot(want) > 0.995 && c.b + 40 < c.r ? 1 : 0;
    }
  }
  return n;
}

TEST_F(Pictures, SceneShowsTheDesk) {
  EXPECT_GT(tinted(picture_of_scene(samples::room(), options), color_of_class(*find_class("desk"))),
            1500u);
}

TEST_F(Pictures, LabelsShowTheDeskAndMove) {
  const Surfaces surfaces = samples::two_surfaces();
  PointCloud cloud;
  cloud.points = {{0, 0, 0.72}, {0.1, 0, 0.72}, {0, 0, 1.1}, {3, 3, 0}};
  const Image plain = picture_of_labels(surfaces, samples::two_labels(), options, &cloud);
  Eigen::Isometry3d T(Eigen::Translation3d(100, 0, 0));
  const Image moved = picture_of_labels(surfaces, samples::two_labels(), options, &cloud, T);
  // The same picture from a hundred metres further on, but for rounding.
  std::size_t different = 0;
  for (std::size_t i = 0; i < plain.rgb.size(); ++i)
    different += std::abs(plain.rgb[i] - moved.rgb[i]) > 8 ? 1 : 0;
  EXPECT_LT(different, plain.rgb.size() / 400);
}

TEST_F(Pictures, SurfacesAndCloudsAreDrawn) {
  const Surfaces surfaces = samples::two_surfaces();
  const Image shapes = picture_of_surfaces(surfaces, options);
  EXPECT_LT(samples::count(shapes, paper_white), 480u * 300u * 9 / 10);
  PointCloud cloud;
  for (int i = 0; i < 4000; ++i) cloud.points.emplace_back(0.01 * (i % 80), 0.01 * (i / 80), 0);
  const Image points = picture_of_cloud(cloud, options);
  EXPECT_LT(samples::count(points, paper_white), 480u * 300u * 8 / 10);
}

TEST_F(Pictures, AScanIsDrawnInTheWorld) {
  Scene scene = samples::room();
  Scan scan;
  for (int i = 0; i < 900; ++i)
    scan.cloud.points.emplace_back(0.1 * (i % 30), 0.1 * (i / 30), -1.0);
  scan.truth.resize(900);
  std::fill(scan.truth.class_id.begin(), scan.truth.class_id.end(), *find_class("desk"));
  scan.line.assign(900, 0);
  scan.beam.assign(900, 0);
  scan.T_world_sensor.translation() = Eigen::Vector3d(1, 1, 1);
  EXPECT_GT(tinted(picture_of_scan(scene, scan, options), color_of_class(*find_class("desk"))),
            1000u);
}

}  // namespace
}  // namespace scanchor
