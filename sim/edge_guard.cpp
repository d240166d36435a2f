#include "sim/edge_guard.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scanchor {
namespace {

/// Whether a ray meets a box, a little more than it.
bool meets(const Eigen::AlignedBox3d& box, const Eigen::Vector3d& origin,
           const Eigen::Vector3d& inverse) {
  double low = 0.0;
  double high = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (box.min()[axis] - 1e-6 - origin[axis]) * inverse[axis];
    const double b = (box.max()[axis] + 1e-6 - origin[axis]) * inverse[axis];
    low = std::max(low, std::min(a, b));
    high = std::min(high, std::max(a, b));
  }
  return low <= high;
}

}  // namespace

EdgeGuard::EdgeGuard(const std::vector<Eigen::Vector3d>& corners,
                     std::vector<std::uint32_t> part_begin)
    : corners_(corners) {
  const std::size_t count = corners.size() / 3;
  part_begin.push_back(static_cast<std::uint32_t>(count));
  Eigen::AlignedBox3d all;
  for (std::size_t i = 0; i + 1 < part_begin.size(); ++i) {
    Group group{{}, part_begin[i], part_begin[i + 1]};
    for (std::size_t c = 3 * std::size_t{group.begin}; c < 3 * std::size_t{group.end}; ++c)
      group.box.extend(corners[c]);
    if (group.begin == group.end) continue;
    all.extend(group.box);
    groups_.push_back(group);
  }
  // Coordinates count, not only extents: a float far from the origin is coarse.
  if (!all.isEmpty())
    rim_ = 1e-6 * std::max(all.sizes().norm(), std::max(all.min().norm(), all.max().norm()));
  widths_.resize(count);
  for (std::size_t t = 0; t < count; ++t) {
    Eigen::Vector3d v[3];
    Width& width = widths_[t];
    width = {2.0F, 2.0F, 2.0F};  // too thin to have a height: never believed
    if (!widened(t, v)) continue;
    const double twice_area = (v[1] - v[0]).cross(v[2] - v[0]).norm();
    const auto share = [&](double side) {
      return static_cast<float>(2.0 * rim_ * side / twice_area);
    };
    width = {share((v[2] - v[0]).norm()), share((v[1] - v[0]).norm()), share((v[2] - v[1]).norm())};
  }
}

bool EdgeGuard::widened(std::size_t triangle, Eigen::Vector3d* three) const {
  const Eigen::Vector3d* c = &corners_[3 * triangle];
  for (int i = 0; i < 3; ++i) three[i] = c[i];
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d a = c[(i + 1) % 3] - c[i];
    const Eigen::Vector3d b = c[(i + 2) % 3] - c[i];
    const double lengths = std::sqrt(a.squaredNorm() * b.squaredNorm());
    if (!(lengths > 0.0)) return false;
    const double sine = a.cross(b).norm() / lengths;
    if (!(sine > 0.0)) return false;
    // Both edges at the corner move out by the rim; needles are cut short.
    three[i] -= (a / a.norm() + b / b.norm()) * std::min(rim_ / sine, 50.0 * rim_);
  }
  return true;
}

void EdgeGuard::with_rim(std::size_t triangle, Eigen::Vector3f* three) const {
  Eigen::Vector3d v[3];
  const bool whole = widened(triangle, v);
  for (int i = 0; i < 3; ++i)
    three[i] = (whole ? v[i] : corners_[3 * triangle + static_cast<std::size_t>(i)]).cast<float>();
}

std::uint32_t EdgeGuard::nearest(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                                 double minimum_range) const {
  const Eigen::Vector3d inverse = direction.cwiseInverse();
  std::uint32_t best = 0xffffffffU;
  double range = std::numeric_limits<double>::infinity();
  for (const Group& group : groups_) {
    // A ray along an axis has an infinite inverse and may give NaN: such boxes are looked into.
    if (inverse.allFinite() && !meets(group.box, origin, inverse)) continue;
    for (std::uint32_t t = group.begin; t < group.end; ++t) {
      const Eigen::Vector3d* c = &corners_[3 * std::size_t{t}];
      const Eigen::Vector3d a = c[0] - origin, b = c[1] - origin, d = c[2] - origin;
      // Which side of each edge: two triangles that share an edge get opposite values to the bit,
      // so no ray slips between them.
      const double u = direction.dot(d.cross(b));
      const double v = direction.dot(a.cross(d));
      const double w = direction.dot(b.cross(a));
      if (!((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0))) continue;
      const double sum = u + v + w;
      if (sum == 0.0) continue;  // edge-on
      const double at = (u * direction.dot(a) + v * direction.dot(b) + w * direction.dot(d)) / sum;
      if (at > minimum_range && at < range) {
        range = at;
        best = t;
      }
    }
  }
  return best;
}

}  // namespace scanchor
