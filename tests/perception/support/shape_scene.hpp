#pragma once
// A small world of flat polygons and a polar scanner, so that the tests of shapes know every truth
// exactly and need no other room.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "cloud/point_cloud.hpp"
#include "perception/surface.hpp"

namespace scanchor::testing {

/// A flat polygon in the world: outline and holes in the frame of T (z = 0).
struct Panel {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  Ring outer;
  std::vector<Ring> holes;
};

/// Counter-clockwise rectangle about the origin.
Ring box_ring(double length, double width);
Panel box_panel(const Eigen::Vector3d& center, const Eigen::Vector3d& x_axis,
                const Eigen::Vector3d& y_axis, double length, double width);

struct ScannerSetup {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  double azimuth_from_deg = -90, azimuth_to_deg = 90;
  double elevation_from_deg = -60, elevation_to_deg = 30;
  int beams = 500, lines = 200;
  double jitter = 0.0;       ///< of each direction, in steps, normal
  double range_sigma = 0.0;  ///< [m]
  std::uint64_t seed = 1;
};

/// Nearest panel along a ray, -1: none.
int trace(const std::vector<Panel>& panels, const Eigen::Vector3d& origin,
          const Eigen::Vector3d& direction, double& range);

struct ShapeScan {
  PointCloud cloud;
  Surfaces surfaces;  ///< planes fitted to the points of each panel; by falling number of inliers
  std::vector<int> panel_of_surface;  ///< which panel each surface is
};

/// Scans the panels. Panels with fewer than `minimum` points make no surface.
ShapeScan scan_panels(const std::vector<Panel>& panels, const ScannerSetup& setup,
                      std::size_t minimum = 12);

/// Surfaces from points with known labels (-1: none): plane by principal axes, frame as find_planes
/// makes it, sorted. `sensor`: nullptr if unknown.
ShapeScan surfaces_from_labels(PointCloud cloud, const std::vector<int>& label,
                               const Eigen::Vector3d* sensor, double sigma,
                               std::size_t minimum = 12);

/// One surface of points in the plane z = 0, no sensor known.
ShapeScan flat_scan(const std::vector<Eigen::Vector2d>& points);

/// Lattice of points inside a panel's outline (T ignored): spacing, turned by `angle`, phase and
/// jitter from the seed.
std::vector<Eigen::Vector2d> lattice_in(const Panel& panel, double spacing_x, double spacing_y,
                                        double angle, double jitter, std::uint64_t seed);

/// The cloud in another order, labels moved along: entry i of the result is point order[i].
ShapeScan permuted(const ShapeScan& scan, const std::vector<std::uint32_t>& order);

}  // namespace scanchor::testing
