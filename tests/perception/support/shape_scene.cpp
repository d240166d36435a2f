#include "tests/perception/support/shape_scene.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/math.hpp"
#include "core/random.hpp"
#include "perception/polygon_check.hpp"

namespace scanchor::testing {
namespace {

bool inside_panel(const Panel& panel, const Eigen::Vector2d& p) {
  if (!contains(panel.outer, p)) return false;
  return std::none_of(panel.holes.begin(), panel.holes.end(),
                      [&](const Ring& hole) { return contains(hole, p); });
}

}  // namespace

Ring box_ring(double length, double width) {
  const double x = 0.5 * length;
  const double y = 0.5 * width;
  return {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
}

Panel box_panel(const Eigen::Vector3d& center, const Eigen::Vector3d& x_axis,
                const Eigen::Vector3d& y_axis, double length, double width) {
  Panel panel;
  panel.T.translation() = center;
  panel.T.linear().col(0) = x_axis.normalized();
  panel.T.linear().col(1) =
      (y_axis - y_axis.dot(x_axis.normalized()) * x_axis.normalized()).normalized();
  panel.T.linear().col(2) = panel.T.linear().col(0).cross(panel.T.linear().col(1));
  panel.outer = box_ring(length, width);
  return panel;
}

int trace(const std::vector<Panel>& panels, const Eigen::Vector3d& origin,
          const Eigen::Vector3d& direction, double& range) {
  int best = -1;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const Panel& panel = panels[i];
    const Eigen::Vector3d normal = panel.T.linear().col(2);
    const double along = normal.dot(direction);
    if (along == 0.0) continue;
    const double t = normal.dot(panel.T.translation() - origin) / along;
    if (t <= 1e-3 || (best >= 0 && t >= range)) continue;
    const Eigen::Vector3d local =
        panel.T.linear().transpose() * (origin + t * direction - panel.T.translation());
    if (!inside_panel(panel, local.head<2>())) continue;
    best = static_cast<int>(i);
    range = t;
  }
  return best;
}

ShapeScan surfaces_from_labels(PointCloud cloud, const std::vector<int>& label,
                               const Eigen::Vector3d* sensor, double sigma, std::size_t minimum) {
  ShapeScan scan;
  scan.cloud = std::move(cloud);
  scan.surfaces.noise_sigma = sigma;
  scan.surfaces.plane_of_point.assign(label.size(), -1);
  if (sensor != nullptr) {
    scan.surfaces.sensor_positions = {*sensor};
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation() = *sensor;
    scan.cloud.sensor_poses = {pose};
  }
  const int count = label.empty() ? 0 : *std::max_element(label.begin(), label.end()) + 1;
  std::vector<std::vector<std::uint32_t>> members(static_cast<std::size_t>(count));
  for (std::uint32_t i = 0; i < label.size(); ++i) {
    if (label[i] >= 0) members[static_cast<std::size_t>(label[i])].push_back(i);
  }
  std::vector<int> order;
  for (int i = 0; i < count; ++i) {
    if (members[static_cast<std::size_t>(i)].size() >= minimum) order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return members[static_cast<std::size_t>(a)].size() >
           members[static_cast<std::size_t>(b)].size();
  });
  for (const int panel : order) {
    Surface s;
    s.id = static_cast<std::int32_t>(scan.surfaces.surfaces.size());
    s.inliers = members[static_cast<std::size_t>(panel)];
    // Sums in an order that the points themselves give: permuted clouds give the same bits.
    std::vector<Eigen::Vector3d> sorted;
    for (const auto i : s.inliers) sorted.push_back(scan.cloud.points[i]);
    std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
      return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
    });
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const auto& p : sorted) mean += p;
    const auto n = static_cast<double>(sorted.size());
    mean /= n;
    Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
    for (const auto& p : sorted) moments += (p - mean) * (p - mean).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments / n);
    const Eigen::Matrix3d axes = solver.eigenvectors();
    Eigen::Vector3d normal = axes.col(0);
    if (sensor != nullptr && normal.dot(*sensor - mean) < 0.0) normal = -normal;
    if (sensor == nullptr && normal.z() < 0.0) normal = -normal;
    const Eigen::Vector3d values = solver.eigenvalues().cwiseMax(0.0);
    s.plane.normal = normal;
    s.plane.offset = normal.dot(mean);
    s.plane.centroid = mean;
    s.plane.residual_sigma = std::sqrt(values[0]);
    s.plane.normal_covariance = values[0] / n *
                                (axes.col(1) * axes.col(1).transpose() / values[1] +
                                 axes.col(2) * axes.col(2).transpose() / values[2]);
    s.plane.centroid_sigma = std::sqrt(values[0] / n);
    s.T_cloud_surface.translation() = mean;
    s.T_cloud_surface.linear().col(0) = axes.col(2);
    s.T_cloud_surface.linear().col(1) = normal.cross(axes.col(2));
    s.T_cloud_surface.linear().col(2) = normal;
    for (const auto i : s.inliers) scan.surfaces.plane_of_point[i] = s.id;
    scan.surfaces.surfaces.push_back(std::move(s));
    scan.panel_of_surface.push_back(panel);
  }
  return scan;
}

ShapeScan scan_panels(const std::vector<Panel>& panels, const ScannerSetup& setup,
                      std::size_t minimum) {
  const CounterRandom noise(stream_seed(setup.seed, "scan"));
  PointCloud cloud;
  std::vector<int> label;
  const double da = (setup.azimuth_to_deg - setup.azimuth_from_deg) / setup.beams;
  const double de = (setup.elevation_to_deg - setup.elevation_from_deg) / setup.lines;
  for (int line = 0; line < setup.lines; ++line) {
    for (int beam = 0; beam < setup.beams; ++beam) {
      const auto id = static_cast<std::uint64_t>(line) * static_cast<std::uint64_t>(setup.beams) +
                      static_cast<std::uint64_t>(beam);
      const double a =
          radians(setup.azimuth_from_deg + da * (beam + 0.5 + setup.jitter * noise.normal(id, 1)));
      const double e = radians(setup.elevation_from_deg +
                               de * (line + 0.5 + setup.jitter * noise.normal(id, 2)));
      const Eigen::Vector3d direction(std::cos(e) * std::cos(a), std::cos(e) * std::sin(a),
                                      std::sin(e));
      double range = 0.0;
      const int panel = trace(panels, setup.position, direction, range);
      if (panel < 0) continue;
      range += setup.range_sigma * noise.normal(id, 3);
      cloud.points.push_back(setup.position + range * direction);
      label.push_back(panel);
    }
  }
  return surfaces_from_labels(std::move(cloud), label, &setup.position, setup.range_sigma, minimum);
}

ShapeScan flat_scan(const std::vector<Eigen::Vector2d>& points) {
  PointCloud cloud;
  for (const auto& p : points) cloud.points.emplace_back(p.x(), p.y(), 0.0);
  return surfaces_from_labels(std::move(cloud), std::vector<int>(points.size(), 0), nullptr, 0.0,
                              1);
}

std::vector<Eigen::Vector2d> lattice_in(const Panel& panel, double spacing_x, double spacing_y,
                                        double angle, double jitter, std::uint64_t seed) {
  SequentialRandom random(seed);
  const double phase_x = random.uniform();
  const double phase_y = random.uniform();
  double reach = 0.0;
  for (const auto& p : panel.outer) reach = std::max(reach, p.norm());
  const int nx = static_cast<int>(reach / spacing_x) + 2;
  const int ny = static_cast<int>(reach / spacing_y) + 2;
  std::vector<Eigen::Vector2d> points;
  for (int j = -ny; j <= ny; ++j) {
    for (int i = -nx; i <= nx; ++i) {
      const double x = (i + phase_x + jitter * random.normal()) * spacing_x;
      const double y = (j + phase_y + jitter * random.normal()) * spacing_y;
      const Eigen::Vector2d p(std::cos(angle) * x - std::sin(angle) * y,
                              std::sin(angle) * x + std::cos(angle) * y);
      if (inside_panel(panel, p)) points.push_back(p);
    }
  }
  return points;
}

ShapeScan permuted(const ShapeScan& scan, const std::vector<std::uint32_t>& order) {
  PointCloud cloud;
  std::vector<int> label;
  for (const auto i : order) {
    cloud.points.push_back(scan.cloud.points[i]);
    const auto s = scan.surfaces.plane_of_point[i];
    label.push_back(s < 0 ? -1 : s);
  }
  const bool seen = !scan.surfaces.sensor_positions.empty();
  ShapeScan result = surfaces_from_labels(std::move(cloud), label,
                                          seen ? &scan.surfaces.sensor_positions.front() : nullptr,
                                          scan.surfaces.noise_sigma, 1);
  for (int& panel : result.panel_of_surface)
    panel = scan.panel_of_surface[static_cast<std::size_t>(panel)];
  return result;
}

}  // namespace scanchor::testing
