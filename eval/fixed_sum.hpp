#pragma once
// A sum that does not depend on the order of its terms.

#include <cmath>
#include <cstdint>

namespace scanchor {

/// Sum of real numbers on a grid of 2^-36 (1.5e-11), kept as an integer: adding is exact,
/// associative and commutative, so scores of shards pooled in any order have the same bits. Terms
/// must be finite; the sum must stay below 2^26 in absolute value. A term is rounded by at most
/// 0.7e-11, so a mean is off by no more than that.
class FixedSum {
 public:
  void add(double term) { units_ += std::llround(term * scale); }
  void add(const FixedSum& other) { units_ += other.units_; }
  [[nodiscard]] double value() const { return static_cast<double>(units_) / scale; }
  [[nodiscard]] std::int64_t units() const { return units_; }
  static FixedSum from_units(std::int64_t units) {
    FixedSum sum;
    sum.units_ = units;
    return sum;
  }
  friend bool operator==(const FixedSum&, const FixedSum&) = default;

 private:
  static constexpr double scale = 68719476736.0;  // 2^36
  std::int64_t units_ = 0;
};

}  // namespace scanchor
