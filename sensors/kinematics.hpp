#pragma once
// Where each beam starts, where it points, and where the driver believes it started and pointed.

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "sensors/tilting_lidar.hpp"

namespace scanchor {

/// Columns of one line of a sweep, a row a beam.
struct BeamColumns {
  std::vector<double> origin_x, origin_y, origin_z;
  std::vector<double> direction_x, direction_y, direction_z;
  void resize(std::size_t count);
  [[nodiscard]] Eigen::Vector3d origin(std::size_t k) const {
    return {origin_x[k], origin_y[k], origin_z[k]};
  }
  [[nodiscard]] Eigen::Vector3d direction(std::size_t k) const {
    return {direction_x[k], direction_y[k], direction_z[k]};
  }
};

/// The sensor's motion. sensors.md 1.2 formulas 9 (encoder), 10 (time), 11 (mounting):
///
///     p = T_motion(t) R_tilt(phi(t)) (t_mount + R_scan(beta) (r, 0, 0)^T)
///
/// with phi(t) = phi_0 + omega t. The driver uses the encoder's phi, the known mounting and, if the
/// motion is compensated, the same T_motion. Immutable after construction.
class Kinematics {
 public:
  Kinematics(const LidarOptions& options, std::uint64_t seed);

  /// True beams of a line in the sensor's frame at the start of the sweep.
  void true_beams(int line, BeamColumns& beams) const;
  /// Beams as the driver believes them, same frame. A point is origin + range direction.
  void believed_beams(int line, BeamColumns& beams) const;
  /// Nothing is wrong: both are the same to the bit, and the second need not be computed.
  [[nodiscard]] bool believes_truth() const { return believes_truth_; }

  [[nodiscard]] double time(int line, int beam) const;  ///< [s] since the start of the sweep
  /// [rad] tilt at the start of a line, as it is and as the encoder reads it.
  [[nodiscard]] double true_tilt(int line) const;
  [[nodiscard]] double read_tilt(int line) const;
  /// [rad] of a beam in its line (tilting, spinning).
  [[nodiscard]] double beam_angle(int beam) const;
  /// [sr] of the cell between a beam and its neighbours.
  [[nodiscard]] double solid_angle(int line, int beam) const;
  /// The same for a whole line.
  void solid_angles(int line, std::vector<double>& cells) const;
  /// Tilt speed [rad/s]; 0 where the geometry does not tilt.
  [[nodiscard]] double tilt_speed() const { return tilt_speed_; }
  [[nodiscard]] bool moves() const { return moves_; }
  /// Where beams start, in the tilt unit's frame [m], and by how much the mount turns them [rad].
  [[nodiscard]] Eigen::Vector3d mount_offset() const { return true_mount_.offset; }
  [[nodiscard]] double mount_turn() const;
  /// Pose of the robot at a time, in its frame at the start.
  [[nodiscard]] Eigen::Isometry3d motion(double time) const;

 private:
  struct Mount {
    Eigen::Vector3d offset;
    Eigen::Matrix3d rotation;
  };
  void place(int line, double line_tilt, bool tilt_follows_beam, const Mount& mount, bool motion,
             BeamColumns& beams) const;
  void local_directions(int line, BeamColumns& beams) const;

  LidarOptions options_;
  std::uint64_t seed_;
  Mount true_mount_;
  Mount known_mount_;
  double tilt_speed_ = 0.0;
  double beam_step_ = 0.0;  // [rad]
  double line_step_ = 0.0;  // [rad]
  double beam_time_ = 0.0;  // [s]
  bool tilting_ = true;
  bool moves_ = false;
  bool believes_truth_ = true;
  std::vector<double> beam_cos_, beam_sin_;  // of beam_angle
  std::vector<double> skew_cos_, skew_sin_;  // of the tilt since the start of the line
};

}  // namespace scanchor
