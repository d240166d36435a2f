#include "sensors/tilting_lidar.hpp"

#include <algorithm>

#include "core/parallel.hpp"
#include "sensors/beam_tracer.hpp"
#include "sensors/detection.hpp"
#include "sensors/edge_mask.hpp"
#include "sensors/kinematics.hpp"
#include "sensors/line_returns.hpp"
#include "sensors/portable_angle.hpp"
#include "sensors/range_error.hpp"
#include "sensors/vector_rows.hpp"

namespace scanchor {
namespace {

/// Area of faces that beams reached, in runs of beams on one face.
struct FaceRun {
  std::int32_t face;
  double area;
};

/// What one line needs while it is worked on.
struct LineWork {
  BeamColumns beams;     // sensor frame at the start
  BeamColumns world;     // the same beams in the world
  BeamColumns believed;  // where the driver puts the points
  LineReturns returns;
  std::vector<double> measured;
  std::vector<double> cells;  // [sr] of each beam
};

class Sweep {
 public:
  Sweep(const World& world, const Eigen::Isometry3d& T_world_sensor, const LidarOptions& options,
        std::uint64_t seed, Scan& scan)
      : world_(world),
        T_world_sensor_(T_world_sensor),
        options_(options),
        kinematics_(options, seed),
        tracer_(world, options, seed),
        detection_(options, seed),
        range_error_(options, seed),
        scan_(scan),
        kept_(static_cast<std::size_t>(options.lines), 0),
        reached_(static_cast<std::size_t>(options.lines)) {}

  void run();

 private:
  void measure_line(int line, LineWork& work);
  void to_world(LineWork& work) const;
  void note_reached(int line, LineWork& work);
  void drop_unseen(int line, LineReturns& returns) const;
  void trace_all_middles();
  void keep_points(int line, const LineWork& work);
  void keep(int line, std::size_t k, std::size_t j, const LineWork& work);
  void report_nothing(int line, std::size_t k, std::size_t j, const LineWork& work);
  void close_gaps();
  void sum_visibility();

  const World& world_;
  const Eigen::Isometry3d T_world_sensor_;
  const LidarOptions& options_;
  const Kinematics kinematics_;
  const BeamTracer tracer_;
  const Detection detection_;
  const RangeError range_error_;
  std::vector<LineReturns> middles_;     // with a footprint: of all lines, before any is refined
  std::vector<std::uint8_t> straddles_;  // with a footprint: one a beam
  Scan& scan_;
  std::vector<float>* intensity_ = nullptr;
  std::vector<std::size_t> kept_;              // points of each line
  std::vector<std::vector<FaceRun>> reached_;  // of each line
};

void Sweep::run() {
  const auto beams = static_cast<std::size_t>(options_.beams_per_line);
  const auto lines = static_cast<std::size_t>(options_.lines);
  const std::size_t fired = beams * lines;
  // All columns at full length first: every line has its own place and lines need not wait for each
  // other.
  scan_.cloud.points.resize(fired);
  if (scan_.cloud.fields.size() != 1 || scan_.cloud.fields[0].name != "intensity" ||
      !std::holds_alternative<std::vector<float>>(scan_.cloud.fields[0].values)) {
    scan_.cloud.fields = {{"intensity", std::vector<float>()}};
  }
  intensity_ = &std::get<std::vector<float>>(scan_.cloud.fields[0].values);
  intensity_->resize(fired);
  scan_.cloud.width = 0;
  scan_.cloud.height = 0;
  scan_.cloud.sensor_poses = {Eigen::Isometry3d::Identity()};
  scan_.truth.resize(fired);
  scan_.line.resize(fired);
  scan_.beam.resize(fired);
  scan_.beams_fired = fired;
  scan_.T_world_sensor = T_world_sensor_;

  if (tracer_.has_footprint()) trace_all_middles();
  parallel_blocks(lines, 8, [&](std::size_t begin, std::size_t end) {
    LineWork work;
    for (std::size_t line = begin; line < end; ++line) measure_line(static_cast<int>(line), work);
  });
  close_gaps();
  sum_visibility();
}

void Sweep::trace_all_middles() {
  middles_.resize(static_cast<std::size_t>(options_.lines));
  parallel_blocks(middles_.size(), 8, [&](std::size_t begin, std::size_t end) {
    LineWork work;
    for (std::size_t line = begin; line < end; ++line) {
      kinematics_.true_beams(static_cast<int>(line), work.beams);
      to_world(work);
      tracer_.trace_middles(work.world, middles_[line]);
    }
  });
  straddles_ = straddling_beams(world_, T_world_sensor_, options_, kinematics_,
                                tracer_.footprint().reach(), middles_);
}

void Sweep::measure_line(int line, LineWork& work) {
  const auto n = static_cast<std::size_t>(line);
  const auto count = static_cast<std::size_t>(options_.beams_per_line);
  kinematics_.true_beams(line, work.beams);
  to_world(work);
  if (tracer_.has_footprint()) {
    work.returns = std::move(middles_[n]);
    tracer_.refine(line, work.world, {straddles_.data() + n * count, count}, work.returns);
  } else {
    tracer_.trace_middles(work.world, work.returns);
    tracer_.refine(line, work.world, {}, work.returns);
  }
  note_reached(line, work);
  drop_unseen(line, work.returns);
  range_error_.apply(line, work.returns, work.measured);
  if (!kinematics_.believes_truth()) kinematics_.believed_beams(line, work.believed);
  keep_points(line, work);
}

void Sweep::to_world(LineWork& work) const {
  const auto count = static_cast<std::size_t>(options_.beams_per_line);
  work.world.resize(count);
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> R = T_world_sensor_.linear();
  const Eigen::Vector3d t = T_world_sensor_.translation();
  const BeamColumns& b = work.beams;
  BeamColumns& w = work.world;
  transform_row(R.data(), nullptr, b.direction_x.data(), b.direction_y.data(), b.direction_z.data(),
                count, w.direction_x.data(), w.direction_y.data(), w.direction_z.data());
  transform_row(R.data(), t.data(), b.origin_x.data(), b.origin_y.data(), b.origin_z.data(), count,
                w.origin_x.data(), w.origin_y.data(), w.origin_z.data());
}

/// Area of the faces that the beams of a line reached, lost pulses included.
void Sweep::note_reached(int line, LineWork& work) {
  const LineReturns& r = work.returns;
  kinematics_.solid_angles(line, work.cells);
  const auto& surfaces = world_.surfaces();
  auto& runs = reached_[static_cast<std::size_t>(line)];
  for (std::size_t k = 0; k < r.size(); ++k) {
    if (r.triangle[k] == no_hit || (r.flags[k] & (point_ghost | point_behind_glass)) != 0) continue;
    const std::int32_t face = surfaces[r.triangle[k]].face;
    if (runs.empty() || runs.back().face != face) runs.push_back({face, 0.0});
    runs.back().area +=
        r.true_range[k] * r.true_range[k] * work.cells[k] / std::max(r.cosine[k], 0.01);
  }
}

void Sweep::drop_unseen(int line, LineReturns& r) const {
  if (detection_.always()) return;
  for (std::size_t k = 0; k < r.size(); ++k) {
    if (r.triangle[k] == no_hit) continue;
    if (!detection_.seen(line, static_cast<int>(k), r.true_range[k], r.reflected[k])) {
      r.triangle[k] = no_hit;
    }
  }
}

void Sweep::keep_points(int line, const LineWork& work) {
  const auto count = static_cast<std::size_t>(options_.beams_per_line);
  const LineReturns& r = work.returns;
  const std::size_t base = static_cast<std::size_t>(line) * count;
  bool all = true;
  for (std::size_t k = 0; k < count; ++k) {
    const double range = work.measured[k];
    all = all && r.triangle[k] != no_hit && range >= options_.minimum_range &&
          range <= options_.maximum_range;
  }
  std::size_t j = base;
  for (std::size_t k = 0; k < count; ++k) {
    const bool hit = r.triangle[k] != no_hit;
    const double range = hit ? work.measured[k] : options_.maximum_range;
    if (all || (hit && range >= options_.minimum_range && range <= options_.maximum_range)) {
      keep(line, k, j++, work);
    } else if (options_.report_maximum && (!hit || range > options_.maximum_range)) {
      report_nothing(line, k, j++, work);
    }
  }
  if (all) {
    angle_row(r.cosine.data(), count, scan_.truth.incidence.data() + base);
  } else {
    for (std::size_t i = base; i < j; ++i) {
      if (scan_.truth.face[i] < 0) continue;
      const auto k = static_cast<std::size_t>(scan_.beam[i]);
      scan_.truth.incidence[i] = static_cast<float>(angle_of_cosine(r.cosine[k]));
    }
  }
  kept_[static_cast<std::size_t>(line)] = j - base;
}

/// Everything of a return but its incidence, which is worked out for the whole line.
inline void Sweep::keep(int line, std::size_t k, std::size_t j, const LineWork& work) {
  const LineReturns& r = work.returns;
  const BeamColumns& b = kinematics_.believes_truth() ? work.beams : work.believed;
  const SurfaceRecord& s = world_.surfaces()[r.triangle[k]];
  PointTruth& truth = scan_.truth;
  scan_.cloud.points[j] = b.origin(k) + work.measured[k] * b.direction(k);
  scan_.line[j] = line;
  scan_.beam[j] = static_cast<std::int32_t>(k);
  truth.class_id[j] = s.class_id;
  truth.instance[j] = s.instance_id;
  truth.part[j] = s.part;
  truth.face[j] = s.face;
  truth.runner_up[j] =
      r.runner_up[k] == no_hit ? -1 : world_.surfaces()[r.runner_up[k]].instance_id;
  truth.flags[j] = r.flags[k];
  truth.true_range[j] = static_cast<float>(r.true_range[k]);
  (*intensity_)[j] = static_cast<float>(r.reflected[k]);
}

/// A beam without return, at the maximum range.
void Sweep::report_nothing(int line, std::size_t k, std::size_t j, const LineWork& work) {
  const BeamColumns& b = kinematics_.believes_truth() ? work.beams : work.believed;
  PointTruth& truth = scan_.truth;
  scan_.cloud.points[j] = b.origin(k) + options_.maximum_range * b.direction(k);
  scan_.line[j] = line;
  scan_.beam[j] = static_cast<std::int32_t>(k);
  truth.class_id[j] = unlabelled;
  truth.instance[j] = truth.part[j] = truth.face[j] = truth.runner_up[j] = -1;
  truth.flags[j] = point_out_of_range;
  truth.true_range[j] = truth.incidence[j] = 0.0F;
  (*intensity_)[j] = 0.0F;
}

void Sweep::close_gaps() {
  const auto beams = static_cast<std::size_t>(options_.beams_per_line);
  std::size_t to = 0;
  const auto move_all = [&](auto& column) {
    std::size_t target = 0;
    for (std::size_t line = 0; line < kept_.size(); ++line) {
      const auto from = column.begin() + static_cast<std::ptrdiff_t>(line * beams);
      if (target != line * beams) {
        std::copy(from, from + static_cast<std::ptrdiff_t>(kept_[line]),
                  column.begin() + static_cast<std::ptrdiff_t>(target));
      }
      target += kept_[line];
    }
    column.resize(target);
  };
  for (const std::size_t n : kept_) to += n;
  if (to == kept_.size() * beams) return;
  move_all(scan_.cloud.points);
  move_all(*intensity_);
  PointTruth& t = scan_.truth;
  move_all(t.class_id);
  move_all(t.instance);
  move_all(t.part);
  move_all(t.face);
  move_all(t.runner_up);
  move_all(t.flags);
  move_all(t.true_range);
  move_all(t.incidence);
  move_all(scan_.line);
  move_all(scan_.beam);
}

void Sweep::sum_visibility() {
  const auto& faces = world_.faces();
  std::vector<double> area(faces.size(), 0.0);
  std::vector<std::int32_t> points(faces.size(), 0);
  for (const auto& runs : reached_) {
    for (const FaceRun& run : runs) area[static_cast<std::size_t>(run.face)] += run.area;
  }
  for (std::size_t i = 0; i < scan_.truth.size(); ++i) {
    if (scan_.truth.face[i] >= 0) ++points[static_cast<std::size_t>(scan_.truth.face[i])];
  }
  scan_.visibility.clear();
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (points[f] == 0) continue;
    const FaceAddress& a = faces[f];
    const Face& face = world_.scene()
                           .instances[static_cast<std::size_t>(a.instance)]
                           .parts[static_cast<std::size_t>(a.part)]
                           .faces[static_cast<std::size_t>(a.face)];
    const double fraction = face.area > 0.0 ? std::min(1.0, area[f] / face.area) : 0.0;
    scan_.visibility.push_back({static_cast<std::int32_t>(f), points[f], fraction});
  }
}

}  // namespace

void scan_room_into(const World& world, const Eigen::Isometry3d& T_world_sensor,
                    const LidarOptions& options, std::uint64_t seed, Scan& scan) {
  check_lidar_options(options);
  scan.seed = seed;
  Sweep(world, T_world_sensor, options, seed, scan).run();
}

Scan scan_room(const World& world, const Eigen::Isometry3d& T_world_sensor,
               const LidarOptions& options, std::uint64_t seed) {
  Scan scan;
  scan_room_into(world, T_world_sensor, options, seed, scan);
  return scan;
}

}  // namespace scanchor
