#include "scenes/truth.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/math.hpp"
#include "core/polygons.hpp"

namespace scanchor {
namespace {

/// Twice the area times the normal of a triangle.
Eigen::Vector3d area_vector(const Part& part, std::size_t t) {
  const auto& tri = part.triangles[t];
  const Eigen::Vector3d& a = part.vertices[static_cast<std::size_t>(tri[0])];
  return (part.vertices[static_cast<std::size_t>(tri[1])] - a)
      .cross(part.vertices[static_cast<std::size_t>(tri[2])] - a);
}

}  // namespace

PlaneRectangle smallest_rectangle(std::vector<Eigen::Vector2d> points) {
  PlaneRectangle best;
  const auto hull = convex_hull(std::move(points));
  if (hull.empty()) return best;
  best.center = hull.front();
  double best_area = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < hull.size() && hull.size() > 1; ++i) {
    const Eigen::Vector2d edge = hull[(i + 1) % hull.size()] - hull[i];
    const double length = std::sqrt(edge.x() * edge.x() + edge.y() * edge.y());
    if (length < 1e-9) continue;
    const Eigen::Vector2d u = edge / length;
    const Eigen::Vector2d v(-u.y(), u.x());
    double u_low = u.dot(hull[0]);
    double u_high = u_low;
    double v_low = v.dot(hull[0]);
    double v_high = v_low;
    for (const auto& p : hull) {
      u_low = std::min(u_low, u.dot(p));
      u_high = std::max(u_high, u.dot(p));
      v_low = std::min(v_low, v.dot(p));
      v_high = std::max(v_high, v.dot(p));
    }
    const double area = (u_high - u_low) * (v_high - v_low);
    // Equal rectangles differ in the last bits; the first edge keeps its place.
    if (area >= best_area * (1.0 - 1e-12)) continue;
    best_area = area;
    best.center = 0.5 * (u_low + u_high) * u + 0.5 * (v_low + v_high) * v;
    best.size = {u_high - u_low, v_high - v_low};
    best.axis = u;
    if (best.size.y() > best.size.x()) {
      std::swap(best.size.x(), best.size.y());
      best.axis = v;
    }
  }
  return best;
}

void measure_faces(Part& part) {
  std::vector<std::vector<std::size_t>> members(part.faces.size());
  for (std::size_t t = 0; t < part.triangles.size(); ++t) {
    members[static_cast<std::size_t>(part.triangle_face[t])].push_back(t);
  }
  for (std::size_t f = 0; f < part.faces.size(); ++f) {
    Face& face = part.faces[f];
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
    double area = 0.0;
    for (const std::size_t t : members[f]) {
      const Eigen::Vector3d a = area_vector(part, t);
      const double twice = a.norm();
      sum += a;
      area += 0.5 * twice;
      for (int k = 0; k < 3; ++k) {
        centroid += (twice / 6.0) * part.vertices[static_cast<std::size_t>(part.triangles[t][k])];
      }
    }
    face.area = area;
    if (area > 0) centroid /= area;
    face.center = centroid;
    if (!face.planar || area <= 0 || sum.norm() <= 0) {
      face.normal = Eigen::Vector3d::Zero();
      face.axis = Eigen::Vector3d::Zero();
      face.size = Eigen::Vector2d::Zero();
      continue;
    }
    face.normal = sum.normalized();
    // Axes of the plane: start from the world axis that lies flattest in it, so that boxes give
    // their own axes.
    int flattest = 0;
    for (int k = 1; k < 3; ++k) {
      if (std::abs(face.normal[k]) < std::abs(face.normal[flattest])) flattest = k;
    }
    Eigen::Vector3d u = Eigen::Vector3d::Unit(flattest);
    u = (u - face.normal * face.normal.dot(u)).normalized();
    const Eigen::Vector3d v = face.normal.cross(u);
    std::vector<Eigen::Vector2d> flat;
    for (const std::size_t t : members[f]) {
      for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3d d =
            part.vertices[static_cast<std::size_t>(part.triangles[t][k])] - centroid;
        flat.emplace_back(u.dot(d), v.dot(d));
      }
    }
    const PlaneRectangle rectangle = smallest_rectangle(std::move(flat));
    face.center = centroid + rectangle.center.x() * u + rectangle.center.y() * v;
    face.axis = rectangle.axis.x() * u + rectangle.axis.y() * v;
    face.size = rectangle.size;
  }
}

void find_faces(Part& part, double flat_deg, double distance) {
  const std::size_t count = part.triangles.size();
  // Neighbours by the positions of their edges: imported meshes often repeat vertices along seams.
  std::map<std::array<double, 3>, int> ids;
  std::vector<int> id_of_vertex(part.vertices.size());
  for (std::size_t i = 0; i < part.vertices.size(); ++i) {
    const auto& p = part.vertices[i];
    id_of_vertex[i] =
        ids.emplace(std::array<double, 3>{p.x(), p.y(), p.z()}, static_cast<int>(ids.size()))
            .first->second;
  }
  std::map<std::pair<int, int>, std::vector<std::size_t>> edges;
  const auto edge_of = [&](std::size_t t, int k) {
    const int a = id_of_vertex[static_cast<std::size_t>(part.triangles[t][k])];
    const int b = id_of_vertex[static_cast<std::size_t>(part.triangles[t][(k + 1) % 3])];
    return std::pair<int, int>(std::minmax(a, b));  // minmax alone gives references to a and b
  };
  for (std::size_t t = 0; t < count; ++t) {
    for (int k = 0; k < 3; ++k) edges[edge_of(t, k)].push_back(t);
  }
  std::vector<Eigen::Vector3d> normal(count);
  std::vector<double> area(count);
  std::vector<std::size_t> order(count);
  for (std::size_t t = 0; t < count; ++t) {
    const Eigen::Vector3d a = area_vector(part, t);
    area[t] = a.norm();
    normal[t] = area[t] > 0 ? Eigen::Vector3d(a / area[t]) : Eigen::Vector3d::Zero();
    order[t] = t;
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return area[a] > area[b]; });
  const double cos_flat = portable_sincos(radians(flat_deg)).cos;
  part.faces.clear();
  part.triangle_face.assign(count, -1);
  // Two rounds: planes of more than one triangle (or one that is not part of a smooth
  // neighbourhood), then smooth patches.
  const auto grow = [&](std::size_t seed, bool planar) {
    const auto face = static_cast<std::int32_t>(part.faces.size());
    const Eigen::Vector3d origin = part.vertices[static_cast<std::size_t>(part.triangles[seed][0])];
    std::vector<std::size_t> stack = {seed};
    part.triangle_face[seed] = face;
    while (!stack.empty()) {
      const std::size_t t = stack.back();
      stack.pop_back();
      for (int k = 0; k < 3; ++k) {
        for (const std::size_t other : edges[edge_of(t, k)]) {
          if (part.triangle_face[other] >= 0) continue;
          if (planar) {
            if (area[other] > 0 && normal[other].dot(normal[seed]) < cos_flat) continue;
            bool flat = true;
            for (int c = 0; c < 3; ++c) {
              const auto& p = part.vertices[static_cast<std::size_t>(part.triangles[other][c])];
              flat = flat && std::abs(normal[seed].dot(p - origin)) <= distance;
            }
            if (!flat) continue;
          } else if (area[other] > 0 && normal[other].dot(normal[t]) < 0.64) {
            continue;  // a crease of more than 50 degrees ends a smooth patch
          }
          part.triangle_face[other] = face;
          stack.push_back(other);
        }
      }
    }
    Face result;
    result.planar = planar;
    part.faces.push_back(result);
  };
  // A triangle belongs to a curved surface if a neighbour of its kind bends away gently: between
  // `flat_deg` and 30 degrees. A far smaller neighbour is the rounded edge of a flat top.
  std::vector<bool> bends(count, false);
  for (std::size_t t = 0; t < count; ++t) {
    for (int k = 0; k < 3; ++k) {
      for (const std::size_t other : edges[edge_of(t, k)]) {
        const double c = normal[other].dot(normal[t]);
        if (other != t && area[other] > 0.1 * area[t] && c < cos_flat && c > 0.86) bends[t] = true;
      }
    }
  }
  for (const std::size_t t : order) {
    if (part.triangle_face[t] < 0 && area[t] > 0 && !bends[t]) grow(t, true);
  }
  for (const std::size_t t : order) {
    if (part.triangle_face[t] < 0 && area[t] > 0) grow(t, false);
  }
  for (std::size_t t = 0; t < count; ++t) {
    if (part.triangle_face[t] < 0)
      part.triangle_face[t] = 0;  // without area: whoever owns it, no ray sees it
  }
  for (std::size_t f = 0; f < part.faces.size(); ++f) {
    part.faces[f].name = (part.faces[f].planar ? "face " : "curved ") + std::to_string(f + 1);
  }
  if (count > 0 && part.faces.empty()) part.faces.push_back({});
  measure_faces(part);
}

bool is_convex(const Part& part, double tolerance) {
  for (std::size_t t = 0; t < part.triangles.size(); ++t) {
    const Eigen::Vector3d a = area_vector(part, t);
    const double length = a.norm();
    if (length <= 0) continue;
    const Eigen::Vector3d n = a / length;
    const double offset = n.dot(part.vertices[static_cast<std::size_t>(part.triangles[t][0])]);
    for (const auto& p : part.vertices) {
      if (n.dot(p) > offset + tolerance) return false;
    }
  }
  return true;
}

}  // namespace scanchor
