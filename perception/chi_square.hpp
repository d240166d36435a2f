#pragma once
// Bounds of chi-square variables, for tests of "is this more than noise".

#include <cmath>

namespace scanchor {

/// Quantile of chi-square with k degrees of freedom, divided by k: the factor by which a measured
/// variance may exceed the true one. `z` is the standard normal quantile of the probability. Wilson
/// and Hilferty, PNAS 17 (1931); error below 1 % for k >= 3.
inline double chi_square_factor(double k, double z) {
  if (k < 1.0) k = 1.0;
  const double a = 2.0 / (9.0 * k);
  const double root = 1.0 - a + z * std::sqrt(a);
  return root * root * root;
}

}  // namespace scanchor
