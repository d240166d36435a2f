#include "results/view.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"

namespace scanchor {
namespace {

Eigen::AlignedBox3d some_box(SequentialRandom& random) {
  Eigen::AlignedBox3d box;
  for (int i = 0; i < 2; ++i) {
    box.extend(Eigen::Vector3d(random.uniform(-8, 8), random.uniform(-8, 8), random.uniform(0, 4)));
  }
  return box;
}

Eigen::Vector3d corner(const Eigen::AlignedBox3d& box, int i) {
  return {(i & 1 ? box.max() : box.min()).x(), (i & 2 ? box.max() : box.min()).y(),
          (i & 4 ? box.max() : box.min()).z()};
}

// Property: the whole box is inside the picture, and it touches two opposite margins.
TEST(View, FramesABox) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SequentialRandom random(seed);
    const auto box = some_box(random);
    const double azimuth = random.uniform(-180, 180);
    const double elevation = random.uniform(5, 85);
    for (const View& view :
         {perspective_view(box, azimuth, elevation, 16.0 / 9.0, 0.9),
          top_view(box, 16.0 / 9.0, 0.9), side_view(box, azimuth, 16.0 / 9.0, 0.9)}) {
      const Projection projection(view, 1600, 900, box);
      double used = 0;
      for (int i = 0; i < 8; ++i) {
        const Eigen::Vector3d p = projection.pixel(corner(box, i));
        const double share = std::max(std::abs(p.x() - 800) / 800, std::abs(p.y() - 450) / 450);
        EXPECT_LE(share, 0.9001) << seed;
        used = std::max(used, share);
        EXPECT_GT(p.z(), projection.near_plane());
        EXPECT_LT(p.z(), projection.far_plane());
      }
      EXPECT_GT(used, 0.87) << seed;
    }
  }
}

TEST(View, MatrixAndPixelAgree) {
  SequentialRandom random(7);
  for (const double fov : {0.0, 40.0}) {
    View view;
    view.vertical_fov_deg = fov;
    const Eigen::AlignedBox3d box(Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(1, 1, 1));
    const Projection projection(view, 640, 480, box, {30, -20});
    for (int i = 0; i < 50; ++i) {
      const Eigen::Vector3d p(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      const Eigen::Vector4d clip = projection.matrix() * p.homogeneous();
      const Eigen::Vector3d pixel = projection.pixel(p);
      EXPECT_NEAR((clip.x() / clip.w() + 1) * 320, pixel.x(), 1e-6);
      EXPECT_NEAR((1 - clip.y() / clip.w()) * 240, pixel.y(), 1e-6);
      EXPECT_NEAR(projection.distance_of_depth((clip.z() / clip.w() + 1) / 2), pixel.z(), 1e-6);
    }
  }
}

TEST(View, ASensorLooksAlongItsXAxis) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translate(Eigen::Vector3d(1, 2, 1.5));
  pose.rotate(Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitZ()));
  const Eigen::AlignedBox3d box(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(5, 5, 3));
  const Projection projection(sensor_view(pose), 640, 480, box);
  const Eigen::Vector3d ahead = projection.pixel(pose * Eigen::Vector3d(2, 0, 0));
  EXPECT_NEAR(ahead.x(), 320, 1e-9);
  EXPECT_NEAR(ahead.z(), 2.0, 1e-9);
  EXPECT_LT(projection.pixel(pose * Eigen::Vector3d(2, 0.5, 0)).x(), 320);  // y is to the left
}

TEST(View, NothingAndOnePointCanBeFramed) {
  for (const Eigen::AlignedBox3d& box :
       {Eigen::AlignedBox3d(), Eigen::AlignedBox3d(Eigen::Vector3d(3, 4, 5))}) {
    for (const View& view : {perspective_view(box), top_view(box), side_view(box)}) {
      const Projection projection(view, 640, 480, box);
      EXPECT_TRUE(projection.matrix().allFinite());
    }
  }
  EXPECT_TRUE(perspective_view(std::vector<Eigen::Vector3d>{}, 10, 10, 1, 1).eye.allFinite());
}

}  // namespace
}  // namespace scanchor
