// What a ray costs by packet width and instruction set, and what a room costs to make ready for
// rays.

#include <benchmark/benchmark.h>

#include "core/parallel.hpp"
#include "scenes/generator.hpp"
#include "sensors/kinematics.hpp"
#include "sim/world.hpp"

namespace scanchor {
namespace {

const char* const isas[] = {"sse2", "avx2", ""};

void Trace(benchmark::State& state) {
  const ThreadLimit limit(1);
  const Scene scene = generate_room({}, 3);
  WorldOptions options;
  options.packet_width = static_cast<int>(state.range(0));
  options.embree_isa = isas[state.range(1)];
  const World world(scene, options);
  const Kinematics kinematics(lidar_preset("paper"), 1);
  const Eigen::Vector3d eye = scene.bounds.center();
  std::vector<Ray> rays;
  BeamColumns beams;
  for (int n = 0; n < 200; ++n) {
    kinematics.true_beams(n, beams);
    for (std::size_t k = 0; k < 500; ++k) rays.push_back({eye, beams.direction(k)});
  }
  std::vector<Hit> hits(rays.size());
  for (auto _ : state) {
    world.trace(rays, hits);
    benchmark::DoNotOptimize(hits.data());
  }
  state.SetLabel(options.embree_isa.empty() ? "best" : options.embree_isa);
  state.counters["Mrays"] = benchmark::Counter(
      static_cast<double>(state.iterations()) * static_cast<double>(rays.size()) / 1e6,
      benchmark::Counter::kIsRate);
}
BENCHMARK(Trace)->ArgsProduct({{1, 4, 8, 16}, {0, 1, 2}})->Unit(benchmark::kMillisecond);

void BuildWorld(benchmark::State& state) {
  const ThreadLimit limit(1);
  const Scene scene = generate_room({}, 3);
  WorldOptions options;
  options.high_quality = state.range(0) != 0;
  for (auto _ : state) benchmark::DoNotOptimize(World(scene, options));
  state.SetLabel(options.high_quality ? "high quality" : "medium quality");
}
BENCHMARK(BuildWorld)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace scanchor

BENCHMARK_MAIN();
