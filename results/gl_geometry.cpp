#include "results/gl_geometry.hpp"

#include <cmath>

#include "results/triangulate.hpp"

namespace scanchor {
namespace {

void add_line(std::vector<LineVertex>& vertices, const Projection& projection,
              const Eigen::Vector3d& a, const Eigen::Vector3d& b, Color color, double line_px,
              int width, int height) {
  Eigen::Vector4d p = projection.matrix() * a.homogeneous();
  Eigen::Vector4d q = projection.matrix() * b.homogeneous();
  const double near_w = projection.parallel() ? -1e300 : projection.near_plane();
  if (p.w() < near_w && q.w() < near_w) return;
  if (p.w() < near_w) p += (q - p) * ((near_w - p.w()) / (q.w() - p.w()));
  if (q.w() < near_w) q += (p - q) * ((near_w - q.w()) / (p.w() - q.w()));
  const Eigen::Vector2d half(width / 2.0, height / 2.0);
  const Eigen::Vector2d p_px = (p.head<2>() / p.w()).cwiseProduct(half);
  const Eigen::Vector2d q_px = (q.head<2>() / q.w()).cwiseProduct(half);
  Eigen::Vector2d along = q_px - p_px;
  if (!(along.norm() > 1e-9)) return;
  along *= 0.5 * line_px / along.norm();
  const Eigen::Vector2d side = Eigen::Vector2d(-along.y(), along.x()).cwiseQuotient(half);
  const Eigen::Vector2d cap = along.cwiseQuotient(half);
  const auto corner = [&](const Eigen::Vector4d& end, const Eigen::Vector2d& shift) {
    const Eigen::Vector2d moved = end.head<2>() + shift * end.w();
    // A little towards the eye, so that an edge wins against its own face.
    const double z = end.z() - 4e-5 * std::abs(end.w());
    return LineVertex{{float(moved.x()), float(moved.y()), float(z), float(end.w())}, color};
  };
  const LineVertex c[] = {corner(p, side - cap), corner(p, -side - cap), corner(q, -side + cap),
                          corner(q, side + cap)};
  for (const int i : {0, 1, 2, 0, 2, 3}) vertices.push_back(c[i]);
}

void add_ring(std::vector<LineVertex>& vertices, const Projection& projection,
              const std::vector<Eigen::Vector3d>& ring, const DrawnPolygon& polygon, int width,
              int height) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    add_line(vertices, projection, ring[i], ring[(i + 1) % ring.size()], polygon.outline,
             polygon.outline_px, width, height);
  }
}

}  // namespace

std::vector<LineVertex> line_vertices(const Drawing& drawing, const Projection& projection,
                                      int width, int height, bool hidden) {
  std::vector<LineVertex> vertices;
  for (const DrawnLines& lines : drawing.lines) {
    if (lines.hidden != hidden) continue;
    for (std::size_t i = 0; i + 1 < lines.ends.size(); i += 2) {
      add_line(vertices, projection, lines.ends[i], lines.ends[i + 1], lines.color, lines.width_px,
               width, height);
    }
  }
  if (!hidden) {
    for (const DrawnPolygon& polygon : drawing.polygons) {
      if (polygon.outline.a == 0) continue;
      add_ring(vertices, projection, polygon.outer, polygon, width, height);
      for (const auto& hole : polygon.holes) {
        add_ring(vertices, projection, hole, polygon, width, height);
      }
    }
  }
  return vertices;
}

DrawnMesh filling(const DrawnPolygon& polygon) {
  DrawnMesh mesh;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // Newell
  for (std::size_t i = 0; i < polygon.outer.size(); ++i) {
    normal += polygon.outer[i].cross(polygon.outer[(i + 1) % polygon.outer.size()]);
  }
  if (!(normal.norm() > 0.0)) return mesh;
  normal.normalize();
  const Eigen::Vector3d u = normal.unitOrthogonal();
  const Eigen::Vector3d v = normal.cross(u);
  std::vector<std::vector<Eigen::Vector2d>> rings;
  const auto add = [&](const std::vector<Eigen::Vector3d>& ring) {
    rings.emplace_back();
    for (const Eigen::Vector3d& p : ring) {
      rings.back().emplace_back(u.dot(p), v.dot(p));
      mesh.vertices.push_back(p);
    }
  };
  add(polygon.outer);
  for (const auto& hole : polygon.holes) add(hole);
  mesh.triangles = triangulate(rings);
  mesh.colors.assign(mesh.vertices.size(), polygon.fill);
  return mesh;
}

}  // namespace scanchor
