#include "perception/alpha_triangulation.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "core/random.hpp"

namespace scanchor {
namespace {

std::vector<Eigen::Vector2d> random_points(int count, std::uint64_t seed) {
  SequentialRandom random(seed);
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < count; ++i) points.emplace_back(random.uniform(), random.uniform());
  return points;
}

TEST(Triangulation, NoPointLiesInACircumcircle) {
  const auto points = random_points(120, 3);
  const Triangulation mesh = delaunay(points);
  ASSERT_FALSE(mesh.triangles.empty());
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector2d& a = points[t[0]];
    const Eigen::Vector2d u = points[t[1]] - a;
    const Eigen::Vector2d v = points[t[2]] - a;
    ASSERT_GT(u.x() * v.y() - u.y() * v.x(), 0.0) << "counter-clockwise";
    for (const auto& p : points) {
      const Eigen::Vector2d w = p - a;
      Eigen::Matrix3d m;
      m << u.x(), u.y(), u.squaredNorm(), v.x(), v.y(), v.squaredNorm(), w.x(), w.y(),
          w.squaredNorm();
      EXPECT_GE(m.determinant(), -1e-12);  // positive: outside, for a counter-clockwise triangle
    }
  }
}

TEST(Triangulation, NeighboursShareAnEdge) {
  const Triangulation mesh = delaunay(random_points(200, 4));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto n = mesh.neighbours[t][k];
      if (n < 0) continue;
      const auto& other = mesh.triangles[static_cast<std::size_t>(n)];
      EXPECT_TRUE(std::count(other.begin(), other.end(), mesh.triangles[t][(k + 1) % 3]));
      EXPECT_TRUE(std::count(other.begin(), other.end(), mesh.triangles[t][(k + 2) % 3]));
      EXPECT_FALSE(std::count(other.begin(), other.end(), mesh.triangles[t][k]));
    }
  }
}

TEST(Triangulation, DuplicatesAndLinesAreNoTrouble) {
  EXPECT_TRUE(delaunay({}).triangles.empty());
  EXPECT_TRUE(delaunay({{1, 1}, {1, 1}, {1, 1}, {1, 1}}).triangles.empty());
  EXPECT_TRUE(delaunay({{0, 0}, {1, 1}, {2, 2}, {3, 3}}).triangles.empty());
  EXPECT_EQ(delaunay({{0, 0}, {0, 0}, {1, 0}, {0, 1}, {1, 0}}).triangles.size(), 1U);
}

TEST(Triangulation, HoldsEveryPointAndFillsTheHullOnHardInput) {
  // Lattices (four on a circle), circles (all on one), points nearly on a line, rows of duplicates:
  // n corners, h of them on the hull, make 2 n - h - 2 triangles, whose areas add up to the hull's.
  SequentialRandom random(11);
  for (int round = 0; round < 200; ++round) {
    std::vector<Eigen::Vector2d> points;
    const int count = 4 + static_cast<int>(random.below(150));
    for (int i = 0; i < count; ++i) {
      Eigen::Vector2d p(random.uniform(), random.uniform());
      if (round % 5 == 1) p = {std::floor(8 * p.x()), std::floor(8 * p.y()) / 3.0};
      if (round % 5 == 2) p = {std::cos(6.3 * p.x()), std::sin(6.3 * p.x())};
      if (round % 5 == 3 && i % 9 != 0) p.y() = 0.3 + 1e-15 * p.x();
      if (round % 5 == 4 && i % 3 == 2) p = points[static_cast<std::size_t>(i) / 2];
      points.push_back(p);
    }
    const Triangulation mesh = delaunay(points);
    std::set<std::uint32_t> corners;
    std::size_t hull = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      corners.insert(mesh.triangles[t].begin(), mesh.triangles[t].end());
      hull += static_cast<std::size_t>(
          std::count(mesh.neighbours[t].begin(), mesh.neighbours[t].end(), -1));
    }
    std::set<std::pair<double, double>> places;
    for (const auto& p : points) places.emplace(p.x(), p.y());
    if (mesh.triangles.empty()) continue;  // all on one line
    EXPECT_EQ(corners.size(), places.size()) << "round " << round;
    EXPECT_EQ(mesh.triangles.size(), 2 * places.size() - hull - 2) << "round " << round;
  }
}

TEST(Triangulation, APermutationOfALatticeGivesTheSameTriangles) {
  // A lattice: every four neighbours lie on one circle, so the choice of the diagonal must come
  // from the points and not their order.
  std::vector<Eigen::Vector2d> points;
  for (int y = 0; y < 12; ++y) {
    for (int x = 0; x < 12; ++x) points.emplace_back(x, y);
  }
  const auto as_set = [](const std::vector<Eigen::Vector2d>& p) {
    std::set<std::vector<std::pair<double, double>>> result;
    for (const auto& t : delaunay(p).triangles) {
      std::vector<std::pair<double, double>> corners;
      for (const auto i : t) corners.emplace_back(p[i].x(), p[i].y());
      std::sort(corners.begin(), corners.end());
      result.insert(corners);
    }
    return result;
  };
  const auto expected = as_set(points);
  EXPECT_EQ(expected.size(), 2U * 11 * 11);
  SequentialRandom random(8);
  for (int round = 0; round < 3; ++round) {
    for (std::size_t i = points.size(); i > 1; --i)
      std::swap(points[i - 1], points[random.below(static_cast<std::uint32_t>(i))]);
    EXPECT_EQ(as_set(points), expected);
  }
}

TEST(HilbertOrder, NeighboursInTheOrderAreNearInThePlane) {
  const auto points = random_points(4000, 9);
  const auto order = hilbert_order(points);
  std::vector<std::uint32_t> sorted = order;
  std::sort(sorted.begin(), sorted.end());
  for (std::uint32_t i = 0; i < sorted.size(); ++i) ASSERT_EQ(sorted[i], i);
  double along = 0.0;
  for (std::size_t i = 1; i < order.size(); ++i)
    along += (points[order[i]] - points[order[i - 1]]).norm();
  // A random order would walk 0.52 a step, 2,085 in all; the curve about 0.92 sqrt(n) = 58.
  EXPECT_LT(along, 90.0);
}

}  // namespace
}  // namespace scanchor
