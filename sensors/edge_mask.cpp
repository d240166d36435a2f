#include "sensors/edge_mask.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/math.hpp"
#include "core/parallel.hpp"

namespace scanchor {
namespace {

/// The grid of beams as angles. Nothing here decides bytes, only how much is traced: libm will do.
class Grid {
 public:
  Grid(const LidarOptions& options, const Kinematics& kinematics, std::vector<std::uint8_t>& mask)
      : o_(options), mask_(mask) {
    camera_ = o_.geometry == "camera";
    tilting_ = o_.geometry == "tilting";
    beam_first_ = kinematics.beam_angle(0);
    const int gaps = o_.horizontal_deg >= 360.0 ? o_.beams_per_line : o_.beams_per_line - 1;
    beam_step_ = std::max(radians(o_.horizontal_deg) / std::max(gaps, 1), 1e-9);
    line_first_ = kinematics.true_tilt(0);
    line_step_ = std::max(radians(o_.vertical_deg) / std::max(o_.lines - 1, 1), 1e-9);
    if (camera_) {
      half_u_ = std::tan(0.5 * radians(o_.horizontal_deg));
      half_v_ = std::tan(0.5 * radians(o_.vertical_deg));
    }
    // While a line is measured the tilt moves on by at most one line.
    if (tilting_ && o_.sweep_moves && o_.beams_per_turn > 0) {
      skew_lines_ = static_cast<double>(o_.beams_per_line) / o_.beams_per_turn;
    }
  }

  /// Smaller of the steps between beams and between lines.
  [[nodiscard]] double cell() const {
    if (camera_) {
      return 2.0 * std::min(half_u_ / o_.beams_per_line, half_v_ / o_.lines);
    }
    return std::min(beam_step_, line_step_);
  }

  /// Marks all beams whose direction is within an angle of p (sensor frame).
  void mark(const Eigen::Vector3d& p, double angle) {
    const double range = p.norm();
    if (angle > 0.7) {
      mark_cells(0, o_.lines - 1, 0, o_.beams_per_line - 1);
    } else if (camera_) {
      mark_camera(p, angle);
    } else if (tilting_) {
      const double beta = std::asin(std::clamp(p.y() / range, -1.0, 1.0));
      const double phi = std::atan2(p.z(), p.x());
      // The same direction once more, over the pole: opening angles above 180 degrees look
      // backwards.
      mark_angles(beta, phi, angle);
      mark_angles(beta > 0 ? pi - beta : -pi - beta, phi > 0 ? phi - pi : phi + pi, angle);
    } else {
      mark_spinning(p, range, angle);
    }
  }

  /// The same around a beam.
  void mark_near(int line, int beam, double angle) {
    if (camera_) {
      const double u = half_u_ * (2.0 * (beam + 0.5) / o_.beams_per_line - 1.0);
      const double v = half_v_ * (2.0 * (line + 0.5) / o_.lines - 1.0);
      const double stretch = angle * (1.0 + u * u + v * v);
      const double width = 0.5 * stretch / half_u_ * o_.beams_per_line;
      const double height = 0.5 * stretch / half_v_ * o_.lines;
      mark_cells(down(line - height), up(line + height), down(beam - width), up(beam + width));
      return;
    }
    const double across = beam_first_ + beam * beam_step_;
    const double up_angle = line_first_ + line * line_step_;
    const double cosine = std::fabs(std::cos(tilting_ ? across : up_angle)) - angle;
    const double narrow = cosine > angle / pi ? angle / cosine : 1e6;
    const double width = (tilting_ ? angle : narrow) / beam_step_;
    const double height = (tilting_ ? narrow : angle) / line_step_;
    mark_cells(down(line - height - skew_lines_), up(line + height + skew_lines_),
               down(beam - width), up(beam + width));
  }

  void mark_cells(int line_low, int line_high, int beam_low, int beam_high) {
    line_low = std::max(line_low, 0);
    line_high = std::min(line_high, o_.lines - 1);
    beam_low = std::max(beam_low, 0);
    beam_high = std::min(beam_high, o_.beams_per_line - 1);
    for (int n = line_low; n <= line_high; ++n) {
      for (int k = beam_low; k <= beam_high; ++k) {
        const auto cell =
            static_cast<std::size_t>(n) * static_cast<std::size_t>(o_.beams_per_line) +
            static_cast<std::size_t>(k);
        std::atomic_ref(mask_[cell]).store(1, std::memory_order_relaxed);
      }
    }
  }

 private:
  static int down(double x) { return static_cast<int>(std::floor(std::clamp(x, -1e6, 1e6))); }
  static int up(double x) { return static_cast<int>(std::ceil(std::clamp(x, -1e6, 1e6))); }

  void mark_angles(double beta, double phi, double angle) {
    const double beam = (beta - beam_first_) / beam_step_;
    const double width = angle / beam_step_;
    // Near the poles of the tilt axis all lines come together.
    const double nearest_pole = std::fabs(std::cos(beta)) - angle;
    const double height = nearest_pole > angle / pi ? angle / (nearest_pole * line_step_) : 1e6;
    for (const double turn : {-2.0 * pi, 0.0, 2.0 * pi}) {
      const double line = (phi + turn - line_first_) / line_step_;
      mark_cells(down(line - height - skew_lines_), up(line + height), down(beam - width),
                 up(beam + width));
    }
  }

  void mark_spinning(const Eigen::Vector3d& p, double range, double angle) {
    const double elevation = std::asin(std::clamp(p.z() / range, -1.0, 1.0));
    const double azimuth = std::atan2(p.y(), p.x());
    const double line = (elevation - line_first_) / line_step_;
    const double height = angle / line_step_;
    const double nearest_pole = std::cos(elevation) - angle;
    const double width = nearest_pole > angle / pi ? angle / (nearest_pole * beam_step_) : 1e6;
    for (const double turn : {-2.0 * pi, 0.0, 2.0 * pi}) {
      const double beam = (azimuth + turn - beam_first_) / beam_step_;
      mark_cells(down(line - height), up(line + height), down(beam - width), up(beam + width));
    }
  }

  void mark_camera(const Eigen::Vector3d& p, double angle) {
    const double tilt = radians(o_.tilt_center_deg);
    const double x = std::cos(tilt) * p.x() + std::sin(tilt) * p.z();
    const double z = -std::sin(tilt) * p.x() + std::cos(tilt) * p.z();
    if (x < 0.2 * p.norm()) return;  // farther than any opening below 157 degrees
    const double u = -p.y() / x, v = -z / x;
    const double stretch = angle * (1.0 + u * u + v * v);  // d tan = (1 + tan^2) d angle
    const double beam = 0.5 * (u / half_u_ + 1.0) * o_.beams_per_line - 0.5;
    const double line = 0.5 * (v / half_v_ + 1.0) * o_.lines - 0.5;
    const double width = 0.5 * stretch / half_u_ * o_.beams_per_line;
    const double height = 0.5 * stretch / half_v_ * o_.lines;
    mark_cells(down(line - height), up(line + height), down(beam - width), up(beam + width));
  }

  const LidarOptions& o_;
  std::vector<std::uint8_t>& mask_;
  bool camera_ = false, tilting_ = false;
  double beam_first_, beam_step_, line_first_, line_step_;
  double half_u_ = 1.0, half_v_ = 1.0;
  double skew_lines_ = 0.0;
};

}  // namespace

std::vector<std::uint8_t> straddling_beams(const World& world,
                                           const Eigen::Isometry3d& T_world_sensor,
                                           const LidarOptions& options,
                                           const Kinematics& kinematics, double reach,
                                           std::span<const LineReturns> lines) {
  const auto beams = static_cast<std::size_t>(options.beams_per_line);
  if (options.subrays_everywhere || kinematics.moves()) {
    return std::vector<std::uint8_t>(lines.size() * beams, 1);
  }
  std::vector<std::uint8_t> mask(lines.size() * beams, 0);
  Grid grid(options, kinematics, mask);
  // Beams start up to this far from the sensor's origin, and point up to this far from where a
  // perfect mount would.
  const Eigen::Vector3d off = kinematics.mount_offset();
  const double parallax = off.norm();
  const double turned = kinematics.mount_turn();
  const double half_step = 0.5 * grid.cell();
  const Eigen::Isometry3d T_sensor_world = T_world_sensor.inverse();
  const auto& outline = world.outline();
  const auto radius_at = [&](double range) {
    return reach * 0.5 * (options.divergence + options.aperture / range) + parallax / range +
           turned;
  };
  // Drawing the outlines costs its steps, tracing all costs its sub-rays: a step costs about as
  // much as three (measured; docs/why/speed.md).
  double steps = 0.0;
  for (const FaceEdge& edge : outline) {
    const Eigen::Vector3d from = T_sensor_world * edge.from;
    const Eigen::Vector3d to = T_sensor_world * edge.to;
    const double angle = std::atan2(from.cross(to).norm(), from.dot(to));
    steps += 1.0 + angle / std::max(half_step, 0.5 * radius_at(std::max(from.norm(), 1e-6)));
  }
  if (3.0 * steps > static_cast<double>(mask.size()) * options.subrays) {
    std::fill(mask.begin(), mask.end(), std::uint8_t{1});
    return mask;
  }
  parallel_blocks(outline.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      const Eigen::Vector3d from = T_sensor_world * outline[e].from;
      const Eigen::Vector3d to = T_sensor_world * outline[e].to;
      const double length = (to - from).norm();
      double s = 0.0;
      while (true) {
        const Eigen::Vector3d p =
            length > 0.0 ? Eigen::Vector3d(from + (s / length) * (to - from)) : from;
        const double range = std::max(p.norm(), 1e-6);
        const double radius = radius_at(range);
        const double step = std::max(half_step, 0.5 * radius);
        // 1.5: the arc of the step is longer than half its chord says when the range changes along
        // it.
        grid.mark(p, radius + 1.5 * step);
        if (s >= length) break;
        s = std::min(length, s + std::max(step * range, 1e-4));
      }
    }
  });

  // Creases: neighbours that met different faces.
  const auto face = [&](std::size_t n, std::size_t k) {
    const std::uint32_t t = lines[n].triangle[k];
    return t == no_hit ? -1 : world.triangles()[t].face;
  };
  const auto range = [&](std::size_t n, std::size_t k) {
    return lines[n].triangle[k] == no_hit ? options.maximum_range : lines[n].range[k];
  };
  const auto around = [&](std::size_t n, std::size_t k) {
    const double r = std::max(range(n, k), 1e-3);
    const double radius =
        reach * 0.5 * (options.divergence + options.aperture / r) + 2.0 * half_step;
    const int line = static_cast<int>(n), beam = static_cast<int>(k);
    grid.mark_near(line, beam, radius + 2.0 * half_step);
    grid.mark_cells(line - 1, line + 1, beam - 1, beam + 1);
  };
  parallel_blocks(lines.size(), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      for (std::size_t k = 0; k < beams; ++k) {
        const std::int32_t here = face(n, k);
        const bool right = k + 1 < beams && face(n, k + 1) != here;
        const bool above = n + 1 < lines.size() && face(n + 1, k) != here;
        if (!right && !above) continue;
        around(n, k);
        if (right) around(n, k + 1);
        if (above) around(n + 1, k);
      }
    }
  });
  return mask;
}

}  // namespace scanchor
