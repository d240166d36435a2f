#include "reasoning/likelihood.hpp"

#include <algorithm>
#include <cmath>

#include "core/math.hpp"

namespace scanchor {

double normal_density(double x, double sigma) {
  return std::exp(-0.5 * x * x / (sigma * sigma)) / (sigma * std::sqrt(2.0 * pi));
}

double upper_likelihood(double x, double limit, double sigma) {
  if (sigma <= 0.0 || std::isinf(limit)) return x <= limit ? 1.0 : 0.0;
  const double t = (limit - x) / sigma;
  if (t > 8.0) return 1.0;
  if (t < -8.0) return 0.0;
  return normal_cdf(t);
}

double lower_likelihood(double x, double limit, double sigma) {
  return upper_likelihood(-x, -limit, sigma);
}

double between_likelihood(double x, double low, double high, double sigma) {
  const double both = upper_likelihood(x, high, sigma) + lower_likelihood(x, low, sigma) - 1.0;
  return std::clamp(both, 0.0, 1.0);
}

double cone_likelihood(double theta, double tolerance, double sigma) {
  if (sigma <= 0.0) return theta <= tolerance ? 1.0 : 0.0;
  const double a = std::abs(theta) / sigma;
  const double b = tolerance / sigma;
  if (a - b > 8.0) return 0.0;
  if (b - a > 8.0) return 1.0;
  // The squared length is noncentral chi-square with two degrees of freedom: a Poisson(a^2/2)
  // mixture of Gamma(k+1) at b^2/2.
  const double x = 0.5 * a * a;
  const double y = 0.5 * b * b;
  if (x > 200.0 || y > 400.0) return upper_likelihood(a + 0.5 / a, b, 1.0);
  double weight = std::exp(-x);
  double term = std::exp(-y);
  double tail = term;  // sum of the Poisson(y) weights up to k
  double sum = 0.0;
  double seen = 0.0;
  for (int k = 0; k < 2000; ++k) {
    sum += weight * (1.0 - tail);
    seen += weight;
    if (seen > 1.0 - 1e-12 && k > x) break;
    weight *= x / (k + 1);
    term *= y / (k + 1);
    tail = std::min(1.0, tail + term);
  }
  return std::clamp(sum, 0.0, 1.0);
}

double tilt_likelihood(const Eigen::Vector2d& m, const Eigen::Vector2d& s, double tolerance) {
  const double most = s.maxCoeff();
  if (most - s.minCoeff() < 0.05 * most)
    return cone_likelihood(m.norm(), tolerance, std::sqrt(0.5 * s.squaredNorm()));
  if (m.norm() - tolerance > 8.0 * most) return 0.0;
  if (tolerance - m.norm() > 8.0 * most) return 1.0;
  // Across the lesser deviation by the midpoint rule, along the greater one in closed form.
  const int outer = s.x() < s.y() ? 0 : 1;
  const double low = std::max(-tolerance, m[outer] - 6.0 * s[outer]);
  const double high = std::min(tolerance, m[outer] + 6.0 * s[outer]);
  if (low >= high) return 0.0;
  constexpr int steps = 48;
  double sum = 0.0;
  double edge = normal_cdf((low - m[outer]) / s[outer]);
  for (int i = 1; i <= steps; ++i) {
    const double x = low + (high - low) * i / steps;
    const double next = normal_cdf((x - m[outer]) / s[outer]);
    const double middle = x - 0.5 * (high - low) / steps;
    const double half = std::sqrt(std::max(0.0, tolerance * tolerance - middle * middle));
    sum += (next - edge) * between_likelihood(m[1 - outer], -half, half, s[1 - outer]);
    edge = next;
  }
  return std::clamp(sum, 0.0, 1.0);
}

double censored_likelihood(double x, double low, double high, double sigma, double hidden) {
  if (hidden <= 0.0) return between_likelihood(x, low, high, sigma);
  const double at_most = upper_likelihood(x, high, sigma);
  double at_least = lower_likelihood(x, low, sigma);
  if (at_least < 1.0 && low > 0.0 && std::isfinite(low)) {
    const double h = std::min(hidden, 0.95);
    const double k = (1.0 - h) / h;
    const double possible = std::pow(std::clamp(x / low, 0.0, 1.0), k);
    at_least += (1.0 - at_least) * possible;
  }
  return std::clamp(at_most + at_least - 1.0, 0.0, 1.0);
}

}  // namespace scanchor
