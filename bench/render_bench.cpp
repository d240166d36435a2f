// Time of a frame of 1280 x 720 with 100,000 points and 50,000 triangles.
//   build: cmake -DSCANCHOR_BENCH=ON; run: render_bench

#include <benchmark/benchmark.h>

#include <cmath>

#include "core/math.hpp"
#include "core/random.hpp"
#include "results/render.hpp"

namespace {

using namespace scanchor;

/// A room's worth of points on six walls and 50,000 triangles on balls that stand in it.
const Drawing& busy_room() {
  static const Drawing drawing = [] {
    Drawing d;
    d.title = "A frame to be timed";
    SequentialRandom random(1);
    DrawnPoints points;
    const Eigen::Vector3d size(6.0, 5.0, 2.8);
    for (int i = 0; i < 100000; ++i) {
      Eigen::Vector3d p(random.uniform(0, size.x()), random.uniform(0, size.y()),
                        random.uniform(0, size.z()));
      const int axis = i % 3;
      p[axis] = i % 2 == 0 ? 0.0 : size[axis];
      points.positions.push_back(p);
      points.colors.push_back(color_map(ColorMap::cividis, p.z() / size.z()));
    }
    points.size_px = 2.0;
    d.points.push_back(std::move(points));
    constexpr int rings = 25, slices = 50, balls = 20;  // 2 x 25 x 50 x 20 triangles
    DrawnMesh mesh;
    for (int b = 0; b < balls; ++b) {
      const Eigen::Vector3d center(random.uniform(0.5, 5.5), random.uniform(0.5, 4.5),
                                   random.uniform(0.3, 2.0));
      const auto first = static_cast<int>(mesh.vertices.size());
      for (int r = 0; r <= rings; ++r) {
        for (int s = 0; s <= slices; ++s) {
          const double theta = pi * r / rings, phi = 2.0 * pi * s / slices;
          const Eigen::Vector3d n(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                                  std::cos(theta));
          mesh.vertices.push_back(center + 0.3 * n);
          mesh.normals.push_back(n);
          mesh.colors.push_back(Color{static_cast<std::uint8_t>(40 + 10 * b), 120, 160});
        }
      }
      for (int r = 0; r < rings; ++r) {
        for (int s = 0; s < slices; ++s) {
          const int a = first + r * (slices + 1) + s, c = a + slices + 1;
          mesh.triangles.emplace_back(a, c, a + 1);
          mesh.triangles.emplace_back(a + 1, c, c + 1);
        }
      }
    }
    d.meshes.push_back(std::move(mesh));
    d.bounds = bounds_of(d);
    return d;
  }();
  return drawing;
}

void frame(benchmark::State& state) {
  const Drawing& drawing = busy_room();
  RenderOptions options;
  options.samples = static_cast<int>(state.range(0));
  const View view = framed_view(drawing, options, ViewKind::perspective, 225.0, 35.0);
  for (auto _ : state) benchmark::DoNotOptimize(render(drawing, view, options));
}
BENCHMARK(frame)
    ->ArgName("samples")
    ->Arg(1)
    ->Arg(4)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

void nothing(benchmark::State& state) {
  const Drawing drawing;
  const RenderOptions options;
  for (auto _ : state) benchmark::DoNotOptimize(render(drawing, View{}, options));
}
BENCHMARK(nothing)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
