#include "perception/height_map.hpp"

#include <algorithm>
#include <cmath>

namespace scanchor {

HeightMap::HeightMap(const CanonicalCloud& cloud, const GrownPlane& grown,
                     std::span<const std::uint32_t> members)
    : u_(grown.plane.axes.col(2).cast<float>()), v_(grown.plane.axes.col(1).cast<float>()) {
  float high_u = -3e38F, high_v = -3e38F;
  std::vector<float> u(members.size()), v(members.size());
  for (std::size_t k = 0; k < members.size(); ++k) {
    const Eigen::Vector3f x = cloud.point(members[k]);
    u[k] = u_.dot(x);
    v[k] = v_.dot(x);
    low_u_ = std::min(low_u_, u[k]);
    high_u = std::max(high_u, u[k]);
    low_v_ = std::min(low_v_, v[k]);
    high_v = std::max(high_v, v[k]);
  }
  const auto& variances = grown.plane.variances;  // an even spread has 12 times as much extent^2
  const double area = 12.0 * std::sqrt(std::max(0.0, variances[1] * variances[2]));
  constexpr float most = 500.0F;
  side_ = std::max(
      static_cast<float>(std::sqrt(points_per_square * area / static_cast<double>(members.size()))),
      std::max({high_u - low_u_, high_v - low_v_, 1e-6F}) / most);
  columns = static_cast<int>((high_u - low_u_) / side_) + 3;  // with an empty rim
  rows = static_cast<int>((high_v - low_v_) / side_) + 3;
  const auto squares = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  weight.assign(squares, 0.0F);
  height.assign(squares, 0.0F);
  const PlaneReach reach(grown);
  for (std::size_t k = 0; k < members.size(); ++k) {
    const auto p = members[k];
    const auto at = square(u[k], v[k]);
    const float s = reach.scatter(cloud.inverse_range[p]), w = 1.0F / (s * s);
    weight[at] += w;
    height[at] +=
        w * (reach.a * cloud.x[p] + reach.b * cloud.y[p] + reach.c * cloud.z[p] - reach.offset);
  }
  for (std::size_t i = 0; i < squares; ++i) {
    if (weight[i] > 0.0F) height[i] /= weight[i];
  }
}

}  // namespace scanchor
