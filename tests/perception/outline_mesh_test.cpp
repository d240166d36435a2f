#include "perception/outline_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace scanchor {
namespace {

/// Samples a metre apart, all over as with a view.
OutlineSamples lattice(int columns, int rows, double x = 0.0) {
  OutlineSamples samples;
  samples.with_view = true;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      OutlineSample s;
      s.plane = {x + i + 0.01 * ((7 * i + 3 * j) % 5), j + 0.01 * ((3 * i + 5 * j) % 7)};
      s.chart = s.plane;
      s.metric = {s.plane.x(), s.plane.y(), 0.0};
      samples.samples.push_back(s);
    }
  }
  return samples;
}

TEST(OutlineMesh, AGapIsNotSpannedAndPartsThePieces) {
  OutlineSamples samples = lattice(6, 6);
  const OutlineSamples other = lattice(6, 6, 12.0);
  samples.samples.insert(samples.samples.end(), other.samples.begin(), other.samples.end());
  const OutlineMesh mesh = outline_mesh(samples);
  EXPECT_NEAR(mesh.spacing, 1.41, 0.1) << "the longest side of a triangle";
  const auto pieces = connected_pieces(mesh);
  std::set<std::uint32_t> found;
  for (std::size_t n = 0; n < mesh.mesh.triangles.size(); ++n) {
    const auto& t = mesh.mesh.triangles[n];
    const auto right = std::count_if(t.begin(), t.end(), [](auto s) { return s >= 36; });
    if (right == 1 || right == 2) {
      EXPECT_EQ(mesh.kept[n], 0) << "over the gap";
    }
    if (mesh.kept[n] != 0) found.insert(pieces[n]);
  }
  EXPECT_EQ(found.size(), 2U);
}

TEST(OutlineMesh, ALoneMissIsNoHoleAndTwoAre) {
  OutlineSamples samples = lattice(7, 7);
  samples.samples[24].kind = SampleKind::passed;  // the middle
  EXPECT_TRUE(outline_mesh(samples).inside(24));
  samples.samples[25].kind = SampleKind::passed;  // beside it
  const OutlineMesh mesh = outline_mesh(samples);
  EXPECT_FALSE(mesh.inside(24));
  EXPECT_FALSE(mesh.inside(25));
}

TEST(OutlineMesh, SamplesOnALineMakeNoTriangles) {
  OutlineSamples samples;
  for (int i = 0; i < 5; ++i) {
    OutlineSample s;
    s.chart = s.plane = {i, 2 * i};
    samples.samples.push_back(s);
  }
  EXPECT_TRUE(outline_mesh(samples).mesh.triangles.empty());
}

}  // namespace
}  // namespace scanchor
