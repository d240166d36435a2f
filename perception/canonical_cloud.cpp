#include "perception/canonical_cloud.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <numeric>
#include <utility>

#include "core/parallel.hpp"

namespace scanchor {
namespace {

constexpr std::size_t points_a_task = 8192;

// A point on its way to its place.
struct Record {
  std::uint64_t code;
  float x, y, z;
  std::uint32_t source;
};
using Records = std::unique_ptr<Record[]>;  // not set to zero first, as a vector's would be

// Calls add(sum, begin, end) for blocks of [0, n), each with a sum of its own, and returns the sum
// of all: for sums whose order does not matter.
template <class Sum, class Add>
Sum sum_of_blocks(std::size_t n, const Sum& zero, const Add& add) {
  std::vector<Sum> sums((n + points_a_task - 1) / points_a_task, zero);
  parallel_blocks(n, points_a_task, [&](std::size_t begin, std::size_t end) {
    Sum sum = zero;
    add(sum, begin, end);
    sums[begin / points_a_task] = sum;
  });
  Sum total = zero;
  for (const auto& sum : sums) total += sum;
  return total;
}

struct Bounds {
  Eigen::Array3d low = Eigen::Array3d::Constant(1e300), high = -low;
  void add(const Eigen::Array3d& p) {
    low = low.min(p);
    high = high.max(p);
  }
  Bounds& operator+=(const Bounds& other) {
    low = low.min(other.low);
    high = high.max(other.high);
    return *this;
  }
};

Eigen::AlignedBox3d bounds_of(const std::vector<Eigen::Vector3d>& points,
                              const std::vector<std::uint32_t>& index) {
  const Bounds bounds =
      sum_of_blocks(index.size(), Bounds{}, [&](Bounds& sum, std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) sum.add(points[index[k]].array());
      });
  return {bounds.low.matrix(), bounds.high.matrix()};
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
  using Sums = Eigen::Array<std::int64_t, 9, 1>;
  const Sums sum = sum_of_blocks(
      index.size(), Sums(Sums::Zero()), [&](Sums& part, std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
          const Eigen::Vector3d d = (points[index[k]] - middle) * to_grid;
          // Casting truncates; the shift makes that a floor, the same for every sign.
          const std::int64_t a = static_cast<std::int64_t>(d.x() + 131072.5) - 131072;
          const std::int64_t b = static_cast<std::int64_t>(d.y() + 131072.5) - 131072;
          const std::int64_t c = static_cast<std::int64_t>(d.z() + 131072.5) - 131072;
          part[0] += a;
          part[1] += b;
          part[2] += c;
          part[3] += a * a;
          part[4] += a * b;
          part[5] += a * c;
          part[6] += b * b;
          part[7] += b * c;
          part[8] += c * c;
        }
      });
  const double n = static_cast<double>(index.size());
  const Eigen::Vector3d mean(static_cast<double>(sum[0]) / n, static_cast<double>(sum[1]) / n,
                             static_cast<double>(sum[2]) / n);
  const Eigen::Array<double, 9, 1> real = sum.cast<double>();
  Eigen::Matrix3d covariance;
  covariance << real[3], real[4], real[5], real[4], real[6], real[7], real[5], real[7], real[8];
  covariance = covariance / n - mean * mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  Eigen::Matrix3d axes = solver.eigenvectors().rowwise().reverse();
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  frame.translation() = middle + mean / to_grid;

  // The longer tail is the positive side. Each cube is cut to an integer of at most 2^35 before it
  // is summed.
  using Skew = Eigen::Array<std::int64_t, 2, 1>;
  const double to_unit = 1.0 / extent;
  const Eigen::Vector3d first = axes.col(0), second = axes.col(1), origin = frame.translation();
  const Skew skew = sum_of_blocks(
      index.size(), Skew(Skew::Zero()), [&](Skew& part, std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
          const Eigen::Vector3d d = (points[index[k]] - origin) * to_unit;
          const double u = first.dot(d), v = second.dot(d);
          part[0] += static_cast<std::int64_t>(u * u * u * 0x1p33);
          part[1] += static_cast<std::int64_t>(v * v * v * 0x1p33);
        }
      });
  if (skew[0] < 0) axes.col(0) = -axes.col(0);
  if (skew[1] < 0) axes.col(1) = -axes.col(1);
  axes.col(2) = axes.col(0).cross(axes.col(1));
  frame.linear() = axes;
  return frame;
}

// An object and no function: a call for each comparison would cost more than it.
constexpr auto comes_first = [](const Record& p, const Record& q) {
  if (p.code != q.code) return p.code < q.code;
  if (p.x != q.x) return p.x < q.x;
  if (p.y != q.y) return p.y < q.y;
  if (p.z != q.z) return p.z < q.z;
  return p.source < q.source;
};

// Sorts records whose codes agree but for the last `bits`: by two or three levels of the octree at
// once, until a handful is left.
void sort_cell(Record* first, std::size_t n, int bits, Record* scratch) {
  constexpr int most = 9;
  if (n <= 24 || bits == 0) {
    std::sort(first, first + n, comes_first);
    return;
  }
  const int step = std::min(bits, n < 512 ? 6 : most);  // not many more bins than records
  const std::size_t bins = std::size_t{1} << step;
  bits -= step;
  const auto digit = [&](const Record& r) { return r.code >> bits & (bins - 1U); };
  std::array<std::uint32_t, 1U << most> next;  // where the next of a bin goes; then where it ends
  std::fill_n(next.begin(), bins, 0U);
  for (std::size_t i = 0; i < n; ++i) ++next[digit(first[i])];
  std::exclusive_scan(next.begin(), next.begin() + bins, next.begin(), 0U);
  for (std::size_t i = 0; i < n; ++i) scratch[next[digit(first[i])]++] = first[i];
  std::copy(scratch, scratch + n, first);
  for (std::size_t d = 0, start = 0; d < bins; start = next[d++]) {
    if (next[d] - start > 1) sort_cell(first + start, next[d] - start, bits, scratch);
  }
}

// Into the order of the codes, ties by x, y, z and source. By the first four levels of the octree
// at once; each cell of those then holds few enough points to be sorted near the processor.
void sort_records(Records& records, std::size_t n) {
  constexpr int top_bits = 12, shift = 3 * CanonicalCloud::levels - top_bits;
  constexpr std::size_t cells = 1U << top_bits;
  const std::size_t blocks = (n + points_a_task - 1) / points_a_task;
  std::vector<std::uint32_t> start(cells + 1, 0);
  {
    auto scattered = std::make_unique_for_overwrite<Record[]>(n);
    // Where the next record of a block goes, for each cell: blocks one after another.
    const std::size_t tasks = std::min<std::size_t>(blocks, 8), a_task = (n + tasks - 1) / tasks;
    std::vector<std::uint32_t> next(tasks * cells, 0);
    parallel_blocks(n, a_task, [&](std::size_t begin, std::size_t end) {
      auto* const count = next.data() + begin / a_task * cells;
      for (std::size_t k = begin; k < end; ++k) ++count[records[k].code >> shift];
    });
    std::uint32_t sum = 0;
    for (std::size_t cell = 0; cell < cells; ++cell) {
      start[cell] = sum;
      for (std::size_t task = 0; task < tasks; ++task) {
        const auto count = next[task * cells + cell];
        next[task * cells + cell] = sum;
        sum += count;
      }
    }
    start[cells] = sum;
    parallel_blocks(n, a_task, [&](std::size_t begin, std::size_t end) {
      auto* const to = next.data() + begin / a_task * cells;
      for (std::size_t k = begin; k < end; ++k)
        scattered[to[records[k].code >> shift]++] = records[k];
    });
    records.swap(scattered);
  }
  parallel_blocks(cells, 32, [&](std::size_t begin, std::size_t end) {
    std::vector<Record> scratch;
    for (std::size_t cell = begin; cell < end; ++cell) {
      const std::size_t size = start[cell + 1] - start[cell];
      if (size < 2) continue;
      if (scratch.size() < size) scratch.resize(size);
      sort_cell(&records[start[cell]], size, shift, scratch.data());
    }
  });
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

  auto records = std::make_unique_for_overwrite<Record[]>(n);
  const Bounds bounds =
      sum_of_blocks(n, Bounds{}, [&](Bounds& sum, std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
          const Eigen::Vector3f p = (to_canonical * points[index[k]]).cast<float>();
          records[k] = {0, p.x(), p.y(), p.z(), index[k]};
          sum.add(p.cast<double>().array());
        }
      });
  const Eigen::Array3f low = bounds.low.cast<float>(), high = bounds.high.cast<float>();
  cloud.low = low.matrix();
  // A little larger than the box, so that the highest coordinate falls inside.
  cloud.side = std::max((high - low).maxCoeff() * 1.0001F, 1e-6F);
  const float to_cell = 65536.0F / cloud.side;
  parallel_blocks(n, points_a_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      Record& p = records[k];
      p.code = spread_bits(static_cast<std::uint32_t>((p.x - cloud.low.x()) * to_cell)) << 2 |
               spread_bits(static_cast<std::uint32_t>((p.y - cloud.low.y()) * to_cell)) << 1 |
               spread_bits(static_cast<std::uint32_t>((p.z - cloud.low.z()) * to_cell));
    }
  });
  sort_records(records, n);

  // Equal points once: a block counts its different ones, and then knows where they go.
  const auto is_new = [&](std::size_t i) {
    const Record &p = records[i], &q = records[i - (i > 0 ? 1 : 0)];
    return i == 0 || p.x != q.x || p.y != q.y || p.z != q.z;
  };
  std::vector<std::uint32_t> start((n + points_a_task - 1) / points_a_task, 0);
  parallel_blocks(n, points_a_task, [&](std::size_t begin, std::size_t end) {
    std::uint32_t count = 0;
    for (std::size_t i = begin; i < end; ++i) count += is_new(i) ? 1 : 0;
    start[begin / points_a_task] = count;
  });
  std::uint32_t kept = 0;
  for (auto& here : start) kept += std::exchange(here, kept);
  // Side by side: setting to zero is half of what writing costs.
  const std::array<std::function<void()>, 7> make_room = {
      [&] { cloud.x.resize(kept); },
      [&] { cloud.y.resize(kept); },
      [&] { cloud.z.resize(kept); },
      [&] { cloud.code.resize(kept); },
      [&] { cloud.source.resize(n); },
      [&] { cloud.first.resize(kept + 1); },
      [&] { cloud.inverse_range.resize(kept); },
  };
  parallel_blocks(make_room.size(), 1, [&](std::size_t k, std::size_t) { make_room[k](); });
  parallel_blocks(n, points_a_task, [&](std::size_t begin, std::size_t end) {
    std::uint32_t to = start[begin / points_a_task];
    for (std::size_t i = begin; i < end; ++i) {
      const Record& p = records[i];
      cloud.source[i] = p.source;
      if (!is_new(i)) continue;
      cloud.x[to] = p.x;
      cloud.y[to] = p.y;
      cloud.z[to] = p.z;
      cloud.code[to] = p.code;
      cloud.first[to++] = static_cast<std::uint32_t>(i);
    }
  });
  cloud.first[kept] = static_cast<std::uint32_t>(n);
  return cloud;
}

void see_from(const Eigen::Vector3d& sensor, CanonicalCloud& cloud) {
  const Eigen::Vector3f at = sensor.cast<float>();
  parallel_blocks(cloud.size(), points_a_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      cloud.inverse_range[i] = 1.0F / std::max((cloud.point(i) - at).norm(), 1e-6F);
  });
}

}  // namespace scanchor
