#pragma once
// The tilting LIDAR: a line scanner on a tilt unit. Every effect has its own switch or scale; all
// formulas and sources are in docs/reference/sensors.md.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/options.hpp"
#include "sensors/scan.hpp"
#include "sim/world.hpp"

namespace scanchor {

/// A device and its faults. The defaults are a perfect instrument with 1 cm of range noise; a scale
/// of 0 switches an effect off.
struct LidarOptions {
  std::string preset = "paper";  ///< the device the numbers came from
  // Geometry
  std::string geometry =
      "tilting";  ///< "tilting" line scanner, "spinning" channels, "camera" with one pixel a beam
  double horizontal_deg = 180.0;  ///< opening angle of a line
  double vertical_deg =
      90.0;  ///< tilt sweep (channels of a spinning scanner, height of a camera's view)
  double tilt_center_deg = -15.0;  ///< middle of the sweep; negative looks down
  int beams_per_line = 500;
  int lines = 200;
  double minimum_range = 0.1;   ///< [m] nearer returns are lost
  double maximum_range = 30.0;  ///< [m] farther returns are lost
  bool report_maximum =
      false;  ///< a beam without return gives a point at maximum_range, flagged point_out_of_range
  // Time: beam k of line n is measured at n / lines_per_second + k / (lines_per_second
  // beams_per_turn) (sensors.md 1.2 formula 10)
  double lines_per_second = 40.0;  ///< [1/s] turns of the mirror
  int beams_per_turn = 1000;       ///< of a full turn of the mirror; 0: a whole line at one time
  bool sweep_moves =
      true;            ///< the tilt moves while a line is measured; false: it stops for every line
  bool deskew = true;  ///< the driver gives each beam its own tilt; false: one angle a line, planes
                       ///< become screws
  double clock_offset = 0.0;  ///< [s] the driver looks the tilt up this much too late
  // The robot drives while it scans
  double robot_speed = 0.0;       ///< [m/s] along x
  double robot_speed_left = 0.0;  ///< [m/s] along y
  double robot_turn_deg = 0.0;    ///< [deg/s] about z
  bool motion_compensated =
      true;  ///< perfect odometry undoes the motion; false: the scan is smeared
  // Mounting of the scanner on the tilt unit (formula 11): known offset, and what is wrong about it
  double mount_x = 0.0, mount_y = 0.0, mount_z = 0.0;  ///< [m] known
  double mount_error_x = 0.0, mount_error_y = 0.0,
         mount_error_z = 0.0;  ///< [m] unknown to the driver
  double mount_error_roll_deg = 0.0, mount_error_pitch_deg = 0.0, mount_error_yaw_deg = 0.0;
  double mount_sigma = 0.0;            ///< [m] further error, drawn once a scan, each axis
  double mount_angle_sigma_deg = 0.0;  ///< further error, drawn once a scan, each axis
  // Tilt encoder (formula 9)
  double encoder_step_deg = 0.0;   ///< quantum of the angle
  double encoder_sigma_deg = 0.0;  ///< standard deviation, drawn once a line
  double backlash_deg = 0.0;       ///< half of it, in the direction of motion, is missed
  // Range noise: sigma^2 = max(range_sigma, range_slope r + range_offset)^2 + snr^2 (formulas 4 and
  // 3)
  double range_sigma = 0.01;     ///< [m] standard deviation of the range, at any range
  double range_slope = 0.0;      ///< [m/m]
  double range_offset = 0.0;     ///< [m]
  double snr_sigma = 0.0;        ///< [m] at snr_range, snr_reflectance and normal incidence; 0: off
  double snr_exponent = 1.0;     ///< 1: electronics limited, 0.5: shot limited
  double snr_range = 10.0;       ///< [m]
  double snr_reflectance = 0.8;  ///< [0, 1]
  double spread_noise =
      0.0;  ///< [0, 1] share of the range spread inside the footprint, (D/4) tan a, that is noise
  double drift_sigma = 0.0;  ///< [m] warm-up: one offset a scan (formula 13)
  double wiggle = 0.0;  ///< [m] amplitude of the fourth harmonic of a phase camera (formula 12)
  double range_quantum = 0.0;  ///< [m] ranges are multiples of it (formula 8)
  // Footprint: D(R) = aperture + divergence R (formula 1)
  double divergence = 0.0;          ///< [rad] full angle
  double aperture = 0.0;            ///< [m] diameter at the scanner
  std::string profile = "uniform";  ///< "uniform" disc or "gaussian" with 1/e^2 diameter D
  int subrays = 1;                  ///< rays that sample the footprint; 1: the centre alone
  bool subrays_everywhere =
      false;  ///< also where no edge is near; the bytes are the same, it only takes longer
  // Echoes of a footprint on several surfaces (formula 5)
  std::string echo =
      "strongest";  ///< "first", "strongest", "last" of a pulse, or "phase" of a modulated beam
  double pulse_width = 5e-9;           ///< [s] echoes nearer than c tau / 2 run together
  double echo_share = 0.02;            ///< [0, 1] of the strongest echo: weaker ones are not seen
  double modulation_frequency = 20e6;  ///< [Hz] of "phase"; ranges are modulo c / 2f
  // Detection (formulas 2 and 6)
  double detection_range =
      0.0;  ///< [m] where half of the returns of detection_reflectance come back; 0: all come back
  double detection_reflectance = 0.1;  ///< [0, 1] at normal incidence
  double detection_db = 1.5;           ///< [dB] softness of the limit
  double loss = 0.0;                   ///< [0, 1] share of returns lost for no reason
  // Glass and mirrors (formula 7)
  bool glass = true;       ///< beams go through what transmits
  bool mirrors = true;     ///< beams go on from what mirrors: ghosts
  double glass_f0 = 0.04;  ///< Fresnel reflectance of a pane at normal incidence
  int bounces = 4;         ///< at most so many passages and reflections a beam

  void describe(OptionList& list);
};

/// Names of the presets: "paper", "utm-30lx", ...
const std::vector<std::string>& lidar_presets();
/// Options of a preset. Throws Error(wrong_usage) for an unknown name.
LidarOptions lidar_preset(const std::string& name);
/// A device from a YAML file: a map of option names to values, `preset` first where one is the
/// base. Throws Error(bad_data) with file, line and, for an unknown name, the one that was meant.
LidarOptions read_lidar_options(const std::filesystem::path& path);
/// Throws Error(wrong_usage) where the options contradict each other ("minimum_range above
/// maximum_range").
void check_lidar_options(const LidarOptions& options);

/// One sweep from a pose (x forward, y left, z up). Deterministic: the same world, pose, options
/// and seed give the same bytes for any number of threads, packet width or instruction set.
Scan scan_room(const World& world, const Eigen::Isometry3d& T_world_sensor,
               const LidarOptions& options, std::uint64_t seed);
/// The same into a scan whose memory is used again: for thousands of scans in a row.
void scan_room_into(const World& world, const Eigen::Isometry3d& T_world_sensor,
                    const LidarOptions& options, std::uint64_t seed, Scan& scan);

}  // namespace scanchor
