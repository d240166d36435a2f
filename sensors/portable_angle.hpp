#pragma once
// Inverse trigonometric functions for what decides bytes of a data set: only operations that IEEE
// 754 rounds exactly.

#include <cmath>

#include "core/math.hpp"

namespace scanchor {

/// Angle [rad] from its cosine in [0, 1], to 3e-8 rad: finer than the float that keeps it.
/// Abramowitz & Stegun 4.4.46.
inline double angle_of_cosine(double c) {
  double sum = -0.0012624911;
  sum = sum * c + 0.0066700901;
  sum = sum * c - 0.0170881256;
  sum = sum * c + 0.0308918810;
  sum = sum * c - 0.0501743046;
  sum = sum * c + 0.0889789874;
  sum = sum * c - 0.2145988016;
  sum = sum * c + 1.5707963050;
  return std::sqrt(1.0 - c) * sum;
}

/// Arc tangent [rad] of y / x in (-pi, pi], to 1e-15. Two halvings of the angle, atan t = 2 atan(t
/// / (1 + sqrt(1 + t^2))), then the power series.
inline double portable_atan2(double y, double x) {
  if (x == 0.0 && y == 0.0) return 0.0;
  const double ax = std::fabs(x), ay = std::fabs(y);
  const bool steep = ay > ax;
  double t = steep ? ax / ay : ay / ax;
  t = t / (1.0 + std::sqrt(1.0 + t * t));
  t = t / (1.0 + std::sqrt(1.0 + t * t));
  const double s = t * t;
  double sum = 0.0;
  for (int k = 27; k >= 3; k -= 2) sum = s * (1.0 / k - sum);
  double angle = 4.0 * (t - t * sum);
  if (steep) angle = 0.5 * pi - angle;
  if (x < 0.0) angle = pi - angle;
  return y < 0.0 ? -angle : angle;
}

}  // namespace scanchor
