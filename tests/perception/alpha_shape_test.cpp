#include "perception/alpha_shape.hpp"

#include <CGAL/Alpha_shape_2.h>
#include <CGAL/Alpha_shape_face_base_2.h>
#include <CGAL/Alpha_shape_vertex_base_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <gtest/gtest.h>

#include <set>

#include "core/random.hpp"
#include "perception/polygon_check.hpp"

namespace scanchor {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Alpha_shape_vertex_base_2<Kernel>;
using ShapeFace = CGAL::Alpha_shape_face_base_2<Kernel>;
using Peer = CGAL::Alpha_shape_2<CGAL::Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<Vertex, ShapeFace>>>;
using Edge = std::pair<std::pair<double, double>, std::pair<double, double>>;

Edge edge(double ax, double ay, double bx, double by) {
  const std::pair a{ax, ay};
  const std::pair b{bx, by};
  return a < b ? Edge{a, b} : Edge{b, a};
}

void add_edges(const Ring& ring, std::set<Edge>& edges) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const auto& a = ring[i];
    const auto& b = ring[(i + 1) % ring.size()];
    edges.insert(edge(a.x(), a.y(), b.x(), b.y()));
  }
}

bool simple_by_cgal(const Ring& ring) {
  CGAL::Polygon_2<Kernel> polygon;
  for (const auto& p : ring) polygon.push_back({p.x(), p.y()});
  return polygon.is_simple();
}

std::vector<Eigen::Vector2d> blob(std::uint64_t seed, int count) {
  SequentialRandom random(seed);
  std::vector<Eigen::Vector2d> points;
  while (static_cast<int>(points.size()) < count) {
    const Eigen::Vector2d p(random.uniform(-1, 1), random.uniform(-1, 1));
    if (p.norm() > 0.35 || seed % 2 == 0) points.push_back(p);  // every second one with a hole
  }
  return points;
}

TEST(AlphaShape, IsTheRegularizedShapeOfCgal) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto points = blob(seed, 150);
    std::vector<Kernel::Point_2> peers;
    for (const auto& p : points) peers.emplace_back(p.x(), p.y());
    for (const double radius : {0.06, 0.1, 0.2, 0.6}) {
      const Peer peer(peers.begin(), peers.end(), radius * radius, Peer::REGULARIZED);
      std::set<Edge> expected;
      for (auto it = peer.alpha_shape_edges_begin(); it != peer.alpha_shape_edges_end(); ++it) {
        const auto s = peer.segment(*it);
        expected.insert(edge(s.source().x(), s.source().y(), s.target().x(), s.target().y()));
      }
      double area = 0.0;
      for (auto face = peer.finite_faces_begin(); face != peer.finite_faces_end(); ++face) {
        if (peer.classify(face) == Peer::INTERIOR) area += std::abs(peer.triangle(face).area());
      }
      std::set<Edge> found;
      double sum = 0.0;
      for (const Polygon& polygon : alpha_shape(points, radius)) {
        add_edges(polygon.outer, found);
        for (const Ring& hole : polygon.holes) add_edges(hole, found);
        sum += polygon.area();
      }
      EXPECT_EQ(found, expected) << "seed " << seed << ", radius " << radius;
      EXPECT_NEAR(sum, area, 1e-12);
    }
  }
}

TEST(AlphaShape, RingsAreSimpleAndTurnTheRightWay) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    for (const Polygon& polygon : alpha_shape(blob(seed, 200), 0.09)) {
      EXPECT_GT(ring_area(polygon.outer), 0.0);
      EXPECT_TRUE(simple_by_cgal(polygon.outer));
      EXPECT_TRUE(is_simple(polygon.outer));
      for (const Ring& hole : polygon.holes) {
        EXPECT_LT(ring_area(hole), 0.0);
        EXPECT_TRUE(simple_by_cgal(hole));
      }
    }
  }
}

TEST(PolygonCheck, AgreesWithCgalOnRandomRings) {
  SequentialRandom random(12);
  int simple = 0;
  for (int round = 0; round < 400; ++round) {
    Ring ring(4 + random.below(3));
    for (auto& p : ring) p = {random.uniform(), random.uniform()};
    EXPECT_EQ(is_simple(ring), simple_by_cgal(ring));
    simple += is_simple(ring);
  }
  EXPECT_GT(simple, 50);
  EXPECT_LT(simple, 350);
}

TEST(AlphaShape, MedianSpacingOfALattice) {
  std::vector<Eigen::Vector2d> points;
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 20; ++x) points.emplace_back(0.02 * x, 0.05 * y);
  }
  EXPECT_NEAR(median_spacing(points, delaunay(points)), 0.02, 1e-12);
  EXPECT_EQ(median_spacing({}, {}), 0.0);
}

}  // namespace
}  // namespace scanchor
