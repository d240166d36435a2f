#include "perception/noise.hpp"

#include <algorithm>
#include <cmath>

#include "core/parallel.hpp"

namespace scanchor {
namespace {

struct Weighted {
  double value, weight;
};

double weighted_quantile(std::vector<Weighted>& values, double share) {
  std::sort(values.begin(), values.end(),
            [](const auto& a, const auto& b) { return a.value < b.value; });
  double total = 0.0;
  for (const auto& v : values) total += v.weight;
  double sum = 0.0;
  for (const auto& v : values) {
    sum += v.weight;
    if (sum >= share * total) return v.value;
  }
  return values.back().value;
}

// The first place whose code is not below `code`, looked for from place `i` on outwards: the codes
// of what lies near each other mostly do too.
std::size_t first_from(const std::vector<std::uint64_t>& codes, std::size_t i, std::uint64_t code) {
  std::size_t low = i, high = i, step = 8;
  if (codes[i] < code) {
    while (high < codes.size() && codes[high] < code) {
      low = high;
      high += step;
      step *= 4;
    }
    high = std::min(high, codes.size());
  } else {
    while (low > 0 && codes[low] >= code) {
      high = low;
      low = low > step ? low - step : 0;
      step *= 4;
    }
  }
  const auto begin = codes.begin();
  return static_cast<std::size_t>(std::lower_bound(begin + static_cast<std::ptrdiff_t>(low),
                                                   begin + static_cast<std::ptrdiff_t>(high),
                                                   code) -
                                  begin);
}

// Squared distance from point i to its nearest neighbour: a bound from the neighbours along the
// Morton curve, then all cells that the ball of that radius touches.
float nearest2(const CanonicalCloud& cloud, std::size_t i) {
  const Eigen::Vector3f p = cloud.point(i);
  float best = 3e38F;
  const std::size_t from = i < 4 ? 0 : i - 4, to = std::min(cloud.size(), i + 5);
  for (std::size_t j = from; j < to; ++j) {
    if (j != i) best = std::min(best, (cloud.point(j) - p).squaredNorm());
  }
  const float radius = std::sqrt(best);
  int level = CanonicalCloud::levels;
  while (level > 0 && cloud.cell_side(level) < radius) --level;
  const int shift = 3 * (CanonicalCloud::levels - level);
  const float inverse = 1.0F / cloud.cell_side(level);
  const float last = static_cast<float>(1U << level) - 1.0F;
  Eigen::Vector3i low, high;
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] =
        static_cast<int>(std::clamp((p[axis] - radius - cloud.low[axis]) * inverse, 0.0F, last));
    high[axis] =
        static_cast<int>(std::clamp((p[axis] + radius - cloud.low[axis]) * inverse, 0.0F, last));
  }
  // How far a cell is from the point, less what rounding may do to its border.
  const float side = cloud.cell_side(level), rounding = 2e-6F * cloud.side;
  const auto gap2 = [&](int axis, int cell) {
    const float low_side = cloud.low[axis] + static_cast<float>(cell) * side;
    const float gap =
        std::max({low_side - p[axis], p[axis] - low_side - side, rounding}) - rounding;
    return gap * gap;
  };
  for (int cx = low.x(); cx <= high.x(); ++cx) {
    const float gap_x = gap2(0, cx);
    for (int cy = low.y(); cy <= high.y(); ++cy) {
      const float gap_xy = gap_x + gap2(1, cy);
      for (int cz = low.z(); cz <= high.z(); ++cz) {
        if (gap_xy + gap2(2, cz) > best) continue;
        const std::uint64_t prefix = spread_bits(static_cast<std::uint64_t>(cx)) << 2 |
                                     spread_bits(static_cast<std::uint64_t>(cy)) << 1 |
                                     spread_bits(static_cast<std::uint64_t>(cz));
        for (auto j = first_from(cloud.code, i, prefix << shift);
             j < cloud.size() && cloud.code[j] >> shift == prefix; ++j) {
          if (j != i) best = std::min(best, (cloud.point(j) - p).squaredNorm());
        }
      }
    }
  }
  return best;
}

}  // namespace

double median_spacing(const CanonicalCloud& cloud) {
  const std::size_t n = cloud.size();
  if (n < 2) return 0.0;
  const std::size_t count = std::min<std::size_t>(n, 1024);
  std::vector<float> spacing(count);
  parallel_blocks(count, 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) spacing[k] = nearest2(cloud, k * n / count);
  });
  std::nth_element(spacing.begin(), spacing.begin() + count / 2, spacing.end());
  return std::sqrt(static_cast<double>(spacing[count / 2]));
}

double least_noise(const CanonicalCloud& cloud, double spacing) {
  return std::max({static_cast<double>(cloud.side) * 0x1p-22, 0.02 * spacing, 1e-9});
}

double estimate_noise(const CanonicalCloud& cloud, const CellTree& tree, double spacing,
                      const std::vector<Eigen::Vector3d>& sensors) {
  constexpr std::uint32_t fewest = 12;
  constexpr double flat = 9.0;     // least ratio of the second to the first variance of a surface
  constexpr double growth = 1.35;  // most growth of the variance from the parts to the whole
  constexpr std::size_t block = 1024;
  const Eigen::Isometry3d to_canonical = cloud.T_cloud_canonical.inverse();
  const std::size_t stride = 1 + tree.cells.size() / 40000;  // a sample is enough
  const std::size_t samples = (tree.cells.size() + stride - 1) / stride;
  std::vector<std::vector<Weighted>> found((samples + block - 1) / block);
  parallel_blocks(samples, block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin * stride; i < std::min(tree.cells.size(), end * stride);
         i += stride) {
      const Cell& cell = tree.cells[i];
      if (cell.size() < 2 * fewest || cell.children == 0 || cell.size() > 4096) continue;
      const Eigen::Vector3d whole = plane_variances_fast(tree.moments[i]);
      const double variance = whole[0] * cell.size() / (cell.size() - 3.0);
      if (whole[1] < flat * variance) continue;
      double squares = 0.0, freedom = 0.0, covered = 0.0;
      for (std::uint32_t c = 0; c < cell.children; ++c) {
        const Moments& part = tree.moments[cell.child + c];
        if (part.n < fewest) continue;
        squares += part.n * plane_variances_fast(part)[0];
        freedom += part.n - 3.0;
        covered += part.n;
      }
      if (covered < 0.7 * cell.size()) continue;
      const double floor2 = least_noise(cloud, spacing) * least_noise(cloud, spacing);
      if (variance > growth * std::max(squares / freedom, floor2)) continue;
      double cosine = 1.0;
      if (sensors.size() == 1) {
        const Eigen::Vector3d beam = tree.moments[i].mean() - to_canonical * sensors[0];
        cosine = std::abs(beam.normalized().dot(fit_plane_fast(tree.moments[i]).normal));
        if (cosine < 0.3) continue;
      }
      found[begin / block].push_back(
          {std::sqrt(variance) / cosine, static_cast<double>(cell.size())});
    }
  });
  std::vector<Weighted> seen;
  for (const auto& some : found) seen.insert(seen.end(), some.begin(), some.end());
  const double least = least_noise(cloud, spacing);
  if (seen.empty()) return std::max(0.25 * spacing, least);
  return std::max(weighted_quantile(seen, sensors.size() == 1 ? 0.5 : 0.75), least);
}

}  // namespace scanchor
