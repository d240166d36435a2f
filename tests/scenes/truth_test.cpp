#include "scenes/truth.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"
#include "scenes/mesh.hpp"
#include "scenes/pose.hpp"

namespace scanchor {
namespace {

TEST(Truth, SmallestRectangleOfATurnedRectangle) {
  for (const double angle : {0.0, 0.3, 1.2, 2.9}) {
    const SinCos sc = portable_sincos(angle);
    std::vector<Eigen::Vector2d> points;
    for (const double u : {-0.8, 0.8}) {
      for (const double v : {-0.35, 0.35})
        points.emplace_back(2 + u * sc.cos - v * sc.sin, 1 + u * sc.sin + v * sc.cos);
    }
    const PlaneRectangle r = smallest_rectangle(points);
    EXPECT_NEAR(r.size.x(), 1.6, 1e-12);
    EXPECT_NEAR(r.size.y(), 0.7, 1e-12);
    EXPECT_NEAR((r.center - Eigen::Vector2d(2, 1)).norm(), 0, 1e-12);
    EXPECT_NEAR(std::abs(r.axis.x() * sc.cos + r.axis.y() * sc.sin), 1, 1e-12);
  }
}

// Oracle: all directions in steps of 0.02 degrees.
TEST(Truth, NoDirectionGivesASmallerRectangle) {
  SequentialRandom random(7);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<Eigen::Vector2d> points;
    for (int i = 0; i < 12; ++i)
      points.emplace_back(random.uniform(-1, 1), 0.4 * random.uniform(-1, 1));
    const PlaneRectangle r = smallest_rectangle(points);
    double best = 1e9;
    for (int k = 0; k < 4500; ++k) {
      const double a = radians(0.02 * k);
      double lo[2] = {1e9, 1e9};
      double hi[2] = {-1e9, -1e9};
      for (const auto& p : points) {
        const double c[2] = {std::cos(a) * p.x() + std::sin(a) * p.y(),
                             -std::sin(a) * p.x() + std::cos(a) * p.y()};
        for (int j = 0; j < 2; ++j) {
          lo[j] = std::min(lo[j], c[j]);
          hi[j] = std::max(hi[j], c[j]);
        }
      }
      best = std::min(best, (hi[0] - lo[0]) * (hi[1] - lo[1]));
    }
    EXPECT_LE(r.size.x() * r.size.y(), best + 1e-12);
    EXPECT_GT(r.size.x() * r.size.y(), 0.999 * best);
  }
}

TEST(Truth, AreaOfAnLShapeIsLessThanItsRectangle) {
  const Part part =
      prism_part("top", 0, {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}, 0.7, 0.75);
  const Face& top = part.faces[0];
  EXPECT_NEAR(top.area, 4.0, 1e-12);
  // The rectangle along the diagonal of the L is no smaller than 2 x 3.
  EXPECT_LE(top.size.x() * top.size.y(), 6.0 + 1e-9);
  EXPECT_NEAR(top.normal.z(), 1.0, 1e-12);
  EXPECT_NEAR(top.center.z(), 0.75, 1e-12);
}

TEST(Truth, FindsTheFacesOfABoxAndOfACylinder) {
  Part box = box_part("box", 0, {0, 0, 0}, {1, 2, 3});
  find_faces(box);
  ASSERT_EQ(box.faces.size(), 6U);
  double area = 0.0;
  for (const auto& face : box.faces) {
    EXPECT_TRUE(face.planar);
    area += face.area;
  }
  EXPECT_NEAR(area, 22.0, 1e-12);
  Part cylinder = cylinder_part("c", 0, {0, 0, 0}, {0, 0, 1}, 0.2, 24);
  find_faces(cylinder);
  int planar = 0;
  int curved = 0;
  for (const auto& face : cylinder.faces) (face.planar ? planar : curved) += 1;
  EXPECT_EQ(planar, 2);
  EXPECT_EQ(curved, 1);
}

// Imported meshes repeat vertices along seams: neighbours are found by place, not by index.
TEST(Truth, FindsFacesAcrossRepeatedVertices) {
  Part part;
  part.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  part.triangles = {{0, 1, 2}, {3, 4, 5}};
  find_faces(part);
  ASSERT_EQ(part.faces.size(), 1U);
  EXPECT_NEAR(part.faces[0].area, 1.0, 1e-12);
}

TEST(Truth, ConvexityOfPrisms) {
  EXPECT_TRUE(is_convex(prism_part("p", 0, {{0, 0}, {1, 0}, {0, 1}}, 0, 1)));
  EXPECT_FALSE(
      is_convex(prism_part("p", 0, {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}, 0, 1)));
}

}  // namespace
}  // namespace scanchor
