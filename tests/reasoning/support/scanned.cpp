#include "tests/reasoning/support/scanned.hpp"

#include <cmath>

namespace scanchor::test {

Scanned scanned(const std::vector<Plate>& plates, double spacing) {
  Scanned scene;
  scene.surfaces = make_surfaces(plates);
  scene.surfaces.point_spacing = spacing;
  scene.surfaces.sensor_positions = {{0, 0, 1.4}};
  for (auto& surface : scene.surfaces.surfaces) {
    const auto& r = surface.rectangle;
    const Eigen::Vector2d u(std::cos(r.angle), std::sin(r.angle));
    const Eigen::Vector2d v(-u.y(), u.x());
    const int n = static_cast<int>(r.length.value / spacing);
    const int m = static_cast<int>(r.width.value / spacing);
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < m; ++j) {
        const Eigen::Vector2d p = r.center + u * ((i + 0.5) * spacing - 0.5 * r.length.value) +
                                  v * ((j + 0.5) * spacing - 0.5 * r.width.value);
        surface.inliers.push_back(static_cast<std::uint32_t>(scene.cloud.points.size()));
        scene.cloud.points.push_back(surface.T_cloud_surface * Eigen::Vector3d(p.x(), p.y(), 0.0));
        scene.surfaces.plane_of_point.push_back(surface.id);
      }
    }
    surface.inlier_count = surface.inliers.size();
    for (auto& polygon : surface.polygons)
      polygon.outer_kind.assign(polygon.outer.size(), EdgeKind::true_edge);
  }
  return scene;
}

void take_out(Scanned& scene, std::int32_t id, double from, double to) {
  Surface& s = scene.surfaces.surfaces[static_cast<std::size_t>(id)];
  const Eigen::Vector2d u(std::cos(s.rectangle.angle), std::sin(s.rectangle.angle));
  const Eigen::Vector2d v(-u.y(), u.x());
  std::erase_if(s.inliers, [&](std::uint32_t i) {
    const Eigen::Vector3d p = s.T_cloud_surface.inverse() * scene.cloud.points[i];
    const double x = u.dot(p.head<2>() - s.rectangle.center);
    const bool out = x > from && x < to;
    if (out) scene.surfaces.plane_of_point[i] = -1;
    return out;
  });
  s.inlier_count = s.inliers.size();
  const double a = 0.5 * s.rectangle.length.value;
  const double b = 0.5 * s.rectangle.width.value;
  std::vector<Polygon> pieces;
  for (const auto& [low, high] : {std::pair{-a, from}, std::pair{to, a}}) {
    Polygon polygon;
    polygon.outer = {u * low - v * b, u * high - v * b, u * high + v * b, u * low + v * b};
    polygon.outer_kind.assign(4, EdgeKind::true_edge);
    pieces.push_back(polygon);
  }
  // One that was cut before is cut once more.
  std::vector<Polygon> kept;
  for (const auto& polygon : s.polygons) {
    double low = 1e9;
    double high = -1e9;
    for (const auto& p : polygon.outer) {
      low = std::min(low, u.dot(p));
      high = std::max(high, u.dot(p));
    }
    for (auto piece : pieces) {
      bool any = false;
      for (auto& p : piece.outer) {
        const double x = std::clamp(u.dot(p), low, high);
        any = any || (x > low + 1e-9 && x < high - 1e-9) || std::abs(x - u.dot(p)) < 1e-9;
        p = u * x + v * v.dot(p);
      }
      if (any && ring_area(piece.outer) > 1e-6) kept.push_back(piece);
    }
  }
  s.polygons = kept;
}

void shade(Scanned& scene, std::int32_t id, const Eigen::Vector3d& direction) {
  Surface& s = scene.surfaces.surfaces[static_cast<std::size_t>(id)];
  const Eigen::Vector2d d =
      (s.T_cloud_surface.linear().transpose() * direction.normalized()).head<2>();
  double shadow = 0.0;
  double all = 0.0;
  for (auto& polygon : s.polygons) {
    for (std::size_t i = 0; i < polygon.outer.size(); ++i) {
      const Eigen::Vector2d e = polygon.outer[(i + 1) % polygon.outer.size()] - polygon.outer[i];
      const Eigen::Vector2d outwards(e.y(), -e.x());
      if (outwards.normalized().dot(d) > 0.9) polygon.outer_kind[i] = EdgeKind::occlusion;
      all += e.norm();
      if (polygon.outer_kind[i] == EdgeKind::occlusion) shadow += e.norm();
    }
  }
  s.occluded_outline = shadow / all;
  s.area.at_least = s.rectangle.length.at_least = true;
}

}  // namespace scanchor::test
