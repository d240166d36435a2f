#pragma once
// Targets with known answers: plates, steps and rooms of boxes.

#include <cmath>
#include <string>

#include "core/file.hpp"
#include "core/math.hpp"
#include "sensors/tilting_lidar.hpp"
#include "tests/sim/support/boxes.hpp"

namespace scanchor::testing {

/// One thin plate in front of the sensor at the origin: its near side crosses the x axis at
/// `range`, turned by `incidence` about z.
inline Scene plate(double range, double incidence = 0.0, double reflectance = 0.5,
                   double side = 40.0) {
  Scene scene = empty_scene();
  scene.materials[0].reflectance = reflectance;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::AngleAxisd(incidence, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  pose.translation() = Eigen::Vector3d(range, 0, 0) + pose.linear() * Eigen::Vector3d(0.05, 0, 0);
  scene.instances.push_back(box_instance(1, {0.1, side, side}, pose));
  return scene;
}

/// All beams along the x axis, one tilt, perfect but for what the test sets.
inline LidarOptions straight_beams(int lines, int beams) {
  LidarOptions o;
  o.lines = lines;
  o.beams_per_line = beams;
  o.horizontal_deg = 0.0;  // every beam the same: a sample of draws
  o.vertical_deg = 0.0;
  o.tilt_center_deg = 0.0;
  o.range_sigma = 0.0;
  o.maximum_range = 1000.0;
  return o;
}

/// Ranges of all points from the sensor's origin.
inline std::vector<double> ranges(const Scan& scan) {
  std::vector<double> all;
  for (const auto& p : scan.cloud.points) all.push_back(p.norm());
  return all;
}

inline double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

inline double deviation(const std::vector<double>& values) {
  const double m = mean(values);
  double sum = 0.0;
  for (const double v : values) sum += (v - m) * (v - m);
  return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

/// SHA-256 over every column of a scan.
inline std::string digest(const Scan& scan) {
  std::string bytes;
  const auto add = [&](const auto& column) {
    bytes.append(reinterpret_cast<const char*>(column.data()), column.size() * sizeof(column[0]));
  };
  add(scan.cloud.points);
  for (const Field& field : scan.cloud.fields) std::visit(add, field.values);
  add(scan.truth.class_id);
  add(scan.truth.instance);
  add(scan.truth.part);
  add(scan.truth.face);
  add(scan.truth.runner_up);
  add(scan.truth.flags);
  add(scan.truth.true_range);
  add(scan.truth.incidence);
  add(scan.line);
  add(scan.beam);
  for (const auto& v : scan.visibility) {
    bytes.append(reinterpret_cast<const char*>(&v.face), sizeof v.face);
    bytes.append(reinterpret_cast<const char*>(&v.points), sizeof v.points);
    bytes.append(reinterpret_cast<const char*>(&v.visible_fraction), sizeof v.visible_fraction);
  }
  return sha256(bytes);
}

}  // namespace scanchor::testing
