#include "perception/alpha_triangulation.hpp"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <numeric>

namespace scanchor {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using Face = CGAL::Triangulation_face_base_with_info_2<std::int32_t, Kernel>;
using Delaunay =
    CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex, Face>>;

constexpr std::uint32_t side = 1U << 16;

/// Place of cell (x, y) on the curve; see Warren, Hacker's Delight, section 16-3.
std::uint64_t hilbert_place(std::uint32_t x, std::uint32_t y) {
  std::uint64_t place = 0;
  for (std::uint32_t s = side / 2; s > 0; s /= 2) {
    const std::uint32_t rx = (x & s) ? 1 : 0;
    const std::uint32_t ry = (y & s) ? 1 : 0;
    place += std::uint64_t{s} * s * ((3 * rx) ^ ry);
    if (ry == 0) {
      if (rx == 1) {
        x = side - 1 - x;
        y = side - 1 - y;
      }
      std::swap(x, y);
    }
  }
  return place;
}

}  // namespace

std::vector<std::uint32_t> hilbert_order(const std::vector<Eigen::Vector2d>& points) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  if (points.size() < 2) return order;
  Eigen::Vector2d low = points.front();
  Eigen::Vector2d high = points.front();
  for (const auto& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double extent = std::max((high - low).maxCoeff(), 1e-300);
  const double scale = (side - 1) / extent;
  struct Key {
    std::uint64_t place;
    std::uint32_t index;
  };
  std::vector<Key> keys(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    keys[i] = {hilbert_place(static_cast<std::uint32_t>((points[i].x() - low.x()) * scale),
                             static_cast<std::uint32_t>((points[i].y() - low.y()) * scale)),
               static_cast<std::uint32_t>(i)};
  }
  std::sort(keys.begin(), keys.end(), [&](const Key& a, const Key& b) {
    if (a.place != b.place) return a.place < b.place;
    const auto& p = points[a.index];
    const auto& q = points[b.index];
    if (p.x() != q.x()) return p.x() < q.x();
    if (p.y() != q.y()) return p.y() < q.y();
    return a.index < b.index;
  });
  for (std::size_t i = 0; i < keys.size(); ++i) order[i] = keys[i].index;
  return order;
}

Triangulation delaunay(const std::vector<Eigen::Vector2d>& points) {
  Triangulation result;
  if (points.size() < 3) return result;
  Delaunay triangulation;
  Delaunay::Face_handle hint;
  for (const std::uint32_t i : hilbert_order(points)) {
    const std::size_t before = triangulation.number_of_vertices();
    const auto vertex = triangulation.insert(Kernel::Point_2(points[i].x(), points[i].y()), hint);
    if (triangulation.number_of_vertices() > before) vertex->info() = i;
    hint = vertex->face();
  }
  if (triangulation.dimension() < 2) return result;
  result.triangles.reserve(triangulation.number_of_faces());
  for (auto face = triangulation.all_faces_begin(); face != triangulation.all_faces_end(); ++face)
    face->info() = -1;
  for (const auto face : triangulation.finite_face_handles()) {
    face->info() = static_cast<std::int32_t>(result.triangles.size());
    result.triangles.push_back(
        {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  }
  result.neighbours.reserve(result.triangles.size());
  for (const auto face : triangulation.finite_face_handles()) {
    result.neighbours.push_back(
        {face->neighbor(0)->info(), face->neighbor(1)->info(), face->neighbor(2)->info()});
  }
  return result;
}

}  // namespace scanchor
