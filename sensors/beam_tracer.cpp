#include "sensors/beam_tracer.hpp"

#include <algorithm>
#include <cmath>

#include "sensors/optics.hpp"

namespace scanchor {
namespace {

// Flatter than this, a sub-ray can leave the face within the footprint and the plane is no answer.
constexpr double flattest_cosine = 0.01;

/// Columns of rays that own their memory.
struct RayBuffer {
  std::vector<double> c[6];
  std::vector<std::uint32_t> triangle;
  std::vector<double> range;

  void trace(const World& world, std::size_t count) {
    triangle.resize(count);
    range.resize(count);
    world.trace(
        {c[0].data(), c[1].data(), c[2].data(), c[3].data(), c[4].data(), c[5].data(), count},
        triangle.data(), range.data());
  }
  void resize(std::size_t count) {
    for (auto& column : c) column.resize(count);
  }
  void set(std::size_t i, const Ray& ray) {
    for (int axis = 0; axis < 3; ++axis) {
      c[axis][i] = ray.origin[axis];
      c[3 + axis][i] = ray.direction[axis];
    }
  }
};

}  // namespace

BeamTracer::BeamTracer(const World& world, const LidarOptions& options, std::uint64_t seed)
    : world_(world), options_(options), footprint_(options, seed) {}

void BeamTracer::trace_middles(const BeamColumns& w, LineReturns& r) const {
  const std::size_t count = w.origin_x.size();
  r.resize(count);
  world_.trace({w.origin_x.data(), w.origin_y.data(), w.origin_z.data(), w.direction_x.data(),
                w.direction_y.data(), w.direction_z.data(), count},
               r.triangle.data(), r.range.data());
  const auto& surfaces = world_.surfaces();
  for (std::size_t k = 0; k < count; ++k) {
    r.runner_up[k] = no_hit;
    r.flags[k] = 0;
    if (r.triangle[k] == no_hit) continue;
    const SurfaceRecord& s = surfaces[r.triangle[k]];
    const double slope = s.plane.normal.x() * w.direction_x[k] +
                         s.plane.normal.y() * w.direction_y[k] +
                         s.plane.normal.z() * w.direction_z[k];
    r.cosine[k] = std::min(std::fabs(slope), 1.0);
    r.reflected[k] = s.reflectance * r.cosine[k];
    r.true_range[k] = r.range[k];
  }
}

void BeamTracer::store(const Echo& echo, std::size_t k, LineReturns& r) {
  r.range[k] = echo.range;
  r.true_range[k] = echo.true_range;
  r.cosine[k] = echo.cosine;
  r.reflected[k] = echo.reflected;
  r.triangle[k] = echo.triangle;
  r.runner_up[k] = echo.runner_up;
  r.flags[k] = echo.flags;
}

void BeamTracer::one_plane(int line, std::size_t k, const BeamColumns& beams, LineReturns& returns,
                           std::vector<Sample>& samples) const {
  const SurfaceRecord& s = world_.surfaces()[returns.triangle[k]];
  const Eigen::Vector3d origin = beams.origin(k);
  const Eigen::Vector3d direction = beams.direction(k);
  const auto axes = footprint_.axes(direction, line, static_cast<int>(k));
  const double share = 1.0 / static_cast<double>(footprint_.size());
  samples.clear();
  for (std::size_t i = 0; i < footprint_.size(); ++i) {
    const Ray ray = footprint_.subray(origin, direction, axes, i);
    const double range = world_.range_to(returns.triangle[k], ray.origin, ray.direction);
    const double cosine = std::min(std::fabs(s.plane.normal.dot(ray.direction)), 1.0);
    samples.push_back(
        {range, share * s.reflectance * cosine, cosine, returns.triangle[k], s.face, 0});
  }
  store(resolve_echo(options_, samples), k, returns);
}

void BeamTracer::follow(std::vector<Stretch>& stretches, std::vector<BeamSample>& samples) const {
  const auto& surfaces = world_.surfaces();
  RayBuffer rays;
  std::vector<Stretch> next;
  for (int passage = 0; !stretches.empty(); ++passage) {
    rays.resize(stretches.size());
    for (std::size_t i = 0; i < stretches.size(); ++i) rays.set(i, stretches[i].ray);
    rays.trace(world_, stretches.size());
    next.clear();
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      if (rays.triangle[i] == no_hit) continue;
      const Stretch& s = stretches[i];
      const SurfaceRecord& surface = surfaces[rays.triangle[i]];
      const double slope = surface.plane.normal.dot(s.ray.direction);
      const double cosine = std::min(std::fabs(slope), 1.0);
      LightSplit split{surface.reflectance, 0.0, 0.0};
      if (!surface.plain) {
        split = split_light(
            options_, world_.scene().materials[static_cast<std::size_t>(surface.material)], cosine);
      }
      const double range = s.travelled + rays.range[i];
      if (split.own > 0.0) {
        samples.push_back({s.beam,
                           {range, s.weight * split.own * cosine, cosine, rays.triangle[i],
                            surface.face, s.flags}});
      }
      if (passage >= options_.bounces) continue;
      const Eigen::Vector3d point = s.ray.origin + rays.range[i] * s.ray.direction;
      if (split.through > 0.0) {
        next.push_back({{point, s.ray.direction},
                        s.beam,
                        s.weight * split.through,
                        range,
                        static_cast<std::uint8_t>(s.flags | point_behind_glass)});
      }
      if (split.mirrored > 0.0) {
        const Eigen::Vector3d d = s.ray.direction - 2.0 * slope * surface.plane.normal;
        next.push_back({{point, d},
                        s.beam,
                        s.weight * split.mirrored,
                        range,
                        static_cast<std::uint8_t>(s.flags | point_ghost)});
      }
    }
    stretches.swap(next);
  }
}

void BeamTracer::refine(int line, const BeamColumns& beams, std::span<const std::uint8_t> straddles,
                        LineReturns& returns) const {
  const auto& surfaces = world_.surfaces();
  std::vector<Stretch> stretches;
  std::vector<Sample> plane_samples;
  std::vector<std::uint32_t> traced;
  const double share = 1.0 / static_cast<double>(footprint_.size());
  for (std::size_t k = 0; k < returns.size(); ++k) {
    const bool hit = returns.triangle[k] != no_hit;
    const bool plain = !hit || surfaces[returns.triangle[k]].plain;
    bool all = !plain;
    if (has_footprint()) {
      all = all || straddles[k] != 0 || (hit && returns.cosine[k] < flattest_cosine);
      if (hit && !all) one_plane(line, k, beams, returns, plane_samples);
    }
    if (!all) continue;
    traced.push_back(static_cast<std::uint32_t>(k));
    const Eigen::Vector3d origin = beams.origin(k);
    const Eigen::Vector3d direction = beams.direction(k);
    const auto axes = footprint_.axes(direction, line, static_cast<int>(k));
    for (std::size_t i = 0; i < footprint_.size(); ++i) {
      stretches.push_back({footprint_.subray(origin, direction, axes, i),
                           static_cast<std::uint32_t>(k), share, 0.0, 0});
    }
  }
  if (traced.empty()) return;
  std::vector<BeamSample> samples;
  follow(stretches, samples);
  // By beam, and within a beam in the order in which they were made: the order of sub-rays, then of
  // passages.
  std::stable_sort(samples.begin(), samples.end(),
                   [](const BeamSample& a, const BeamSample& b) { return a.beam < b.beam; });
  std::size_t next = 0;
  for (const std::uint32_t k : traced) {
    plane_samples.clear();
    for (; next < samples.size() && samples[next].beam == k; ++next) {
      plane_samples.push_back(samples[next].sample);
    }
    store(resolve_echo(options_, plane_samples), k, returns);
  }
}

}  // namespace scanchor
