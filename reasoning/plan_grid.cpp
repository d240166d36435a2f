#include "reasoning/plan_grid.hpp"

#include <algorithm>
#include <cmath>

namespace scanchor {
namespace {

constexpr double usual_cell = 2.0;     // [m] about the reach of "near"
constexpr int most_cells = 512;        // along a side
constexpr int most_cells_of_box = 64;  // cells: a box over more of them is returned everywhere

}  // namespace

PlanGrid::PlanGrid(const std::vector<Eigen::AlignedBox3d>& boxes,
                   const std::vector<std::int32_t>& everywhere)
    : everywhere_(everywhere) {
  Eigen::AlignedBox2d all;
  for (const auto& box : boxes) {
    all.extend(Eigen::Vector2d(box.min().head<2>()));
    all.extend(Eigen::Vector2d(box.max().head<2>()));
  }
  if (all.isEmpty()) return;
  origin_ = all.min();
  cell_ = std::max(usual_cell, all.sizes().maxCoeff() / most_cells);
  nx_ = static_cast<int>(all.sizes().x() / cell_) + 1;
  ny_ = static_cast<int>(all.sizes().y() / cell_) + 1;
  std::vector<char> placed(boxes.size(), 1);
  for (const auto i : everywhere) placed[static_cast<std::size_t>(i)] = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Cells c = cells_of(boxes[i], 0.0);
    if (placed[i] == 0 || (c.x1 - c.x0 + 1) * (c.y1 - c.y0 + 1) <= most_cells_of_box) continue;
    placed[i] = 0;
    everywhere_.push_back(static_cast<std::int32_t>(i));
  }
  std::sort(everywhere_.begin(), everywhere_.end());
  const auto each = [&](const auto& visit) {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (placed[i] == 0) continue;
      const Cells c = cells_of(boxes[i], 0.0);
      for (int y = c.y0; y <= c.y1; ++y) {
        for (int x = c.x0; x <= c.x1; ++x)
          visit(static_cast<std::size_t>(y) * nx_ + x, static_cast<std::int32_t>(i));
      }
    }
  };
  start_.assign(static_cast<std::size_t>(nx_) * ny_ + 1, 0);
  each([&](std::size_t cell, std::int32_t) { ++start_[cell + 1]; });
  for (std::size_t k = 1; k < start_.size(); ++k) start_[k] += start_[k - 1];
  numbers_.resize(static_cast<std::size_t>(start_.back()));
  std::vector<std::int32_t> next(start_.begin(), start_.end() - 1);
  each([&](std::size_t cell, std::int32_t i) { numbers_[next[cell]++] = i; });
}

PlanGrid::Cells PlanGrid::cells_of(const Eigen::AlignedBox3d& box, double reach) const {
  const auto cell = [&](double at, double origin, int count) {
    const double k = std::floor((at - origin) / cell_);
    return static_cast<int>(std::clamp(k, 0.0, static_cast<double>(count - 1)));
  };
  return {
      cell(box.min().x() - reach, origin_.x(), nx_), cell(box.max().x() + reach, origin_.x(), nx_),
      cell(box.min().y() - reach, origin_.y(), ny_), cell(box.max().y() + reach, origin_.y(), ny_)};
}

void PlanGrid::near(const Eigen::AlignedBox3d& box, double reach,
                    std::vector<std::int32_t>& numbers) const {
  numbers = everywhere_;
  if (nx_ == 0) return;
  const Cells c = cells_of(box, reach);
  for (int y = c.y0; y <= c.y1; ++y) {
    const std::size_t row = static_cast<std::size_t>(y) * nx_;
    // The cells of a row lie one behind the other.
    numbers.insert(numbers.end(), numbers_.begin() + start_[row + c.x0],
                   numbers_.begin() + start_[row + c.x1 + 1]);
  }
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

}  // namespace scanchor
