#include "core/error.hpp"
#include "sensors/tilting_lidar.hpp"

namespace scanchor {

void LidarOptions::describe(OptionList& list) {
  list.add("preset", preset, "the device the numbers came from");
  list.add("geometry", geometry, "how the beams are laid out", {"tilting", "spinning", "camera"});
  list.add("horizontal_deg", horizontal_deg, "deg", "opening angle of a line", 0.1, 360.0);
  list.add("vertical_deg", vertical_deg, "deg", "tilt sweep from first to last line", 0.0, 180.0);
  list.add("tilt_center_deg", tilt_center_deg, "deg", "middle of the sweep, negative looks down",
           -90.0, 90.0);
  list.add("beams_per_line", beams_per_line, "1", "beams of a line", 1, 20000);
  list.add("lines", lines, "1", "lines of a sweep", 1, 20000);
  list.add("minimum_range", minimum_range, "m", "nearer returns are lost", 0.001, 1000.0);
  list.add("maximum_range", maximum_range, "m", "farther returns are lost", 0.01, 10000.0);
  list.add("report_maximum", report_maximum,
           "a beam without return gives a point at maximum_range");

  list.add("lines_per_second", lines_per_second, "1/s", "turns of the mirror", 0.01, 1000.0);
  list.add("beams_per_turn", beams_per_turn, "1",
           "of a full turn of the mirror; 0: a line at one time", 0, 100000);
  list.add("sweep_moves", sweep_moves, "the tilt moves while a line is measured");
  list.add("deskew", deskew, "the driver gives each beam its own tilt angle");
  list.add("clock_offset", clock_offset, "s", "the driver looks the tilt up this much too late",
           -1.0, 1.0);

  list.add("robot_speed", robot_speed, "m/s", "robot drives along x during the sweep", -20.0, 20.0);
  list.add("robot_speed_left", robot_speed_left, "m/s", "robot drives along y during the sweep",
           -20.0, 20.0);
  list.add("robot_turn_deg", robot_turn_deg, "deg/s", "robot turns about z during the sweep",
           -720.0, 720.0);
  list.add("motion_compensated", motion_compensated, "perfect odometry undoes the robot's motion");

  list.add("mount_x", mount_x, "m", "known offset of the scanner on the tilt unit", -2.0, 2.0);
  list.add("mount_y", mount_y, "m", "known offset", -2.0, 2.0);
  list.add("mount_z", mount_z, "m", "known offset", -2.0, 2.0);
  list.add("mount_error_x", mount_error_x, "m", "what the driver does not know of it", -1.0, 1.0);
  list.add("mount_error_y", mount_error_y, "m", "what the driver does not know of it", -1.0, 1.0);
  list.add("mount_error_z", mount_error_z, "m", "what the driver does not know of it", -1.0, 1.0);
  list.add("mount_error_roll_deg", mount_error_roll_deg, "deg", "boresight error about x", -30.0,
           30.0);
  list.add("mount_error_pitch_deg", mount_error_pitch_deg, "deg", "boresight error about y", -30.0,
           30.0);
  list.add("mount_error_yaw_deg", mount_error_yaw_deg, "deg", "boresight error about z", -30.0,
           30.0);
  list.add("mount_sigma", mount_sigma, "m", "further error of each axis, drawn once a scan", 0.0,
           1.0);
  list.add("mount_angle_sigma_deg", mount_angle_sigma_deg, "deg",
           "further error of each angle, drawn once a scan", 0.0, 10.0);

  list.add("encoder_step_deg", encoder_step_deg, "deg", "quantum of the tilt encoder", 0.0, 10.0);
  list.add("encoder_sigma_deg", encoder_sigma_deg, "deg",
           "noise of the tilt encoder, drawn once a line", 0.0, 10.0);
  list.add("backlash_deg", backlash_deg, "deg", "play of the tilt unit", 0.0, 10.0);

  list.add("range_sigma", range_sigma, "m", "standard deviation of the range noise, at any range",
           0.0, 1.0);
  list.add("range_slope", range_slope, "m/m",
           "noise that grows with the range: max(range_sigma, slope r + offset)", 0.0, 1.0);
  list.add("range_offset", range_offset, "m", "see range_slope", -1.0, 1.0);
  list.add("snr_sigma", snr_sigma, "m",
           "noise that follows the signal, at the reference below; 0: off", 0.0, 1.0);
  list.add("snr_exponent", snr_exponent, "1", "1: electronics limited, 0.5: shot limited", 0.0,
           2.0);
  list.add("snr_range", snr_range, "m", "reference range of snr_sigma", 0.1, 1000.0);
  list.add("snr_reflectance", snr_reflectance, "1", "reference reflectance of snr_sigma", 0.01,
           1.0);
  list.add("spread_noise", spread_noise, "1", "share of the footprint's range spread that is noise",
           0.0, 1.0);
  list.add("drift_sigma", drift_sigma, "m", "warm-up drift: one offset a scan", 0.0, 1.0);
  list.add("wiggle", wiggle, "m", "fourth-harmonic error of a phase camera", 0.0, 1.0);
  list.add("range_quantum", range_quantum, "m", "ranges are multiples of it; 0: not quantised", 0.0,
           1.0);

  list.add("divergence", divergence, "rad", "full opening angle of a beam", 0.0, 0.2);
  list.add("aperture", aperture, "m", "diameter of a beam at the scanner", 0.0, 0.2);
  list.add("profile", profile, "energy across the footprint", {"uniform", "gaussian"});
  list.add("subrays", subrays, "1", "rays that sample the footprint; 1: the centre alone", 1, 4096);
  list.add("subrays_everywhere", subrays_everywhere,
           "trace them also where no edge is near (same bytes, slower)");
  list.add("echo", echo, "which echo is reported", {"first", "strongest", "last", "phase"});
  list.add("pulse_width", pulse_width, "s", "echoes nearer than c tau / 2 run together", 0.0, 1e-6);
  list.add("echo_share", echo_share, "1", "weaker echoes, against the strongest, are not seen", 0.0,
           1.0);
  list.add("modulation_frequency", modulation_frequency, "Hz",
           "of a phase scanner; ranges are modulo c / 2f", 1e5, 1e10);

  list.add("detection_range", detection_range, "m",
           "half of detection_reflectance comes back from here; 0: all do", 0.0, 10000.0);
  list.add("detection_reflectance", detection_reflectance, "1", "see detection_range", 0.001, 1.0);
  list.add("detection_db", detection_db, "dB", "softness of the detection limit", 0.0, 20.0);
  list.add("loss", loss, "1", "share of returns lost for no reason", 0.0, 1.0);

  list.add("glass", glass, "beams go through what transmits");
  list.add("mirrors", mirrors, "beams go on from what mirrors: ghosts");
  list.add("glass_f0", glass_f0, "1", "Fresnel reflectance of a pane at normal incidence", 0.0,
           1.0);
  list.add("bounces", bounces, "1", "at most so many passages and reflections a beam", 0, 16);
}

void check_lidar_options(const LidarOptions& options) {
  if (options.minimum_range >= options.maximum_range) {
    fail_usage("minimum_range is not below maximum_range", "no return could be reported");
  }
  if (options.geometry == "camera" &&
      (options.horizontal_deg >= 179.0 || options.vertical_deg >= 179.0)) {
    fail_usage("a camera cannot see 180 degrees",
               "choose geometry 'spinning' or a smaller opening");
  }
  if (options.subrays > 1 && options.divergence == 0.0 && options.aperture == 0.0) {
    fail_usage("subrays is above 1 but the beam has no width", "set divergence or aperture");
  }
}

}  // namespace scanchor
