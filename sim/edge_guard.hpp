#pragma once
// Rays that pass an edge closer than single precision can tell: Embree may give them to either
// side, depending on the processor and on their neighbours in a packet. They are found out here,
// and decided in double precision. Private to sim/world.cpp.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

namespace scanchor {

/// Embree gets every triangle a little larger than it is, by more than its rounding: a ray near an
/// edge then surely meets the rim of the triangle in front, and a hit on a rim (inside or outside
/// the true edge) is not believed but worked out anew from the true triangles. Elsewhere no
/// rounding changes which triangle is hit.
class EdgeGuard {
 public:
  /// Three corners a triangle; triangles [part_begin[i], part_begin[i + 1]) belong together, which
  /// makes the search short. Both must outlive the guard.
  EdgeGuard(const std::vector<Eigen::Vector3d>& corners, std::vector<std::uint32_t> part_begin);

  /// Width of the rim [m]: a millionth of the scene's size, sixteen times the rounding of a float.
  [[nodiscard]] double rim() const { return rim_; }
  /// A triangle with its rim.
  void with_rim(std::size_t triangle, Eigen::Vector3f* three) const;

  /// Whether a hit at Embree's barycentric coordinates lies on the rim.
  [[nodiscard]] bool on_rim(std::uint32_t triangle, float u, float v) const {
    const Width& w = widths_[triangle];
    return u < w.u || v < w.v || 1.0F - u - v < w.w;
  }

  /// The nearest triangle beyond `minimum_range`, in double precision; of equal ones the first.
  /// 0xffffffff: none.
  [[nodiscard]] std::uint32_t nearest(const Eigen::Vector3d& origin,
                                      const Eigen::Vector3d& direction, double minimum_range) const;

 private:
  struct Width {
    float u, v, w;  // of the rim, as barycentric coordinates of the widened triangle
  };
  struct Group {
    Eigen::AlignedBox3d box;
    std::uint32_t begin, end;
  };
  [[nodiscard]] bool widened(std::size_t triangle, Eigen::Vector3d* three) const;

  const std::vector<Eigen::Vector3d>& corners_;
  double rim_ = 0.0;
  std::vector<Width> widths_;
  std::vector<Group> groups_;
};

}  // namespace scanchor
