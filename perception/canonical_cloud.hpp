#pragma once
// The points in an order and a frame that are properties of the points alone: whatever order they
// came in and wherever they stood, the same steps follow. Everything else in find_planes works on
// this copy.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

namespace scanchor {

/// Points moved to their own principal frame, as floats, in the order of their Morton codes (G. M.
/// Morton 1966: the bits of the three coordinates interleaved), ties by x, y, z; equal points are
/// kept once.
/// * Permutation: all sums over points are sums of integers, so the frame has the same bits for
/// every order of the input.
/// * Rigid motion: origin and axes move along with the points (axes by falling variance, signs by
/// the third moment), so the
///   coordinates here stay the same up to rounding. Where two variances are equal (a sphere) the
///   axes are arbitrary.
/// * Far from the origin: the shift happens in double precision, the floats hold 2^-24 of the
/// cloud's extent.
struct CanonicalCloud {
  static constexpr int levels = 16;   ///< of the octree below the root: codes have 48 bits
  std::vector<float> x, y, z;         ///< [m] in the principal frame
  std::vector<float> inverse_range;   ///< [1/m] from the sensor; 0: its place is not known
  std::vector<std::uint64_t> code;    ///< Morton codes, rising
  std::vector<std::uint32_t> source;  ///< indices into the cloud, grouped by point
  std::vector<std::uint32_t>
      first;  ///< point i stands for source[first[i] .. first[i + 1]); size() + 1 entries
  Eigen::Vector3f low = Eigen::Vector3f::Zero();  ///< corner of the root cell
  float side = 1.0F;                              ///< [m] of the root cell
  Eigen::Isometry3d T_cloud_canonical = Eigen::Isometry3d::Identity();

  [[nodiscard]] std::size_t size() const { return x.size(); }
  [[nodiscard]] Eigen::Vector3f point(std::size_t i) const { return {x[i], y[i], z[i]}; }
  /// [m] side of the cells of a level, 0: root.
  [[nodiscard]] float cell_side(int level) const { return side / static_cast<float>(1U << level); }
};

/// `index`: the points to take. Time O(n), memory 28 bytes a point and as much again while it runs.
CanonicalCloud canonical_cloud(const std::vector<Eigen::Vector3d>& points,
                               const std::vector<std::uint32_t>& index);

/// Fills `inverse_range` for a sensor at this place (canonical frame).
void see_from(const Eigen::Vector3d& sensor, CanonicalCloud& cloud);

/// Spreads the low 16 bits of `v` to every third bit.
constexpr std::uint64_t spread_bits(std::uint64_t v) {
  v &= 0xFFFF;
  v = (v | (v << 16)) & 0x0000FF0000FFULL;
  v = (v | (v << 8)) & 0x00F00F00F00FULL;
  v = (v | (v << 4)) & 0x0C30C30C30C3ULL;
  v = (v | (v << 2)) & 0x249249249249ULL;
  return v;
}

}  // namespace scanchor
