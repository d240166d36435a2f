#include "perception/beam_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/parallel.hpp"

namespace scanchor {
namespace {

struct Place {
  float u, v;
  std::uint32_t face;
};

Place place_of(const Eigen::Vector3f& d) {
  const Eigen::Vector3f a = d.cwiseAbs();
  if (a.x() >= a.y() && a.x() >= a.z()) return {d.y() / a.x(), d.z() / a.x(), d.x() > 0 ? 0U : 1U};
  if (a.y() >= a.z()) return {d.x() / a.y(), d.z() / a.y(), d.y() > 0 ? 2U : 3U};
  return {d.x() / a.z(), d.y() / a.z(), d.z() > 0 ? 4U : 5U};
}

std::uint32_t cell_at(const Place& p, int side) {
  const int x =
      std::clamp(static_cast<int>((p.u + 1.0F) * 0.5F * static_cast<float>(side)), 0, side - 1);
  const int y =
      std::clamp(static_cast<int>((p.v + 1.0F) * 0.5F * static_cast<float>(side)), 0, side - 1);
  return (p.face * static_cast<std::uint32_t>(side) + static_cast<std::uint32_t>(y)) *
             static_cast<std::uint32_t>(side) +
         static_cast<std::uint32_t>(x);
}

}  // namespace

BeamGrid::BeamGrid(const CanonicalCloud& cloud, const Eigen::Vector3d& sensor) {
  constexpr int coarse_side = 48, finest = 1024;
  constexpr std::size_t block = 16384, coarse_cells = 6 * coarse_side * coarse_side;
  constexpr double spacings_per_cell = 1.1;
  const std::size_t n = cloud.size();
  const Eigen::Vector3f at = sensor.cast<float>();
  const auto place = [&](std::size_t i) {
    const Eigen::Vector3f d = cloud.point(i) - at;
    return d.squaredNorm() > 0.0F ? place_of(d) : Place{0.0F, 0.0F, 0};
  };
  std::vector<std::uint32_t> coarse(coarse_cells, 0);
  cell_of_point_.resize(n);
  parallel_blocks(n, block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) cell_of_point_[i] = cell_at(place(i), coarse_side);
  });
  for (const auto cell : cell_of_point_) ++coarse[cell];
  std::sort(coarse.begin(), coarse.end());
  std::size_t below = 0;
  std::uint32_t median = 1;
  for (const auto count : coarse) {
    below += count;
    median = std::max(count, 1U);
    if (2 * below >= n) break;
  }
  side_ = std::clamp(
      static_cast<int>(coarse_side * std::sqrt(static_cast<double>(median)) / spacings_per_cell), 4,
      finest);
  one_over_side_ = (std::uint64_t{1} << 40) / static_cast<std::uint64_t>(side_) + 1;
  parallel_blocks(n, block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) cell_of_point_[i] = cell_at(place(i), side_);
  });
  // A counting sort: `start_` is where the next point of a cell goes, and in the end where the next
  // cell begins.
  start_.assign(6 * static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_) + 1, 0);
  for (const auto cell : cell_of_point_) ++start_[cell];
  std::exclusive_scan(start_.begin(), start_.end(), start_.begin(), 0U);
  order_.resize(n);
  for (std::size_t i = 0; i < n; ++i)
    order_[start_[cell_of_point_[i]]++] = static_cast<std::uint32_t>(i);
  std::move_backward(start_.begin(), start_.end() - 1, start_.end());
  start_[0] = 0;
}

std::uint32_t BeamGrid::beyond_face(int face, int x, int y) const {
  const float u = (static_cast<float>(x) + 0.5F) * 2.0F / static_cast<float>(side_) - 1.0F;
  const float v = (static_cast<float>(y) + 0.5F) * 2.0F / static_cast<float>(side_) - 1.0F;
  const float sign = face % 2 == 0 ? 1.0F : -1.0F;
  switch (face / 2) {
    case 0:
      return cell_at(place_of({sign, u, v}), side_);
    case 1:
      return cell_at(place_of({u, sign, v}), side_);
    default:
      return cell_at(place_of({u, v, sign}), side_);
  }
}

}  // namespace scanchor
