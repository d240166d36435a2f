#include <functional>
#include <utility>

#include "core/error.hpp"
#include "core/text.hpp"
#include "sensors/tilting_lidar.hpp"

// Sources of the numbers: docs/reference/sensors.md, table of presets.

namespace scanchor {
namespace {

/// Noise of a device as libpointmatcher models it: max(s_min, k r + c) (Pomerleau et al. 2012).
void noise(LidarOptions& o, double minimum, double slope, double offset) {
  o.range_sigma = minimum;
  o.range_slope = slope;
  o.range_offset = offset;
}

LidarOptions paper() { return {}; }

LidarOptions utm_30lx() {
  LidarOptions o;
  o.preset = "utm-30lx";
  o.horizontal_deg = 270.0;
  o.beams_per_line = 1081;
  o.lines = 139;
  o.beams_per_turn = 1440;
  o.lines_per_second = 40.0;
  o.minimum_range = 0.1;
  o.maximum_range = 30.0;
  noise(o, 0.018, 0.0006, 0.0015);
  o.range_quantum = 0.001;
  o.drift_sigma = 0.005;
  o.encoder_step_deg = 180.0 / 14000.0;
  return o;
}

LidarOptions ust_20lx() {
  LidarOptions o;
  o.preset = "ust-20lx";
  o.horizontal_deg = 270.0;
  o.beams_per_line = 1081;
  o.lines = 139;
  o.beams_per_turn = 1440;
  o.lines_per_second = 40.0;
  o.minimum_range = 0.06;
  o.maximum_range = 20.0;
  o.range_sigma = 0.01;
  o.range_quantum = 0.001;
  return o;
}

LidarOptions lms_200() {
  LidarOptions o;
  o.preset = "lms-200";
  o.horizontal_deg = 180.0;
  o.beams_per_line = 361;
  o.lines = 277;
  o.beams_per_turn = 720;
  o.lines_per_second = 37.5;
  o.minimum_range = 0.1;
  o.maximum_range = 8.0;
  o.range_sigma = 0.005;
  o.drift_sigma = 0.005;
  o.range_quantum = 0.001;
  o.divergence = 0.0044;
  o.subrays = 19;
  return o;
}

LidarOptions lms_1xx() {
  LidarOptions o;
  o.preset = "lms-1xx";
  o.horizontal_deg = 270.0;
  o.beams_per_line = 541;
  o.lines = 180;
  o.beams_per_turn = 720;
  o.lines_per_second = 50.0;
  o.minimum_range = 0.5;
  o.maximum_range = 20.0;
  noise(o, 0.012, 0.0068, 0.0008);
  o.range_quantum = 0.001;
  o.divergence = 0.015;
  o.aperture = 0.008;
  o.subrays = 31;
  return o;
}

LidarOptions lms_5xx() {
  LidarOptions o;
  o.preset = "lms-5xx";
  o.horizontal_deg = 190.0;
  o.beams_per_line = 571;
  o.lines = 180;
  o.beams_per_turn = 1080;
  o.lines_per_second = 35.0;
  o.minimum_range = 0.7;
  o.maximum_range = 80.0;
  noise(o, 0.006, 0.0006, -0.001);  // 6, 8, 14 mm in the bands to 10, 20, 30 m
  o.range_quantum = 0.001;
  o.divergence = 0.011;
  o.aperture = 0.013;
  o.subrays = 31;
  return o;
}

LidarOptions vlp_16() {
  LidarOptions o;
  o.preset = "vlp-16";
  o.geometry = "spinning";
  o.horizontal_deg = 360.0;
  o.vertical_deg = 30.0;
  o.tilt_center_deg = 0.0;
  o.beams_per_line = 1800;
  o.lines = 16;
  o.beams_per_turn = 1800;
  o.lines_per_second = 10.0;
  o.minimum_range = 0.5;
  o.maximum_range = 100.0;
  o.range_sigma = 0.03;
  o.range_quantum = 0.002;
  o.divergence = 0.0007;
  o.subrays = 7;
  return o;
}

LidarOptions pmd_camcube() {
  LidarOptions o;
  o.preset = "pmd-camcube";
  o.geometry = "camera";
  o.horizontal_deg = 40.0;
  o.vertical_deg = 40.0;
  o.tilt_center_deg = -15.0;
  o.beams_per_line = 200;
  o.lines = 200;
  o.beams_per_turn = 0;
  o.lines_per_second = 40.0;
  o.minimum_range = 0.3;
  o.maximum_range = 7.5;
  o.range_sigma = 0.0;
  o.snr_sigma = 0.003;
  o.snr_range = 4.0;
  o.snr_reflectance = 0.75;
  o.snr_exponent = 0.5;
  o.wiggle = 0.01;
  o.divergence = 0.0035;
  o.subrays = 16;
  o.echo = "phase";
  o.modulation_frequency = 20e6;
  return o;
}

using Maker = std::function<LidarOptions()>;
const std::vector<std::pair<std::string, Maker>>& makers() {
  static const std::vector<std::pair<std::string, Maker>> list = {
      {"paper", paper},     {"utm-30lx", utm_30lx},      {"ust-20lx", ust_20lx},
      {"lms-200", lms_200}, {"lms-1xx", lms_1xx},        {"lms-5xx", lms_5xx},
      {"vlp-16", vlp_16},   {"pmd-camcube", pmd_camcube}};
  return list;
}

}  // namespace

const std::vector<std::string>& lidar_presets() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const auto& [name, make] : makers()) all.push_back(name);
    return all;
  }();
  return names;
}

LidarOptions lidar_preset(const std::string& name) {
  for (const auto& [known, make] : makers()) {
    if (known == name) return make();
  }
  fail_usage("unknown LIDAR preset '" + name + "'", suggestion(name, lidar_presets()));
}

}  // namespace scanchor
