#include "perception/outline_samples.hpp"

#include <algorithm>
#include <cmath>

namespace scanchor {
namespace {

/// Marks on the cells of a view that cost nothing to wipe: a cell is marked if it holds the number
/// of the current round.
struct CellMarks {
  std::vector<std::uint32_t> round_of;
  std::uint32_t round = 0;
  void begin(std::size_t cells) {
    if (round_of.size() < cells || round == 0xffffffffU) {
      round_of.assign(cells, 0);
      round = 0;
    }
    ++round;
  }
  bool mark(std::uint32_t cell) {
    if (round_of[cell] == round) return false;
    round_of[cell] = round;
    return true;
  }
};

/// The cells whose rays are looked at one by one: those of the surface that are not deep inside,
/// and then the cells around them.
std::vector<std::uint32_t> cells_at_edge(const ShapeView& view, std::int32_t surface) {
  static thread_local CellMarks marks;
  marks.begin(view.cell_count());
  std::vector<std::uint32_t> cells;
  for (const std::uint32_t cell : view.plane_cells(surface)) {
    marks.mark(cell);
    if (!view.is_deep(cell)) cells.push_back(cell);
  }
  const std::size_t own = cells.size();
  for (std::size_t k = 0; k < own; ++k) {
    for (const std::uint32_t n : view.around(cells[k])) {
      if (marks.mark(n)) cells.push_back(n);
    }
  }
  return cells;
}

/// Axis for the chart: of a few candidates the one from which the inliers lie nearest, so that the
/// projection stretches least.
Eigen::Vector3d chart_axis(const std::vector<Eigen::Vector3d>& directions,
                           const Eigen::Vector3d& towards_plane) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& d : directions) mean += d;
  if (mean.norm() < 1e-6 * static_cast<double>(directions.size())) mean = towards_plane;
  mean.normalize();
  // The bisector helps where a floor is seen all around.
  const Eigen::Vector3d candidates[] = {mean, (mean + towards_plane).normalized(), towards_plane};
  Eigen::Vector3d best = towards_plane;
  double best_cosine = -1.0;
  for (const auto& axis : candidates) {
    double least = 1.0;
    for (const auto& d : directions) least = std::min(least, axis.dot(d));
    if (least > best_cosine) {
      best_cosine = least;
      best = axis;
    }
  }
  return best;
}

}  // namespace

bool SurfaceChart::to_plane(const Eigen::Vector2d& point, Eigen::Vector2d& plane) const {
  const Eigen::Vector3d d = axes.transpose() * Eigen::Vector3d(point.x(), point.y(), 1.0);
  const double t = -sensor.z() / d.z();  // the plane is z = 0
  if (!(t > 0.0) || !std::isfinite(t)) return false;
  plane = sensor.head<2>() + t * d.head<2>();
  return plane.allFinite();
}

OutlineSamples samples_without_view(const FlatPoints& flat,
                                    const Eigen::Isometry3d& T_cloud_plane) {
  OutlineSamples result;
  result.T_cloud_plane = T_cloud_plane;
  result.samples.resize(flat.points.size());
  for (std::size_t i = 0; i < flat.points.size(); ++i) {
    OutlineSample& s = result.samples[i];
    s.chart = s.plane = flat.points[i];
    s.metric = {flat.points[i].x(), flat.points[i].y(), 0.0};
    s.point = flat.order[i];
  }
  return result;  // flat points are sorted already
}

OutlineSamples samples_with_view(const ShapeView& view, const Surface& surface,
                                 const Eigen::Isometry3d& T_cloud_plane, double gate) {
  OutlineSamples result;
  result.with_view = true;
  result.T_cloud_plane = T_cloud_plane;
  const Eigen::Matrix3d R = T_cloud_plane.linear().transpose();
  SurfaceChart& chart = result.chart;
  chart.sensor = R * (view.sensor() - T_cloud_plane.translation());
  const double side =
      chart.sensor.z() >= 0.0 ? 1.0 : -1.0;  // on which side of the plane the sensor stands

  std::vector<OutlineSample> outside;
  std::vector<Eigen::Vector3d> inlier_directions;
  const Eigen::Vector3d origin = T_cloud_plane.translation();
  const auto add = [&](const ShapeRay& ray, bool thinned) {
    const Eigen::Vector3d p = R * (ray.point - origin);
    const Eigen::Vector3d d = p - chart.sensor;
    OutlineSample s;
    s.point = ray.index;
    s.thinned = thinned;
    s.metric = R * ray.direction;
    s.height = side * p.z();
    const double t = -chart.sensor.z() / d.z();  // 1: the point itself lies in the plane
    s.reachable = t > 0.0 && std::isfinite(t);
    if (s.reachable) s.plane = chart.sensor.head<2>() + t * d.head<2>();
    if (ray.plane == surface.id) {
      if (!s.reachable) return;  // an inlier on the sensor's horizon says nothing about the outline
      s.kind = SampleKind::inside;
      inlier_directions.push_back(s.metric);
      result.samples.push_back(s);
      return;
    }
    if (std::abs(p.z()) <= gate) {
      // Of this surface as far as anyone can tell, but not claimed: no evidence either way.
      if (ray.plane < 0) return;
      s.kind = SampleKind::beside;
    } else {
      s.kind = side * p.z() < 0.0 ? SampleKind::passed : SampleKind::blocked;
    }
    outside.push_back(s);
  };
  // Deep inside one ray a cell will do, the smallest by coordinates.
  for (const std::uint32_t cell : view.plane_cells(surface.id)) {
    if (view.is_deep(cell)) add(view.rays(cell).front(), true);
  }
  for (const std::uint32_t cell : cells_at_edge(view, surface.id)) {
    for (const ShapeRay& ray : view.rays(cell)) add(ray, false);
  }
  // Of two rays in one direction the one that met the surface speaks.
  result.samples.insert(result.samples.end(), outside.begin(), outside.end());
  std::vector<OutlineSample>& samples = result.samples;
  if (inlier_directions.empty()) return result;

  const Eigen::Vector3d a = chart_axis(inlier_directions, {0.0, 0.0, -side});
  // e1 x e2 = -a where the sensor looks against the normal, so that counter-clockwise is the same
  // in the chart and in the plane.
  const Eigen::Vector3d helper =
      std::abs(a.x()) < 0.7 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
  const Eigen::Vector3d e1 = (helper - helper.dot(a) * a).normalized();
  const Eigen::Vector3d e2 = -side * a.cross(e1);
  chart.axes.row(0) = e1;
  chart.axes.row(1) = e2;
  chart.axes.row(2) = a;
  constexpr double horizon =
      0.02;  // cosine of about 89 degrees from the axis: beyond it the projection has no room
  std::erase_if(samples, [&](const OutlineSample& s) { return a.dot(s.metric) < horizon; });
  for (OutlineSample& s : samples)
    s.chart = Eigen::Vector2d(e1.dot(s.metric), e2.dot(s.metric)) / a.dot(s.metric);
  return result;
}

}  // namespace scanchor
