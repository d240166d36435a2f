#include "perception/outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "perception/outline_contacts.hpp"
#include "perception/outline_mesh.hpp"

namespace scanchor {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// Everything that the steps share.
struct Work : OutlineMesh {
  const PointCloud& cloud;
  const Surfaces& surfaces;
  const Surface& surface;
  double gate;
  std::vector<char> goes_on_behind;  ///< by other surface: this one is seen on both sides of it
};

/// What lies beyond the edge between sample i inside and sample j outside.
EdgeKind kind_between(const Work& work, std::uint32_t i, std::uint32_t j) {
  if (work.kind[j] != SampleKind::blocked) return EdgeKind::true_edge;
  const OutlineSample& in = work.input.samples[i];
  const OutlineSample& out = work.input.samples[j];
  const Eigen::Vector3d p =
      work.input.T_cloud_plane * Eigen::Vector3d(in.plane.x(), in.plane.y(), 0.0);
  // [m] how far the next sample on the plane would have been: the angle between the rays, seen on
  // the plane.
  const Eigen::Vector2d foot = work.input.chart.sensor.head<2>();
  const double height = std::abs(work.input.chart.sensor.z());
  const double range = std::sqrt((in.plane - foot).squaredNorm() + height * height);
  double step = work.distance(i, j) * range * range / std::max(height, 1e-9);
  if (out.reachable) step = std::min(step, (in.plane - out.plane).norm());
  // Contact, not shadow, where the nearer thing meets this surface here: its plane passes through
  // the edge.
  const std::int32_t other = work.surfaces.plane_of_point[out.point];
  if (other >= 0) {
    const Plane& plane = work.surfaces.surfaces[static_cast<std::size_t>(other)].plane;
    const bool upright = std::abs(plane.normal.dot(work.input.T_cloud_plane.linear().col(2))) < 0.9;
    if (!upright || std::abs(plane.normal.dot(p) - plane.offset) > step + work.gate)
      return EdgeKind::occlusion;
    return work.goes_on_behind[static_cast<std::size_t>(other)] ? EdgeKind::occlusion
                                                                : EdgeKind::true_edge;
  }
  return (work.cloud.points[out.point] - p).norm() <= 2.0 * step + work.gate ? EdgeKind::true_edge
                                                                             : EdgeKind::occlusion;
}

/// Node half-way between a sample inside and one outside.
OutlineNode middle_node(const Work& work, std::uint32_t i, std::uint32_t j) {
  const OutlineSample& in = work.input.samples[i];
  const OutlineSample& out = work.input.samples[j];
  if (!work.input.with_view)
    return {0.5 * (in.plane + out.plane), 0.5 * (in.plane - out.plane).norm()};
  // At a far, grazing edge the next ray may land metres away or never. Then half of the spacing
  // before it has to do.
  const double height = std::max(std::abs(work.input.chart.sensor.z()), 1e-9);
  const double range =
      std::sqrt((in.plane - work.input.chart.sensor.head<2>()).squaredNorm() + height * height);
  const double reach = 0.75 * work.distance(i, j) * range * range / height;
  Eigen::Vector2d middle;
  const Eigen::Vector2d chart = 0.5 * (in.chart + out.chart);
  if (work.input.chart.to_plane(chart, middle)) {
    const double half = (middle - in.plane).norm();
    if (half <= reach) return {middle, half};
    return {in.plane + (middle - in.plane) * (reach / half), reach};
  }
  Eigen::Vector2d near;
  for (double share = 0.25; share > 1e-4; share *= 0.5) {
    if (!work.input.chart.to_plane(in.chart + share * (out.chart - in.chart), near)) continue;
    const double distance = (near - in.plane).norm();
    if (distance > 0.0)
      return {in.plane + (near - in.plane) * (std::min(distance, reach) / distance), reach};
  }
  return {in.plane, reach};
}

constexpr std::uint32_t unset = 0xffffffffU;

/// Boundary of the part inside, triangle by triangle. Nodes are made as they are met.
std::vector<BoundarySegment> march(const Work& work, Outline& outline,
                                   std::vector<std::int32_t>& node_of_sample) {
  std::vector<char> bounding(work.input.samples.size(), 0);  // sample outside, across a true edge
  const auto& triangles = work.mesh.triangles;
  const auto& neighbours = work.mesh.neighbours;
  const auto is_kept = [&](std::int32_t n) {
    return n >= 0 && work.kept[static_cast<std::size_t>(n)];
  };
  const std::vector<std::uint32_t> pieces = connected_pieces(work);
  std::vector<std::array<std::uint32_t, 3>> middle(triangles.size(), {unset, unset, unset});
  const auto vertex_node = [&](std::uint32_t s) {
    if (node_of_sample[s] < 0) {
      node_of_sample[s] = static_cast<std::int32_t>(outline.nodes.size());
      outline.nodes.push_back({work.input.samples[s].plane, 0.0});
    }
    return static_cast<std::uint32_t>(node_of_sample[s]);
  };
  const auto middle_of = [&](std::size_t n, std::size_t k) {
    if (middle[n][k] == unset) {
      std::uint32_t a = triangles[n][(k + 1) % 3];
      std::uint32_t b = triangles[n][(k + 2) % 3];
      if (!work.inside(a)) std::swap(a, b);
      middle[n][k] = static_cast<std::uint32_t>(outline.nodes.size());
      outline.nodes.push_back(middle_node(work, a, b));
      const std::int32_t m = neighbours[n][k];
      if (m >= 0) {
        for (std::size_t l = 0; l < 3; ++l) {
          if (neighbours[static_cast<std::size_t>(m)][l] == static_cast<std::int32_t>(n))
            middle[static_cast<std::size_t>(m)][l] = middle[n][k];
        }
      }
    }
    return middle[n][k];
  };
  const EdgeKind open = work.input.with_view ? EdgeKind::view_limit : EdgeKind::unknown;
  std::vector<BoundarySegment> segments;
  for (std::size_t n = 0; n < triangles.size(); ++n) {
    if (!work.kept[n]) continue;
    const Triangle& t = triangles[n];
    const std::uint32_t piece = pieces[n];
    std::uint32_t leave = unset;  // where the outline goes from inside to outside, and comes back
    std::uint32_t enter = unset;
    std::size_t from = 0;
    std::size_t to = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[(k + 1) % 3];
      const std::uint32_t b = t[(k + 2) % 3];
      const bool bare = !is_kept(neighbours[n][k]);
      if (work.inside(a) && work.inside(b)) {
        if (bare) segments.push_back({vertex_node(a), vertex_node(b), piece, open});
      } else if (work.inside(a)) {
        leave = middle_of(n, k);
        from = k;
        if (bare) segments.push_back({vertex_node(a), leave, piece, open});
      } else if (work.inside(b)) {
        enter = middle_of(n, k);
        to = k;
        if (bare) segments.push_back({enter, vertex_node(b), piece, open});
      }
    }
    if (leave == unset) continue;
    // Of two pairs the one with the farther view decides: a passed ray is certain, a blocked one is
    // not.
    const EdgeKind first = kind_between(work, t[(from + 1) % 3], t[(from + 2) % 3]);
    const EdgeKind second = kind_between(work, t[(to + 2) % 3], t[(to + 1) % 3]);
    const bool real = first == EdgeKind::true_edge || second == EdgeKind::true_edge;
    if (first == EdgeKind::true_edge) bounding[t[(from + 2) % 3]] = 1;
    if (second == EdgeKind::true_edge) bounding[t[(to + 1) % 3]] = 1;
    segments.push_back({leave, enter, piece, real ? EdgeKind::true_edge : EdgeKind::occlusion});
  }
  for (std::size_t s = 0; s < bounding.size(); ++s) {
    const OutlineSample& sample = work.input.samples[s];
    if (work.kind[s] == SampleKind::inside && !sample.thinned) {
      outline.inside.push_back(sample.plane);
      outline.inside_height.push_back(sample.height);
    }
    if (bounding[s] && sample.reachable) {
      outline.beyond.push_back(sample.plane);
      outline.beyond_height.push_back(sample.height);
    }
  }
  return segments;
}

/// Samples that border on nothing seen stand for their whole cell, half of which lies beyond the
/// triangles: along the outline each is moved outwards by half of a cell's area over the length of
/// outline that is its share. For rows along an edge that is half a spacing; where the outline cuts
/// corners of the lattice it is less. The area of the outline is then that of all cells, without
/// bias.
void widen_open_edges(const Work& work, const std::vector<std::int32_t>& node_of_sample,
                      Outline& outline) {
  const auto& samples = work.input.samples;
  std::vector<std::int32_t> sample_of_node(outline.nodes.size(), -1);
  bool any = false;
  for (std::size_t s = 0; s < samples.size(); ++s) {
    if (node_of_sample[s] < 0) continue;
    sample_of_node[static_cast<std::size_t>(node_of_sample[s])] = static_cast<std::int32_t>(s);
    any = true;
  }
  if (!any) return;
  // Two triangles make a cell. Of the triangles at a sample and at its neighbours, so that a few
  // slivers do not decide. Only the samples on the outline ask.
  std::vector<char> near(samples.size(), 0);
  std::vector<std::uint32_t> at_outline;
  for (std::uint32_t n = 0; n < work.mesh.triangles.size(); ++n) {
    const Triangle& t = work.mesh.triangles[n];
    if (!work.kept[n] ||
        std::max({node_of_sample[t[0]], node_of_sample[t[1]], node_of_sample[t[2]]}) < 0)
      continue;
    at_outline.push_back(n);
    for (const std::uint32_t s : t) near[s] = 1;
  }
  std::vector<double> area(samples.size(), 0.0);
  std::vector<int> count(samples.size(), 0);
  for (std::size_t n = 0; n < work.mesh.triangles.size(); ++n) {
    const Triangle& t = work.mesh.triangles[n];
    if (!(near[t[0]] | near[t[1]] | near[t[2]]) || !work.kept[n]) continue;
    if (work.inside_corners(t) < 3) continue;
    if (work.thinned(t[0]) || work.thinned(t[1]) || work.thinned(t[2])) continue;
    const Eigen::Vector2d u = samples[t[1]].plane - samples[t[0]].plane;
    const Eigen::Vector2d v = samples[t[2]].plane - samples[t[0]].plane;
    for (const std::uint32_t s : t) {
      area[s] += 0.5 * std::abs(u.x() * v.y() - u.y() * v.x());
      ++count[s];
    }
  }
  std::vector<double> cell(samples.size(), 0.0);
  std::vector<int> cell_count(samples.size(), 0);
  for (const std::uint32_t n : at_outline) {
    for (const std::uint32_t a : work.mesh.triangles[n]) {
      for (const std::uint32_t b : work.mesh.triangles[n]) {
        cell[a] += area[b];
        cell_count[a] += count[b];
      }
    }
  }
  std::vector<Eigen::Vector2d> moved(outline.nodes.size(), Eigen::Vector2d::Zero());
  for (const BoundaryRing& ring : outline.rings) {
    const std::size_t size = ring.nodes.size();
    for (std::size_t i = 0; i < size; ++i) {
      const std::uint32_t node = ring.nodes[i];
      if (sample_of_node[node] < 0) continue;
      const auto s = static_cast<std::size_t>(sample_of_node[node]);
      if (cell_count[s] == 0) continue;
      const Eigen::Vector2d& here = outline.nodes[node].position;
      const Eigen::Vector2d& after = outline.nodes[ring.nodes[(i + 1) % size]].position;
      const Eigen::Vector2d& before = outline.nodes[ring.nodes[(i + size - 1) % size]].position;
      const Eigen::Vector2d along = after - before;
      const double length = along.norm();
      const double share = 0.5 * ((after - here).norm() + (here - before).norm());
      if (length == 0.0 || share == 0.0) continue;
      const Eigen::Vector2d outward(along.y() / length,
                                    -along.x() / length);  // the region lies on the left
      const double whole = 2.0 * cell[s] / cell_count[s];
      const double half = std::min(0.5 * whole / share, 0.75 * share);
      outline.nodes[node].half_gap = std::max(half, 0.5 * std::sqrt(whole));
      moved[node] = half * outward;
    }
  }
  for (std::size_t n = 0; n < moved.size(); ++n) outline.nodes[n].position += moved[n];
}

}  // namespace

Outline find_outline(const PointCloud& cloud, const Surfaces& surfaces, const Surface& surface,
                     const OutlineSamples& samples, double gate) {
  Work work{outline_mesh(samples), cloud, surfaces, surface, gate, {}};
  Outline outline;
  if (work.mesh.triangles.empty()) return outline;
  if (samples.with_view) work.goes_on_behind = goes_on_behind(surfaces, samples, gate);
  outline.spacing = work.spacing;

  std::vector<std::int32_t> node_of_sample(samples.samples.size(), -1);
  const std::vector<BoundarySegment> segments = march(work, outline, node_of_sample);
  std::vector<Eigen::Vector2d> positions(outline.nodes.size());
  for (std::size_t i = 0; i < positions.size(); ++i) positions[i] = outline.nodes[i].position;
  outline.rings = chain_rings(positions, segments);
  widen_open_edges(work, node_of_sample, outline);
  return outline;
}

}  // namespace scanchor
