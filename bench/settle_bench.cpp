// Rooms a second: generation and settling, by family, one room after the other on one core. A
// thousand rooms of the mix in 60 s on two cores need at most 120 ms a room here.

#include <benchmark/benchmark.h>

#include <chrono>

#include "core/parallel.hpp"
#include "scenes/generator.hpp"
#include "sim/settle.hpp"

namespace scanchor {
namespace {

void Settle(benchmark::State& state) {
  const ThreadLimit limit(1);
  RoomOptions options;
  options.family = room_families()[static_cast<std::size_t>(state.range(0))];
  double generating = 0.0, settling = 0.0, simulated = 0.0, loose = 0.0, settled = 0.0;
  std::uint64_t seed = 0;
  const auto now = [] { return std::chrono::steady_clock::now(); };
  for (auto _ : state) {
    const auto start = now();
    Scene scene = generate_room(options, ++seed);
    const auto middle = now();
    const SettleReport report = settle(scene, {});
    generating += std::chrono::duration<double>(middle - start).count();
    settling += std::chrono::duration<double>(now() - middle).count();
    simulated += report.simulated_time;
    loose += static_cast<double>(report.loose);
    settled += report.settled ? 1.0 : 0.0;
  }
  const auto rooms = static_cast<double>(state.iterations());
  state.SetLabel(options.family);
  state.counters["generate_ms"] = 1e3 * generating / rooms;
  state.counters["settle_ms"] = 1e3 * settling / rooms;
  state.counters["simulated_s"] = simulated / rooms;
  state.counters["loose"] = loose / rooms;
  state.counters["settled"] = settled / rooms;
}

void all_families() {
  for (std::size_t f = 0; f < room_families().size(); ++f) {
    benchmark::RegisterBenchmark("Settle", Settle)
        ->Arg(static_cast<int>(f))
        ->Iterations(20)
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace
}  // namespace scanchor

int main(int argc, char** argv) {
  scanchor::all_families();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
