#include "perception/canonical_cloud.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

namespace scanchor {
namespace {

struct Keyed {
  std::uint64_t code;
  std::uint32_t at;  // position in `index`
};

Eigen::AlignedBox3d bounds_of(const std::vector<Eigen::Vector3d>& points,
                              const std::vector<std::uint32_t>& index) {
  Eigen::Array3d low = points[index[0]].array(), high = low;
  for (const auto i : index) {
    low = low.min(points[i].array());
    high = high.max(points[i].array());
  }
  return {low.matrix(), high.matrix()};
}

// Mean and axes of the points. Coordinates are rounded to 2^-17 of the extent for the second
// moments: integers of 18 bits, whose products summed over 2^27 points stay below 2^63, and a sum
// of integers does not depend on its order.
Eigen::Isometry3d principal_frame(const std::vector<Eigen::Vector3d>& points,
                                  const std::vector<std::uint32_t>& index,
                                  const Eigen::AlignedBox3d& box) {
  const Eigen::Vector3d middle = box.center();
  const double extent = std::max(box.sizes().maxCoeff(), 1e-9);
  const double to_grid = 131072.0 / extent;
  std::array<std::int64_t, 3> sum{};
  std::array<std::int64_t, 6> product{};
  for (const auto i : index) {
    const Eigen::Vector3d d = (points[i] - middle) * to_grid;
    // Casting truncates; the shift makes that a floor, the same for every sign.
    const std::int64_t a = static_cast<std::int64_t>(d.x() + 131072.5) - 131072;
    const std::int64_t b = static_cast<std::int64_t>(d.y() + 131072.5) - 131072;
    const std::int64_t c = static_cast<std::int64_t>(d.z() + 131072.5) - 131072;
    sum[0] += a;
    sum[1] += b;
    sum[2] += c;
    product[0] += a * a;
    product[1] += a * b;
    product[2] += a * c;
    product[3] += b * b;
    product[4] += b * c;
    product[5] += c * c;
  }
  const double n = static_cast<double>(index.size());
  const Eigen::Vector3d mean(static_cast<double>(sum[0]) / n, static_cast<double>(sum[1]) / n,
                             static_cast<double>(sum[2]) / n);
  Eigen::Matrix3d covariance;
  covariance << static_cast<double>(product[0]), static_cast<double>(product[1]),
      static_cast<double>(product[2]), static_cast<double>(product[1]),
      static_cast<double>(product[3]), static_cast<double>(product[4]),
      static_cast<double>(product[2]), static_cast<double>(product[4]),
      static_cast<double>(product[5]);
  covariance = covariance / n - mean * mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  Eigen::Matrix3d axes = solver.eigenvectors().rowwise().reverse();
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  frame.translation() = middle + mean / to_grid;

  // The longer tail is the positive side. Each cube is rounded to an integer of at most 2^35 before
  // it is summed.
  std::array<std::int64_t, 2> skew{};
  const double to_unit = 1.0 / extent;
  for (const auto i : index) {
    const Eigen::Vector3d d = (points[i] - frame.translation()) * to_unit;
    const double u = axes.col(0).dot(d), v = axes.col(1).dot(d);
    skew[0] += static_cast<std::int64_t>(std::llround(u * u * u * 0x1p33));
    skew[1] += static_cast<std::int64_t>(std::llround(v * v * v * 0x1p33));
  }
  if (skew[0] < 0) axes.col(0) = -axes.col(0);
  if (skew[1] < 0) axes.col(1) = -axes.col(1);
  axes.col(2) = axes.col(0).cross(axes.col(1));
  frame.linear() = axes;
  return frame;
}

// Least significant digit first, 12 bits a pass: four passes for 48 bits, each skipped where all
// digits are equal.
void radix_sort(std::vector<Keyed>& keys) {
  constexpr int digit_bits = 12, passes = 4;
  constexpr std::size_t buckets = 1U << digit_bits;
  std::vector<Keyed> other(keys.size());
  std::array<std::vector<std::uint32_t>, passes> counts;
  for (auto& count : counts) count.assign(buckets, 0);
  for (const auto& key : keys) {
    for (int pass = 0; pass < passes; ++pass) {
      ++counts[pass][(key.code >> (digit_bits * pass)) & (buckets - 1)];
    }
  }
  for (int pass = 0; pass < passes; ++pass) {
    auto& count = counts[pass];
    const int shift = digit_bits * pass;
    if (count[(keys[0].code >> shift) & (buckets - 1)] == keys.size()) continue;
    std::uint32_t start = 0;
    for (auto& c : count) {
      const std::uint32_t here = c;
      c = start;
      start += here;
    }
    for (const auto& key : keys) other[count[(key.code >> shift) & (buckets - 1)]++] = key;
    keys.swap(other);
  }
}

}  // namespace

CanonicalCloud canonical_cloud(const std::vector<Eigen::Vector3d>& points,
                               const std::vector<std::uint32_t>& index) {
  CanonicalCloud cloud;
  cloud.first.push_back(0);
  if (index.empty()) return cloud;
  cloud.T_cloud_canonical = principal_frame(points, index, bounds_of(points, index));
  const Eigen::Isometry3d to_canonical = cloud.T_cloud_canonical.inverse();
  const std::size_t n = index.size();

  std::vector<Eigen::Vector3f> moved(n);
  Eigen::Array3f low = Eigen::Array3f::Constant(3e38F), high = -low;
  for (std::size_t k = 0; k < n; ++k) {
    moved[k] = (to_canonical * points[index[k]]).cast<float>();
    low = low.min(moved[k].array());
    high = high.max(moved[k].array());
  }
  cloud.low = low.matrix();
  // A little larger than the box, so that the highest coordinate falls inside.
  cloud.side = std::max((high - low).maxCoeff() * 1.0001F, 1e-6F);
  const float to_cell = 65536.0F / cloud.side;

  std::vector<Keyed> keys(n);
  for (std::size_t k = 0; k < n; ++k) {
    const Eigen::Vector3f d = (moved[k] - cloud.low) * to_cell;
    keys[k] = {spread_bits(static_cast<std::uint32_t>(d.x())) << 2 |
                   spread_bits(static_cast<std::uint32_t>(d.y())) << 1 |
                   spread_bits(static_cast<std::uint32_t>(d.z())),
               static_cast<std::uint32_t>(k)};
  }
  radix_sort(keys);
  const auto before = [&](const Keyed& a, const Keyed& b) {
    const auto &p = moved[a.at], &q = moved[b.at];
    if (p.x() != q.x()) return p.x() < q.x();
    if (p.y() != q.y()) return p.y() < q.y();
    if (p.z() != q.z()) return p.z() < q.z();
    return index[a.at] < index[b.at];
  };
  for (std::size_t i = 0; i < n;) {
    std::size_t end = i + 1;
    while (end < n && keys[end].code == keys[i].code) ++end;
    if (end - i > 1) std::sort(keys.begin() + i, keys.begin() + end, before);
    i = end;
  }

  cloud.x.reserve(n);
  cloud.y.reserve(n);
  cloud.z.reserve(n);
  cloud.code.reserve(n);
  cloud.source.resize(n);
  cloud.first.reserve(n + 1);
  for (std::size_t i = 0; i < n; ++i) {
    const auto& p = moved[keys[i].at];
    cloud.source[i] = index[keys[i].at];
    const bool repeated = i > 0 && p == moved[keys[i - 1].at];
    if (repeated) {
      cloud.first.back() = static_cast<std::uint32_t>(i + 1);
      continue;
    }
    cloud.x.push_back(p.x());
    cloud.y.push_back(p.y());
    cloud.z.push_back(p.z());
    cloud.code.push_back(keys[i].code);
    cloud.first.push_back(static_cast<std::uint32_t>(i + 1));
  }
  cloud.inverse_range.assign(cloud.size(), 0.0F);
  return cloud;
}

void see_from(const Eigen::Vector3d& sensor, CanonicalCloud& cloud) {
  const Eigen::Vector3f at = sensor.cast<float>();
  for (std::size_t i = 0; i < cloud.size(); ++i)
    cloud.inverse_range[i] = 1.0F / std::max((cloud.point(i) - at).norm(), 1e-6F);
}

}  // namespace scanchor
