// find_planes on the reference room: CPU time by method and size, memory and quality beside it.
//   planes_bench --benchmark_filter=default

#include <benchmark/benchmark.h>
#include <malloc.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <map>
#include <new>

#include "core/parallel.hpp"
#include "perception/perceive.hpp"
#include "tests/perception/support/plane_score.cpp"
#include "tests/perception/support/room.cpp"

namespace {

// Bytes on the heap, now and at most: every allocation of this program passes here.
std::atomic<std::int64_t> heap_now{0}, heap_most{0};

void* counted_allocation(std::size_t size) {
  void* place = std::malloc(size);
  if (place == nullptr) std::abort();
  const auto now = heap_now += static_cast<std::int64_t>(malloc_usable_size(place));
  auto most = heap_most.load();
  while (now > most && !heap_most.compare_exchange_weak(most, now)) {
  }
  return place;
}

void counted_free(void* place) {
  if (place == nullptr) return;
  heap_now -= static_cast<std::int64_t>(malloc_usable_size(place));
  std::free(place);
}

}  // namespace

void* operator new(std::size_t size) { return counted_allocation(size); }
void* operator new[](std::size_t size) { return counted_allocation(size); }
void operator delete(void* place) noexcept { counted_free(place); }
void operator delete[](void* place) noexcept { counted_free(place); }
void operator delete(void* place, std::size_t) noexcept { counted_free(place); }
void operator delete[](void* place, std::size_t) noexcept { counted_free(place); }

namespace {

using namespace scanchor;

// A scan of about `count` points of room 0, in random order; kept, since casting rays costs more
// than finding planes.
const support::RoomScan& scan_of(std::int64_t count, int sigma_mm) {
  static std::map<std::pair<std::int64_t, int>, support::RoomScan> scans;
  const auto found = scans.find({count, sigma_mm});
  if (found != scans.end()) return found->second;
  support::RayGrid grid;
  const double scale = std::sqrt(static_cast<double>(count) / 100000.0);
  grid.beams = static_cast<int>(std::lround(500 * scale));
  grid.lines = static_cast<int>(std::lround(200 * scale));
  grid.range_sigma = 0.001 * sigma_mm;
  return scans[{count, sigma_mm}] =
             support::shuffled(support::scan_boxes(support::reference_room(0), grid), 7);
}

void planes(benchmark::State& state, const std::string& method, int threads) {
  const ThreadLimit limit(threads);
  const auto& scan = scan_of(state.range(0), static_cast<int>(state.range(1)));
  PerceiveOptions options;
  options.method = method;
  options.shapes = false;
  Surfaces surfaces;
  std::int64_t most = 0;
  for (auto _ : state) {
    surfaces = Surfaces{};
    const auto before = heap_now.load();
    heap_most = before;
    surfaces = find_planes(scan.cloud, options);
    most = std::max(most, heap_most.load() - before);
  }
  const auto score =
      support::score_planes(scan.plane, surfaces.plane_of_point, 0.8, scan.plane.size() / 2000);
  state.counters["correct"] = score.correct;
  state.counters["of"] = score.planes;
  state.counters["adjRec"] = score.recall;
  state.counters["bytes_per_point"] =
      static_cast<double>(most) / static_cast<double>(scan.plane.size());
  state.SetComplexityN(state.range(0));
}

void sizes(benchmark::internal::Benchmark* bench) {
  for (const std::int64_t count : {20000, 100000, 300000, 1000000, 10000000})
    bench->Args({count, 10});
  bench->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
}

BENCHMARK_CAPTURE(planes, default_1_thread, "default", 1)->Apply(sizes)->Complexity();
BENCHMARK_CAPTURE(planes, default_2_threads, "default", 2)
    ->Args({100000, 10})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(planes, default_noise, "default", 1)
    ->ArgsProduct({{100000}, {0, 5, 10, 20, 40}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(planes, paper_1_thread, "paper", 1)
    ->Args({100000, 10})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();

}  // namespace

BENCHMARK_MAIN();
