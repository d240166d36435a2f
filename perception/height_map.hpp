#pragma once
// A plane seen from above: what the means of many points say of it that none of them says.

#include <Eigen/Cholesky>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "perception/cell_planes.hpp"

namespace scanchor {

/// Heights over a plane, averaged over squares of it that hold about eight points, with an empty
/// rim.
class HeightMap {
 public:
  static constexpr double points_per_square = 8.0;
  HeightMap(const CanonicalCloud& cloud, const GrownPlane& grown,
            std::span<const std::uint32_t> members);
  [[nodiscard]] std::size_t square(const Eigen::Vector3f& x) const {
    return square(u_.dot(x), v_.dot(x));
  }
  /// Is there a point of the map in the square of this place or in one that touches it?
  [[nodiscard]] bool is_beside(const Eigen::Vector3f& x) const {
    const float column = (u_.dot(x) - low_u_) / side_ + 1.0F,
                row = (v_.dot(x) - low_v_) / side_ + 1.0F;
    if (column < 1.0F || row < 1.0F || column >= static_cast<float>(columns - 1) ||
        row >= static_cast<float>(rows - 1))
      return false;
    return around(square(x), [&](std::size_t i) { return weight[i] > 0.0F ? 1.0 : 0.0; }) > 0.0;
  }
  /// Is there one in the square itself?
  [[nodiscard]] bool holds(const Eigen::Vector3f& x) const {
    return is_beside(x) && weight[square(x)] > 0.0F;
  }
  /// Squares beside, above and below.
  [[nodiscard]] std::array<std::size_t, 4> beside(std::size_t at) const {
    const auto row = static_cast<std::size_t>(columns);
    return {at - 1, at + 1, at - row, at + row};
  }
  /// Sum over the three by three squares around `at` of f(square).
  template <class F>
  [[nodiscard]] double around(std::size_t at, const F& f) const {
    double sum = 0.0;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx)
        sum += f(at + static_cast<std::size_t>(static_cast<std::ptrdiff_t>(dy) * columns + dx));
    }
    return sum;
  }
  /// Place of a square along the map, in squares: good for fitting.
  [[nodiscard]] Eigen::Vector3d place(std::size_t at) const {
    // Half as wide numbers divide in half of the time: a map has at most 503 x 503 squares.
    const auto width = static_cast<std::uint32_t>(columns), place = static_cast<std::uint32_t>(at);
    const std::uint32_t row = place / width, column = place - row * width;
    return {1.0, static_cast<double>(column) / columns, static_cast<double>(row) / columns};
  }

  int columns = 0, rows = 0;
  std::vector<float> weight;  ///< [1/m2] one over the variance of the height; 0: no point
  std::vector<float> height;  ///< [m]

 private:
  [[nodiscard]] std::size_t square(float u, float v) const {
    return static_cast<std::size_t>((static_cast<int>((v - low_v_) / side_) + 1) * columns +
                                    static_cast<int>((u - low_u_) / side_) + 1);
  }
  Eigen::Vector3f u_, v_;
  float low_u_ = 3e38F, low_v_ = 3e38F, side_ = 1.0F;
};

/// Height as a linear function of place, from the squares that were added.
class Tilt {
 public:
  void add(const Eigen::Vector3d& place, double weight, double height) {
    left_ += weight * place * place.transpose();
    right_ += weight * height * place;
  }
  /// Takes off what was added to another.
  void remove(const Tilt& other) {
    left_ -= other.left_;
    right_ -= other.right_;
  }
  void fit() {
    // A little to hold directions that nothing holds.
    left_.diagonal().array() += 1e-9 * left_(0, 0) + 1e-300;
    line_ = left_.ldlt().solve(right_);
  }
  [[nodiscard]] double at(const Eigen::Vector3d& place) const { return line_.dot(place); }

 private:
  Eigen::Matrix3d left_ = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right_ = Eigen::Vector3d::Zero(), line_ = Eigen::Vector3d::Zero();
};

}  // namespace scanchor
