#pragma once
// Where one looks from.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

namespace scanchor {

struct View {
  Eigen::Vector3d eye = Eigen::Vector3d(-5, -5, 4);  ///< [m]
  Eigen::Vector3d target = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();     ///< unit, not along the line of sight
  double vertical_fov_deg = 32.0;                    ///< opening angle; 0: parallel projection
  double parallel_height = 10.0;  ///< [m] seen from top to bottom, for a parallel projection
};

/// Looks at the box from a direction, as near as it stays whole inside the picture. `azimuth_deg`:
/// where the eye stands, counter- clockwise from +x; `elevation_deg`: above the horizon. `aspect`:
/// width / height of the picture; `share` of it to fill.
View perspective_view(const Eigen::AlignedBox3d& box, double azimuth_deg = -122.0,
                      double elevation_deg = 42.0, double aspect = 16.0 / 9.0, double share = 0.94);
/// The same around places instead of a box: nearer, because nothing empty is framed. No place: as
/// an empty box.
View perspective_view(const std::vector<Eigen::Vector3d>& places, double azimuth_deg,
                      double elevation_deg, double aspect, double share);
/// From the sensor's origin along its x axis.
View sensor_view(const Eigen::Isometry3d& T_world_sensor, double vertical_fov_deg = 62.0);
/// Straight down, +y up on the picture; parallel projection.
View top_view(const Eigen::AlignedBox3d& box, double aspect = 16.0 / 9.0, double share = 0.94);
/// Level, from `azimuth_deg`; parallel projection.
View side_view(const Eigen::AlignedBox3d& box, double azimuth_deg = -90.0,
               double aspect = 16.0 / 9.0, double share = 0.94);

/// A view for a picture of a given size, ready to project. The subject may be shifted off the
/// middle, so that a legend beside it takes nothing away (`shift_px`: where the view's centre line
/// meets the picture, relative to its middle).
class Projection {
 public:
  Projection(const View& view, int width, int height, const Eigen::AlignedBox3d& box,
             const Eigen::Vector2d& shift_px = Eigen::Vector2d::Zero());

  /// Clip coordinates as OpenGL wants them, column-major.
  [[nodiscard]] const Eigen::Matrix4d& matrix() const { return matrix_; }
  /// Pixel coordinates (y down) and the distance along the line of sight [m]; negative behind the
  /// eye.
  [[nodiscard]] Eigen::Vector3d pixel(const Eigen::Vector3d& p_world) const;
  /// Pixels a metre at that distance along the line of sight.
  [[nodiscard]] double pixels_per_metre(double distance) const;
  /// Distance along the line of sight [m] of a value of the depth buffer in [0, 1].
  [[nodiscard]] double distance_of_depth(double depth) const;
  [[nodiscard]] const Eigen::Vector3d& eye() const { return eye_; }
  [[nodiscard]] const Eigen::Vector3d& forward() const { return forward_; }
  [[nodiscard]] const Eigen::Vector3d& right() const { return right_; }
  [[nodiscard]] const Eigen::Vector3d& up() const { return up_; }
  [[nodiscard]] bool parallel() const { return parallel_; }
  [[nodiscard]] double near_plane() const { return near_; }
  [[nodiscard]] double far_plane() const { return far_; }

 private:
  Eigen::Matrix4d matrix_;
  Eigen::Vector3d eye_, forward_, right_, up_;
  double width_, height_, near_, far_;
  double focal_px_ = 0.0;  // perspective: pixels a unit of tangent
  double scale_px_ = 0.0;  // parallel: pixels a metre
  bool parallel_;
  Eigen::Vector2d shift_px_;
};

}  // namespace scanchor
