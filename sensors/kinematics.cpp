#include "sensors/kinematics.hpp"

#include <algorithm>
#include <cmath>

#include "core/math.hpp"
#include "core/random.hpp"

namespace scanchor {
namespace {

/// Rotation about x, then y, then z (fixed axes), from portable sines: the same bits everywhere.
Eigen::Matrix3d rotation_rpy(double roll, double pitch, double yaw) {
  const auto [sr, cr] = portable_sincos(roll);
  const auto [sp, cp] = portable_sincos(pitch);
  const auto [sy, cy] = portable_sincos(yaw);
  Eigen::Matrix3d R;
  R << cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr,  //
      sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr,   //
      -sp, cp * sr, cp * cr;
  return R;
}

double round_to(double value, double step) {
  return step > 0.0 ? step * std::floor(value / step + 0.5) : value;
}

}  // namespace

void BeamColumns::resize(std::size_t count) {
  for (auto* column : {&origin_x, &origin_y, &origin_z, &direction_x, &direction_y, &direction_z}) {
    column->resize(count);
  }
}

Kinematics::Kinematics(const LidarOptions& options, std::uint64_t seed)
    : options_(options), seed_(stream_seed(seed, "kinematics")) {
  const LidarOptions& o = options_;
  tilting_ = o.geometry == "tilting";
  const bool camera = o.geometry == "camera";
  // A full turn would measure its first direction twice.
  const int gaps = o.horizontal_deg >= 360.0 ? o.beams_per_line : o.beams_per_line - 1;
  beam_step_ = gaps > 0 ? radians(o.horizontal_deg) / gaps : 0.0;
  line_step_ = o.lines > 1 ? radians(o.vertical_deg) / (o.lines - 1) : 0.0;
  if (!camera && o.beams_per_turn > 0) beam_time_ = 1.0 / (o.lines_per_second * o.beams_per_turn);
  if (tilting_) tilt_speed_ = line_step_ * o.lines_per_second;
  moves_ = o.robot_speed != 0.0 || o.robot_speed_left != 0.0 || o.robot_turn_deg != 0.0;

  const CounterRandom draw(stream_seed(seed, "mount"));
  const auto error = [&](double fixed, double sigma, std::uint64_t axis) {
    return sigma > 0.0 ? fixed + sigma * draw.normal(axis) : fixed;
  };
  known_mount_ = {{o.mount_x, o.mount_y, o.mount_z}, Eigen::Matrix3d::Identity()};
  true_mount_.offset =
      known_mount_.offset + Eigen::Vector3d(error(o.mount_error_x, o.mount_sigma, 0),
                                            error(o.mount_error_y, o.mount_sigma, 1),
                                            error(o.mount_error_z, o.mount_sigma, 2));
  const double angle_sigma = radians(o.mount_angle_sigma_deg);
  true_mount_.rotation = rotation_rpy(error(radians(o.mount_error_roll_deg), angle_sigma, 3),
                                      error(radians(o.mount_error_pitch_deg), angle_sigma, 4),
                                      error(radians(o.mount_error_yaw_deg), angle_sigma, 5));
  const bool mount_right =
      true_mount_.offset == known_mount_.offset && true_mount_.rotation == known_mount_.rotation;
  const bool tilt_right = !tilting_ || (o.encoder_step_deg == 0.0 && o.encoder_sigma_deg == 0.0 &&
                                        o.backlash_deg == 0.0 && o.clock_offset == 0.0 &&
                                        (o.deskew || !o.sweep_moves || beam_time_ == 0.0));
  believes_truth_ = mount_right && tilt_right && (o.motion_compensated || !moves_);

  const auto beams = static_cast<std::size_t>(o.beams_per_line);
  for (std::size_t k = 0; k < beams; ++k) {
    const SinCos beta = portable_sincos(beam_angle(static_cast<int>(k)));
    beam_cos_.push_back(beta.cos);
    beam_sin_.push_back(beta.sin);
    const SinCos skew = portable_sincos(tilt_speed_ * beam_time_ * static_cast<double>(k) *
                                        (o.sweep_moves ? 1 : 0));
    skew_cos_.push_back(skew.cos);
    skew_sin_.push_back(skew.sin);
  }
}

double Kinematics::beam_angle(int beam) const {
  const double half = 0.5 * radians(options_.horizontal_deg);
  return options_.beams_per_line > 1 ? beam_step_ * beam - half : 0.0;
}

double Kinematics::time(int line, int beam) const {
  if (options_.geometry == "camera") return 0.0;
  const double in_line = beam_time_ * beam;
  return tilting_ ? line / options_.lines_per_second + in_line : in_line;
}

double Kinematics::true_tilt(int line) const {
  const double center = radians(options_.tilt_center_deg);
  return options_.lines > 1 ? center + line_step_ * (line - 0.5 * (options_.lines - 1)) : center;
}

double Kinematics::read_tilt(int line) const {
  const LidarOptions& o = options_;
  double tilt = true_tilt(line) + tilt_speed_ * o.clock_offset;
  tilt = round_to(tilt, radians(o.encoder_step_deg));
  if (o.encoder_sigma_deg > 0.0) {
    const CounterRandom noise(stream_seed(seed_, "encoder"));
    tilt += radians(o.encoder_sigma_deg) * noise.normal(static_cast<std::uint64_t>(line));
  }
  return tilt + 0.5 * radians(o.backlash_deg) * (tilt_speed_ < 0.0 ? -1.0 : 1.0);
}

Eigen::Isometry3d Kinematics::motion(double time) const {
  // A constant twist (v_x, v_y, w) for a time t: turn by w t, move by the integral of the turning
  // velocity.
  const double turn = radians(options_.robot_turn_deg) * time;
  const auto [s, c] = portable_sincos(turn);
  double a = 1.0 - turn * turn / 6.0;            // sin(turn) / turn
  double b = turn * (0.5 - turn * turn / 24.0);  // (1 - cos(turn)) / turn
  if (std::fabs(turn) > 1e-4) {
    a = s / turn;
    b = (1.0 - c) / turn;
  }
  const double x = options_.robot_speed * time;
  const double y = options_.robot_speed_left * time;
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() << c, -s, 0, s, c, 0, 0, 0, 1;
  T.translation() = Eigen::Vector3d(a * x - b * y, b * x + a * y, 0.0);
  return T;
}

double Kinematics::solid_angle(int line, int beam) const {
  const auto k = static_cast<std::size_t>(beam);
  const double line_step = options_.lines > 1 ? line_step_ : beam_step_;
  if (options_.geometry == "camera") {
    const double half_u = portable_sincos(0.5 * radians(options_.horizontal_deg)).sin /
                          portable_sincos(0.5 * radians(options_.horizontal_deg)).cos;
    const double half_v = portable_sincos(0.5 * radians(options_.vertical_deg)).sin /
                          portable_sincos(0.5 * radians(options_.vertical_deg)).cos;
    const double u = half_u * (2.0 * (beam + 0.5) / options_.beams_per_line - 1.0);
    const double v = half_v * (2.0 * (line + 0.5) / options_.lines - 1.0);
    const double cell = 4.0 * half_u * half_v / (options_.beams_per_line * double(options_.lines));
    const double secant = std::sqrt(1.0 + u * u + v * v);
    return cell / (secant * secant * secant);
  }
  if (!tilting_) return beam_step_ * line_step * portable_sincos(true_tilt(line)).cos;
  return beam_step_ * line_step * std::fabs(beam_cos_[k]);
}

void Kinematics::solid_angles(int line, std::vector<double>& cells) const {
  const auto count = static_cast<std::size_t>(options_.beams_per_line);
  if (tilting_ && cells.size() == count) return;  // the same for every line
  cells.resize(count);
  for (std::size_t k = 0; k < count; ++k) cells[k] = solid_angle(line, static_cast<int>(k));
}

void Kinematics::local_directions(int line, BeamColumns& beams) const {
  const auto count = static_cast<std::size_t>(options_.beams_per_line);
  beams.resize(count);
  if (tilting_) {
    beams.direction_x = beam_cos_;
    beams.direction_y = beam_sin_;
    beams.direction_z.assign(count, 0.0);
  } else if (options_.geometry == "spinning") {
    const auto [s, c] = portable_sincos(true_tilt(line));
    for (std::size_t k = 0; k < count; ++k) {
      beams.direction_x[k] = c * beam_cos_[k];
      beams.direction_y[k] = c * beam_sin_[k];
      beams.direction_z[k] = s;
    }
  } else {
    const SinCos h = portable_sincos(0.5 * radians(options_.horizontal_deg));
    const SinCos v = portable_sincos(0.5 * radians(options_.vertical_deg));
    const double up = -(v.sin / v.cos) * (2.0 * (line + 0.5) / options_.lines - 1.0);
    for (std::size_t k = 0; k < count; ++k) {
      const double left =
          -(h.sin / h.cos) * (2.0 * (static_cast<double>(k) + 0.5) / options_.beams_per_line - 1.0);
      const double norm = std::sqrt(1.0 + left * left + up * up);
      beams.direction_x[k] = 1.0 / norm;
      beams.direction_y[k] = left / norm;
      beams.direction_z[k] = up / norm;
    }
  }
}

void Kinematics::place(int line, double line_tilt, bool tilt_follows_beam, const Mount& mount,
                       bool motion, BeamColumns& beams) const {
  local_directions(line, beams);
  const auto count = static_cast<std::size_t>(options_.beams_per_line);
  const bool turned = !(mount.rotation == Eigen::Matrix3d::Identity());
  // A spinning scanner's elevation is in its directions already.
  const auto [line_sin, line_cos] =
      options_.geometry == "spinning" ? SinCos{0.0, 1.0} : portable_sincos(line_tilt);
  if (turned) {
    for (std::size_t k = 0; k < count; ++k) {
      const Eigen::Vector3d d = mount.rotation * beams.direction(k);
      beams.direction_x[k] = d.x(), beams.direction_y[k] = d.y(), beams.direction_z[k] = d.z();
    }
  }
  // A positive tilt looks up: it turns x towards z. Plain pointers and no calls, so that the
  // compiler can use vectors.
  double* dx = beams.direction_x.data();
  double* dz = beams.direction_z.data();
  double* ox = beams.origin_x.data();
  double* oz = beams.origin_z.data();
  const double mx = mount.offset.x(), mz = mount.offset.z();
  const double* skew_cos = skew_cos_.data();
  const double* skew_sin = skew_sin_.data();
  const double ls = line_sin, lc = line_cos;
  std::fill(beams.origin_y.begin(), beams.origin_y.end(), mount.offset.y());
  for (std::size_t k = 0; k < count; ++k) {
    const double c = tilt_follows_beam ? lc * skew_cos[k] - ls * skew_sin[k] : lc;
    const double s = tilt_follows_beam ? ls * skew_cos[k] + lc * skew_sin[k] : ls;
    const double x = dx[k], z = dz[k];
    dx[k] = c * x - s * z;
    dz[k] = s * x + c * z;
    ox[k] = c * mx - s * mz;
    oz[k] = s * mx + c * mz;
  }
  if (!motion) return;
  for (std::size_t k = 0; k < count; ++k) {
    const Eigen::Isometry3d T = this->motion(time(line, static_cast<int>(k)));
    const Eigen::Vector3d o = T * beams.origin(k);
    const Eigen::Vector3d d = T.linear() * beams.direction(k);
    beams.origin_x[k] = o.x(), beams.origin_y[k] = o.y(), beams.origin_z[k] = o.z();
    beams.direction_x[k] = d.x(), beams.direction_y[k] = d.y(), beams.direction_z[k] = d.z();
  }
}

double Kinematics::mount_turn() const {
  // |R - I| in the Frobenius norm is sqrt(8) sin(angle / 2).
  return (true_mount_.rotation - Eigen::Matrix3d::Identity()).norm();
}

void Kinematics::true_beams(int line, BeamColumns& beams) const {
  // A camera looks along the middle of its "sweep" with all its lines.
  const double tilt =
      options_.geometry == "camera" ? radians(options_.tilt_center_deg) : true_tilt(line);
  place(line, tilt, tilting_, true_mount_, moves_, beams);
}

void Kinematics::believed_beams(int line, BeamColumns& beams) const {
  const double tilt =
      options_.geometry == "camera" ? radians(options_.tilt_center_deg) : read_tilt(line);
  place(line, tilt, tilting_ && options_.deskew, known_mount_,
        moves_ && options_.motion_compensated, beams);
}

}  // namespace scanchor
