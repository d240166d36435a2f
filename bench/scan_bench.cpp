// How much of Embree's raw rate is left in a whole scan: both in one run, alternately, on the same
// rays of the same room.
//   scan_bench                        the table
//   scan_bench --benchmark_filter=Effects

#include <benchmark/benchmark.h>

#include <chrono>
#include <memory>

#include "core/parallel.hpp"
#include "scenes/generator.hpp"
#include "sensors/kinematics.hpp"
#include "sensors/tilting_lidar.hpp"
#include "sim/embree_compat.hpp"
#include "sim/settle.hpp"
#include "sim/world.hpp"

namespace scanchor {
namespace {

Scene office() {
  RoomOptions options;
  Scene scene = generate_room(options, 3);
  settle(scene, {});
  return scene;
}

Eigen::Isometry3d stand(const Scene& scene) {
  if (!scene.sensor_poses.empty()) return scene.sensor_poses.front();
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation() = scene.bounds.center();
  return T;
}

/// Nothing but rtcIntersect16 on packets that lie ready; the copy is there because Embree writes
/// into its rays.
class RawEmbree {
 public:
  RawEmbree(const World& world, const Eigen::Isometry3d& T, const LidarOptions& options,
            bool robust) {
    device_ = rtcNewDevice(nullptr);
    scene_ = rtcNewScene(device_);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_MEDIUM);
    if (robust) rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    const std::size_t count = world.triangles().size();
    auto* v = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                          RTC_FORMAT_FLOAT3, 12, 3 * count));
    auto* f = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, count));
    for (std::uint32_t t = 0; t < count; ++t) {
      for (int c = 0; c < 3; ++c) {
        for (int a = 0; a < 3; ++a) *v++ = static_cast<float>(world.corner(t, c)[a]);
        *f++ = 3 * t + static_cast<unsigned>(c);
      }
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
    fill(T, options);
  }
  ~RawEmbree() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  RawEmbree(const RawEmbree&) = delete;
  RawEmbree& operator=(const RawEmbree&) = delete;

  void run() const {
    parallel_blocks(packets_.size(), 256, [&](std::size_t begin, std::size_t end) {
      embree::Query query(true);
      alignas(64) int valid[16];
      for (int& lane : valid) lane = -1;
      for (std::size_t i = begin; i < end; ++i) {
        RTCRayHit16 packet = packets_[i];
        embree::intersect(valid, scene_, query, packet);
        benchmark::DoNotOptimize(packet.hit.primID[0]);
      }
    });
  }

 private:
  void fill(const Eigen::Isometry3d& T, const LidarOptions& options) {
    const Kinematics kinematics(options, 1);
    BeamColumns beams;
    std::size_t i = 0;
    packets_.resize(static_cast<std::size_t>(options.lines) *
                    static_cast<std::size_t>(options.beams_per_line) / 16);
    for (int n = 0; n < options.lines; ++n) {
      kinematics.true_beams(n, beams);
      for (std::size_t k = 0; k < beams.origin_x.size() && i / 16 < packets_.size(); ++k, ++i) {
        RTCRayHit16& p = packets_[i / 16];
        const std::size_t lane = i % 16;
        const Eigen::Vector3f o = (T * beams.origin(k)).cast<float>();
        const Eigen::Vector3f d = (T.linear() * beams.direction(k)).cast<float>();
        p.ray.org_x[lane] = o.x(), p.ray.org_y[lane] = o.y(), p.ray.org_z[lane] = o.z();
        p.ray.dir_x[lane] = d.x(), p.ray.dir_y[lane] = d.y(), p.ray.dir_z[lane] = d.z();
        p.ray.tnear[lane] = 1e-4F;
        p.ray.tfar[lane] = 1e30F;
        p.ray.mask[lane] = 0xffffffffU;
        p.ray.time[lane] = 0.0F;
        p.ray.flags[lane] = p.ray.id[lane] = 0;
        p.hit.geomID[lane] = p.hit.primID[lane] = p.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
      }
    }
  }

  RTCDevice device_;
  RTCScene scene_;
  std::vector<RTCRayHit16> packets_;
};

template <class Work>
double seconds(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The beams of a sweep in the world, as World::trace takes them.
struct SweepColumns {
  std::vector<double> column[6];
  std::vector<std::uint32_t> triangle;
  std::vector<double> range;
  std::size_t per_line;

  SweepColumns(const Eigen::Isometry3d& T, const LidarOptions& options)
      : per_line(static_cast<std::size_t>(options.beams_per_line)) {
    const Kinematics kinematics(options, 1);
    BeamColumns beams;
    for (int n = 0; n < options.lines; ++n) {
      kinematics.true_beams(n, beams);
      for (std::size_t k = 0; k < per_line; ++k) {
        const Eigen::Vector3d o = T * beams.origin(k);
        const Eigen::Vector3d d = T.linear() * beams.direction(k);
        for (int axis = 0; axis < 3; ++axis) {
          column[axis].push_back(o[axis]);
          column[3 + axis].push_back(d[axis]);
        }
      }
    }
    triangle.resize(column[0].size());
    range.resize(column[0].size());
  }
  void trace(const World& world) {
    parallel_blocks(column[0].size() / per_line, 8, [&](std::size_t begin, std::size_t end) {
      const std::size_t i = begin * per_line;
      world.trace({&column[0][i], &column[1][i], &column[2][i], &column[3][i], &column[4][i],
                   &column[5][i], (end - begin) * per_line},
                  &triangle[i], &range[i]);
    });
  }
};

/// Columns: Mrays/s of raw Embree (default flags and robust), of World::trace with the ranges in
/// double, and of the whole scan.
void ScanAgainstRaw(benchmark::State& state) {
  const ThreadLimit limit(static_cast<int>(state.range(0)));
  const Scene scene = office();
  const World world(scene);
  const LidarOptions options = lidar_preset("paper");
  const Eigen::Isometry3d T = stand(scene);
  const RawEmbree raw(world, T, options, false);
  const RawEmbree robust(world, T, options, true);
  const double rays = options.lines * static_cast<double>(options.beams_per_line);
  Scan scan;
  scan_room_into(world, T, options, 1, scan);
  SweepColumns columns(T, options);
  double trace_time = 0.0;
  double raw_time = 0.0, robust_time = 0.0, scan_time = 0.0, fresh_time = 0.0;
  std::uint64_t seed = 2;
  for (auto _ : state) {
    raw_time += seconds([&] { raw.run(); });
    robust_time += seconds([&] { robust.run(); });
    trace_time += seconds([&] { columns.trace(world); });
    const double one = seconds([&] { scan_room_into(world, T, options, ++seed, scan); });
    fresh_time += seconds([&] { benchmark::DoNotOptimize(scan_room(world, T, options, ++seed)); });
    scan_time += one;
    state.SetIterationTime(one);
  }
  const double n = static_cast<double>(state.iterations()) * rays / 1e6;
  state.counters["triangles"] = static_cast<double>(world.triangles().size());
  state.counters["raw_Mrays"] = n / raw_time;
  state.counters["robust_Mrays"] = n / robust_time;
  state.counters["trace_Mrays"] = n / trace_time;
  state.counters["scan_Mrays"] = n / scan_time;
  state.counters["fresh_Mrays"] = n / fresh_time;  // with new memory for every scan
  state.counters["trace_ratio"] = raw_time / trace_time;
  state.counters["trace_ratio_robust"] = robust_time / trace_time;
  state.counters["scan_ratio"] = raw_time / scan_time;
  state.counters["scan_ratio_robust"] = robust_time / scan_time;
}
BENCHMARK(ScanAgainstRaw)->Arg(1)->Arg(2)->UseManualTime()->Unit(benchmark::kMillisecond);

/// What each effect costs: one scan of the office with that effect alone. Argument: index into the
/// list.
void Effects(benchmark::State& state) {
  static const std::vector<std::pair<const char*, const char*>> effects = {
      {"range noise", "range_sigma=0.01"},
      {"no noise", "range_sigma=0"},
      {"noise by signal", "snr_sigma=0.005"},
      {"encoder", "encoder_sigma_deg=0.05"},
      {"detection", "detection_range=20"},
      {"driving", "robot_speed=0.2"},
      {"31 sub-rays", "subrays=31"},
      {"31 sub-rays everywhere", "subrays_everywhere=true"}};
  const auto& [name, assignment] = effects[static_cast<std::size_t>(state.range(0))];
  const ThreadLimit limit(1);
  const Scene scene = office();
  const World world(scene);
  LidarOptions options = lidar_preset("paper");
  if (std::string(assignment).find("subrays") == 0) {
    options.divergence = 0.011, options.aperture = 0.013;  // LMS-5xx
    options.subrays = 31;
  }
  OptionList list;
  options.describe(list);
  list.set_assignment(assignment);
  Scan scan;
  std::uint64_t seed = 0;
  for (auto _ : state) scan_room_into(world, stand(scene), options, ++seed, scan);
  state.SetLabel(name);
  state.counters["Mbeams"] = benchmark::Counter(
      static_cast<double>(state.iterations()) * static_cast<double>(scan.beams_fired) / 1e6,
      benchmark::Counter::kIsRate);
}
BENCHMARK(Effects)->DenseRange(0, 7)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace scanchor

BENCHMARK_MAIN();
