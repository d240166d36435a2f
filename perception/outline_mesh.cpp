#include "perception/outline_mesh.hpp"

#include <algorithm>
#include <cmath>

namespace scanchor {
namespace {

using Triangle = OutlineMesh::Triangle;

double median(std::vector<double>& values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// A lone ray that missed although all around it met the surface is a stray return, not a hole.
void correct_specks(OutlineMesh& work) {
  const auto& samples = work.input.samples;
  work.kind.resize(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) work.kind[i] = samples[i].kind;
  std::vector<char> seen(samples.size(), 0);     // sample outside
  std::vector<char> company(samples.size(), 0);  // sample outside with a neighbour outside
  for (std::size_t n = 0; n < work.mesh.triangles.size(); ++n) {
    const Triangle& t = work.mesh.triangles[n];
    const int in = work.inside_corners(t);
    if (in == 3) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      if (!work.inside(t[k])) (in < 2 ? company : seen)[t[k]] = 1;
      // On the hull a ray outside may have neighbours inside only; it is evidence all the same.
      if (work.mesh.neighbours[n][k] < 0) company[t[(k + 1) % 3]] = company[t[(k + 2) % 3]] = 1;
    }
  }
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (seen[i] && !company[i] && samples[i].reachable) work.kind[i] = SampleKind::inside;
  }
}

/// The spacing of the samples. With a view, rays are spread evenly and the median triangle tells it
/// for the whole surface. Without, the spacing changes along the surface: median of the edges at a
/// sample, then the median over its neighbours, so that the few long edges that span a gap do not
/// speak for it.
void measure_scale(OutlineMesh& work) {
  const auto& samples = work.input.samples;
  std::vector<double> longest;
  for (const Triangle& t : work.mesh.triangles) {
    if (work.inside_corners(t) == 3 && !work.thinned(t[0]) && !work.thinned(t[1]) &&
        !work.thinned(t[2]))
      longest.push_back(work.longest_square(t));
  }
  if (longest.empty()) {
    for (const Triangle& t : work.mesh.triangles) longest.push_back(work.longest_square(t));
  }
  work.spacing = std::sqrt(median(longest));
  constexpr double bridged =
      2.5;  // one missing sample between two doubles a side; two do not count as neighbours
  work.limit = bridged * work.spacing;
  if (work.input.with_view) return;

  work.scale.assign(samples.size(), work.limit);
  std::vector<std::uint32_t> begin(samples.size() + 1, 0);
  for (const Triangle& t : work.mesh.triangles) {
    for (const std::uint32_t s : t) begin[s + 1] += 2;
  }
  for (std::size_t i = 0; i < samples.size(); ++i) begin[i + 1] += begin[i];
  std::vector<std::uint32_t> neighbour(begin.back());
  std::vector<std::uint32_t> fill(begin.begin(), begin.end() - 1);
  for (const Triangle& t : work.mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      neighbour[fill[t[k]]++] = t[(k + 1) % 3];
      neighbour[fill[t[k]]++] = t[(k + 2) % 3];
    }
  }
  std::vector<double> own(samples.size(), 0.0);
  std::vector<double> values;
  for (std::uint32_t i = 0; i < samples.size(); ++i) {
    values.clear();
    for (std::uint32_t k = begin[i]; k < begin[i + 1]; ++k)
      values.push_back(work.distance(i, neighbour[k]));
    own[i] = median(values);
  }
  for (std::uint32_t i = 0; i < samples.size(); ++i) {
    values.clear();
    for (std::uint32_t k = begin[i]; k < begin[i + 1]; ++k) values.push_back(own[neighbour[k]]);
    if (!values.empty())
      work.scale[i] = bridged * std::max(median(values), std::min(own[i], 2.0 * median(values)));
  }
}

void choose_triangles(OutlineMesh& work) {
  work.kept.resize(work.mesh.triangles.size());
  for (std::size_t n = 0; n < work.mesh.triangles.size(); ++n) {
    const Triangle& t = work.mesh.triangles[n];
    const int in = work.inside_corners(t);
    if (in == 0) continue;
    // A thinned sample has all eight cells around it full: its triangles span nothing.
    const bool deep = in == 3 && (work.thinned(t[0]) || work.thinned(t[1]) || work.thinned(t[2]));
    double limit = work.limit;
    if (!work.scale.empty())
      limit = std::max({work.scale[t[0]], work.scale[t[1]], work.scale[t[2]]});
    work.kept[n] = deep || work.longest_square(t) <= limit * limit;
  }
}

}  // namespace

OutlineMesh outline_mesh(const OutlineSamples& samples) {
  OutlineMesh work{samples, {}, {}, {}, {}, 0.0, {}, 0.0};
  std::vector<Eigen::Vector2d> chart(samples.samples.size());
  work.metric.resize(chart.size());
  for (std::size_t i = 0; i < chart.size(); ++i) {
    chart[i] = samples.samples[i].chart;
    work.metric[i] = samples.samples[i].metric;
  }
  work.mesh = delaunay(chart);
  if (work.mesh.triangles.empty()) return work;
  correct_specks(work);
  measure_scale(work);
  choose_triangles(work);
  return work;
}

std::vector<std::uint32_t> connected_pieces(const OutlineMesh& work) {
  const auto& triangles = work.mesh.triangles;
  const auto& neighbours = work.mesh.neighbours;
  constexpr std::uint32_t none = 0xffffffffU;
  std::vector<std::uint32_t> piece(triangles.size(), none);
  std::vector<std::uint32_t> todo;
  for (std::uint32_t first = 0; first < triangles.size(); ++first) {
    if (!work.kept[first] || piece[first] != none) continue;
    piece[first] = first;
    todo.push_back(first);
    while (!todo.empty()) {
      const std::uint32_t n = todo.back();
      todo.pop_back();
      for (std::size_t k = 0; k < 3; ++k) {
        const std::int32_t m = neighbours[n][k];
        if (m < 0 || !work.kept[static_cast<std::size_t>(m)]) continue;
        std::uint32_t& other = piece[static_cast<std::size_t>(m)];
        if (other != none ||
            (!work.inside(triangles[n][(k + 1) % 3]) && !work.inside(triangles[n][(k + 2) % 3])))
          continue;
        other = first;
        todo.push_back(static_cast<std::uint32_t>(m));
      }
    }
  }
  return piece;
}

}  // namespace scanchor
