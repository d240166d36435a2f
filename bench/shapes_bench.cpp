// Time of find_shapes for a room of 100,000 points: planes known, outlines, rectangles and features
// to do.
//   build: cmake -DSCANCHOR_BENCH=ON; run: shapes_bench --benchmark_filter=default

#include <benchmark/benchmark.h>

#include <cmath>

#include "core/parallel.hpp"
#include "perception/perceive.hpp"
#include "tests/perception/support/shape_scene.cpp"  // the tests' scanner; each benchmark is one source

namespace {

using namespace scanchor;
using scanchor::testing::box_panel;
using scanchor::testing::Panel;
using scanchor::testing::ScannerSetup;
using scanchor::testing::ShapeScan;

void add_box(std::vector<Panel>& panels, const Eigen::Vector3d& foot, const Eigen::Vector3d& size) {
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX();
  const Eigen::Vector3d y = Eigen::Vector3d::UnitY();
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  panels.push_back(box_panel(foot + size.z() * z, x, y, size.x(), size.y()));
  const Eigen::Vector3d middle = foot + 0.5 * size.z() * z;
  for (const double side : {-0.5, 0.5}) {
    panels.push_back(box_panel(middle + side * size.x() * x, y, z, size.y(), size.z()));
    panels.push_back(box_panel(middle + side * size.y() * y, x, z, size.x(), size.z()));
  }
}

/// A room of 6 x 5 x 2.8 m with a desk, two monitors, a cabinet and a dozen boxes; `density` times
/// 100,000 rays.
const ShapeScan& room(double density) {
  static std::vector<std::pair<double, ShapeScan>> scans;
  for (const auto& [known, scan] : scans) {
    if (known == density) return scan;
  }
  std::vector<Panel> panels = {
      box_panel({3, 2.5, 0}, {1, 0, 0}, {0, 1, 0}, 6, 5),
      box_panel({3, 2.5, 2.8}, {1, 0, 0}, {0, 1, 0}, 6, 5),
      box_panel({6, 2.5, 1.4}, {0, 1, 0}, {0, 0, 1}, 5, 2.8),
      box_panel({3, 0, 1.4}, {1, 0, 0}, {0, 0, 1}, 6, 2.8),
      box_panel({3, 5, 1.4}, {1, 0, 0}, {0, 0, 1}, 6, 2.8),
      box_panel({0, 2.5, 1.4}, {0, 1, 0}, {0, 0, 1}, 5, 2.8),
      box_panel({3.6, 2.25, 1.02}, {0.12, 0.99, 0}, {0, 0, 1}, 0.57, 0.42),
      box_panel({3.6, 2.95, 1.02}, {-0.15, 0.98, 0}, {0, 0, 1}, 0.57, 0.42)};
  add_box(panels, {3.5, 2.6, 0.72}, {0.8, 1.6, 0.03});
  add_box(panels, {5.6, 4.4, 0.0}, {0.6, 1.2, 1.0});
  for (int i = 0; i < 12; ++i)
    add_box(panels, {1.8 + 0.35 * i, i % 2 == 0 ? 0.6 : 4.2, 0.0}, {0.2, 0.25, 0.2 + 0.03 * i});
  ScannerSetup setup;
  setup.position = {0.9, 2.3, 1.4};
  setup.beams = static_cast<int>(500 * std::sqrt(density));
  setup.lines = static_cast<int>(200 * std::sqrt(density));
  setup.range_sigma = 0.01;
  scans.emplace_back(density, testing::scan_panels(panels, setup));
  return scans.back().second;
}

void shapes(benchmark::State& state, const std::string& method, int threads, double density) {
  const ShapeScan& scan = room(density);
  const ThreadLimit limit(threads);
  PerceiveOptions options;
  options.method = method;
  for (auto _ : state) {
    Surfaces surfaces = scan.surfaces;
    find_shapes(scan.cloud, options, surfaces);
    benchmark::DoNotOptimize(surfaces.surfaces.data());
  }
  state.counters["points"] = static_cast<double>(scan.cloud.size());
  state.counters["surfaces"] = static_cast<double>(scan.surfaces.surfaces.size());
}

}  // namespace

BENCHMARK_CAPTURE(shapes, default_100k_1_thread, "default", 1, 1.0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(shapes, default_100k_2_threads, "default", 2, 1.0)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(shapes, default_400k_1_thread, "default", 1, 4.0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(shapes, paper_100k_1_thread, "paper", 1, 1.0)->Unit(benchmark::kMillisecond);
BENCHMARK_MAIN();
