#include "perception/surfels.hpp"

#include <algorithm>
#include <cmath>

#include "core/parallel.hpp"

namespace scanchor {
namespace {

struct Patch {
  std::vector<float> x, y, z;  // the first `size` count
  std::size_t size = 0;

  // Takes the points of a cell that lie in a ball. Each is written down and kept or not: that is
  // quicker than to ask first.
  void take(const CanonicalCloud& c, const Cell& cell, const Eigen::Vector3f& center,
            float radius2) {
    if (x.size() < size + cell.size()) {
      for (auto* v : {&x, &y, &z}) v->resize(2 * (size + cell.size()));
    }
    for (auto p = cell.begin; p < cell.end; ++p) {
      const float dx = c.x[p] - center.x(), dy = c.y[p] - center.y(), dz = c.z[p] - center.z();
      x[size] = c.x[p];
      y[size] = c.y[p];
      z[size] = c.z[p];
      size += dx * dx + dy * dy + dz * dz <= radius2 ? 1 : 0;
    }
  }
};

Surfel fit_surfel(const Patch& patch, const BeamNoise& noise) {
  constexpr double breadth = 4.0, fewest = 6.0;
  Surfel surfel;
  Moments moments;
  for (std::size_t i = 0; i < patch.size; ++i) moments.add(patch.x[i], patch.y[i], patch.z[i]);
  MomentPlane plane;
  bool settled = false;  // the plane is that of `moments`
  for (int round = 0; round < 2 && !settled; ++round) {
    if (moments.n < fewest) return surfel;
    plane = fit_plane_fast(moments);
    const double reach = 2.5 * noise.across(plane, moments.mean());
    Moments next;
    double score = 0.0;
    for (std::size_t i = 0; i < patch.size; ++i) {
      const double r = plane.distance({patch.x[i], patch.y[i], patch.z[i]}) / reach;
      if (std::abs(r) > 1.0) continue;
      next.add(patch.x[i], patch.y[i], patch.z[i]);
      score += 1.0 - r * r;
    }
    surfel.score = score / static_cast<double>(patch.size);
    // All of the patch lies on it: another round would find the same.
    settled = round == 0 && next.n == moments.n;
    moments = next;
  }
  if (moments.n < fewest) return surfel;
  surfel.grown = settled ? grown_plane(moments, plane, noise) : grown_plane(moments, noise);
  const auto& v = surfel.grown.plane.variances;
  // The points of one line of the sweep lie in a plane with the sensor, which is none of theirs.
  if (v[1] >= breadth * v[0] && !noise.is_edge_on(surfel.grown.plane, moments.mean()))
    surfel.tilt = noise.across(surfel.grown.plane, moments.mean()) / std::sqrt(moments.n * v[1]);
  return surfel;
}

}  // namespace

std::vector<Surfel> fit_surfels(const PointPool& pool, const BeamNoise& noise) {
  std::vector<Surfel> surfels(pool.leaf.size());
  const auto& c = pool.cloud;
  parallel_blocks(pool.leaf.size(), 512, [&](std::size_t begin, std::size_t end) {
    Patch patch;
    for (auto l = static_cast<std::uint32_t>(begin); l < end; ++l) {
      const Eigen::Vector3f center = pool.tree.moments[pool.leaf[l]].mean().cast<float>();
      const float side = c.cell_side(pool.cell(l).level);
      const float radius = std::max(1.2F * side, static_cast<float>(3.0 * noise.sigma));
      patch.size = 0;
      patch.take(c, pool.cell(l), center, radius * radius);
      for (auto k = pool.start[l]; k < pool.start[l + 1]; ++k)
        patch.take(c, pool.cell(pool.to[k]), center, radius * radius);
      surfels[l] = fit_surfel(patch, noise);
    }
  });
  return surfels;
}

bool continues(const GrownPlane& plane, const Surfel& patch, const BeamNoise& noise) {
  // Most that do not are far off: neither more than a radian nor 4.4 sigma can be made up for.
  constexpr double least_cosine = 0.54, most_sigma = 4.4;
  const double cosine = std::abs(plane.plane.normal.dot(patch.grown.plane.normal));
  if (cosine < least_cosine) return false;
  const Eigen::Vector3d center = patch.grown.moments.mean();
  const double distance = std::abs(plane.plane.distance(center));
  if (distance > most_sigma * noise.sigma) return false;
  const Eigen::Vector3d out = center - plane.moments.mean();
  const double u = plane.plane.axes.col(1).dot(out), v = plane.plane.axes.col(2).dot(out);
  const double sigma = noise.across(plane.plane, center), sigma2 = sigma * sigma;
  const double lever = 1.0 + u * u / std::max(plane.plane.variances[1], 1e-30) +
                       v * v / std::max(plane.plane.variances[2], 1e-30);
  const double variance =
      sigma2 / patch.grown.moments.n + std::min(lever / plane.moments.n, 1.0) * sigma2;
  // A tenth of the noise and two degrees for surfaces that are no mathematical planes.
  if (distance > 3.0 * std::sqrt(variance) + 0.1 * sigma) return false;
  const double tilt2 = patch.tilt * patch.tilt +
                       sigma2 / (plane.moments.n * std::max(plane.plane.variances[1], 1e-30));
  const double angle = 3.0 * std::sqrt(tilt2) + 0.035;
  return cosine > std::cos(std::min(angle, 1.0));
}

}  // namespace scanchor
