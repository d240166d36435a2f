#pragma once
// The triangles between the samples of a surface: which of them stand for something measured.

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <vector>

#include "perception/alpha_triangulation.hpp"
#include "perception/outline_samples.hpp"

namespace scanchor {

/// Samples of a surface and the triangles between them. The samples must outlive it.
struct OutlineMesh {
  using Triangle = std::array<std::uint32_t, 3>;
  const OutlineSamples& input;
  Triangulation mesh;
  std::vector<Eigen::Vector3d> metric;  ///< of each sample, close together in memory
  std::vector<SampleKind> kind;         ///< of each sample, specks corrected
  std::vector<double> scale;  ///< longest side that a triangle at the sample may have; empty: limit
  double limit = 0.0;         ///< the same for all samples
  std::vector<char> kept;     ///< triangle stands for something measured and has a corner inside
  double spacing = 0.0;

  [[nodiscard]] bool inside(std::uint32_t s) const { return kind[s] == SampleKind::inside; }
  [[nodiscard]] bool thinned(std::uint32_t s) const { return input.samples[s].thinned; }
  [[nodiscard]] int inside_corners(const Triangle& t) const {
    return inside(t[0]) + inside(t[1]) + inside(t[2]);
  }
  [[nodiscard]] double distance(std::uint32_t a, std::uint32_t b) const {
    return (metric[a] - metric[b]).norm();
  }
  /// Square of the longest side.
  [[nodiscard]] double longest_square(const Triangle& t) const {
    const Eigen::Vector3d &a = metric[t[0]], &b = metric[t[1]], &c = metric[t[2]];
    return std::max({(a - b).squaredNorm(), (b - c).squaredNorm(), (c - a).squaredNorm()});
  }
};

/// Triangulates the samples, takes lone stray returns for what is all around them, measures the
/// spacing and keeps the triangles that span no more than 2.5 times as much. No triangles where the
/// samples lie on a line.
OutlineMesh outline_mesh(const OutlineSamples& samples);

/// Of each triangle that is kept: the first of those that hang together with it over sides that
/// touch the inside.
std::vector<std::uint32_t> connected_pieces(const OutlineMesh& mesh);

}  // namespace scanchor
