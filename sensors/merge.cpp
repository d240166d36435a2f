#include "sensors/merge.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "core/error.hpp"
#include "core/math.hpp"
#include "core/random.hpp"

namespace scanchor {
namespace {

template <class Column>
void append(Column& to, const Column& from) {
  to.insert(to.end(), from.begin(), from.end());
}

template <class Column>
void reorder(Column& column, const std::vector<std::size_t>& order) {
  Column sorted;
  sorted.reserve(column.size());
  for (const std::size_t i : order) sorted.push_back(column[i]);
  column.swap(sorted);
}

void shuffle(Scan& scan, std::uint64_t seed) {
  std::vector<std::size_t> order(scan.cloud.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  SequentialRandom random(stream_seed(seed, "shuffle"));
  for (std::size_t i = order.size(); i > 1; --i) {  // Fisher-Yates
    std::swap(order[i - 1], order[random.below(static_cast<std::uint32_t>(i))]);
  }
  reorder(scan.cloud.points, order);
  for (Field& field : scan.cloud.fields) {
    std::visit([&](auto& column) { reorder(column, order); }, field.values);
  }
  PointTruth& t = scan.truth;
  reorder(t.class_id, order);
  reorder(t.instance, order);
  reorder(t.part, order);
  reorder(t.face, order);
  reorder(t.runner_up, order);
  reorder(t.flags, order);
  reorder(t.true_range, order);
  reorder(t.incidence, order);
  reorder(scan.line, order);
  reorder(scan.beam, order);
}

/// Adds the points of one scan, moved by T.
void add_scan(Scan& sum, const Scan& scan, const Eigen::Isometry3d& T, std::int32_t index,
              std::vector<float>& intensity, std::vector<std::int32_t>& from) {
  for (const auto& p : scan.cloud.points) sum.cloud.points.push_back(T * p);
  const Field* field = scan.cloud.find("intensity");
  for (std::size_t i = 0; i < scan.cloud.size(); ++i) {
    intensity.push_back(field == nullptr ? 0.0F : static_cast<float>(field->at(i)));
    from.push_back(index);
  }
  append(sum.truth.class_id, scan.truth.class_id);
  append(sum.truth.instance, scan.truth.instance);
  append(sum.truth.part, scan.truth.part);
  append(sum.truth.face, scan.truth.face);
  append(sum.truth.runner_up, scan.truth.runner_up);
  append(sum.truth.flags, scan.truth.flags);
  append(sum.truth.true_range, scan.truth.true_range);
  append(sum.truth.incidence, scan.truth.incidence);
  append(sum.line, scan.line);
  append(sum.beam, scan.beam);
  sum.beams_fired += scan.beams_fired;
}

}  // namespace

void MergeOptions::describe(OptionList& list) {
  list.add("position_sigma", position_sigma, "m",
           "registration error of each scan but the first, each axis", 0.0, 10.0);
  list.add("angle_sigma_deg", angle_sigma_deg, "deg", "the same about each axis", 0.0, 90.0);
  list.add("shuffle", shuffle, "mix the points of all scans");
}

Eigen::Isometry3d pose_error(const MergeOptions& options, std::uint64_t seed, std::size_t index) {
  const CounterRandom random(stream_seed(seed, "registration error"));
  Eigen::Vector3d turn, move;
  for (int axis = 0; axis < 3; ++axis) {
    const auto draw = static_cast<std::uint32_t>(axis);
    turn[axis] = radians(options.angle_sigma_deg) * random.normal(index, 0, draw);
    move[axis] = options.position_sigma * random.normal(index, 1, draw);
  }
  Eigen::Isometry3d error = Eigen::Isometry3d::Identity();
  const double angle = std::sqrt(turn.squaredNorm());
  if (angle > 0.0) {
    // Rodrigues with portable sines.
    const Eigen::Vector3d a = turn / angle;
    const auto [s, c] = portable_sincos(angle);
    Eigen::Matrix3d K;
    K << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
    error.linear() = Eigen::Matrix3d::Identity() + s * K + (1.0 - c) * (K * K);
  }
  error.translation() = move;
  return error;
}

MergedScan merge_scans(const std::vector<Scan>& scans, const MergeOptions& options,
                       std::uint64_t seed) {
  if (scans.empty()) fail_usage("no scans to merge", "give at least one");
  MergedScan merged;
  Scan& sum = merged.scan;
  sum.seed = seed;
  sum.T_world_sensor = scans.front().T_world_sensor;
  const Eigen::Isometry3d T_first_world = sum.T_world_sensor.inverse();
  std::vector<float> intensity;
  std::vector<std::int32_t> from;
  std::map<std::int32_t, FaceVisibility> visibility;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const Eigen::Isometry3d truth =
        i == 0 ? Eigen::Isometry3d(Eigen::Isometry3d::Identity())
               : Eigen::Isometry3d(T_first_world * scans[i].T_world_sensor);
    const Eigen::Isometry3d placed =
        i == 0 ? truth : Eigen::Isometry3d(truth * pose_error(options, seed, i));
    merged.T_first_scan.push_back(truth);
    merged.T_first_placed.push_back(placed);
    sum.cloud.sensor_poses.push_back(placed);
    add_scan(sum, scans[i], placed, static_cast<std::int32_t>(i), intensity, from);
    for (const FaceVisibility& v : scans[i].visibility) {
      auto& total = visibility.try_emplace(v.face, FaceVisibility{v.face, 0, 0.0}).first->second;
      total.points += v.points;
      total.visible_fraction = std::min(1.0, total.visible_fraction + v.visible_fraction);
    }
  }
  sum.cloud.set({"intensity", std::move(intensity)});
  sum.cloud.set({"scan", std::move(from)});
  for (const auto& [face, total] : visibility) sum.visibility.push_back(total);
  if (options.shuffle) shuffle(sum, seed);
  return merged;
}

}  // namespace scanchor
