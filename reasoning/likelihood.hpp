#pragma once
// Elementary likelihoods: what a measured number with its uncertainty says about "at most",
// "between", "within a cone".

#include <Eigen/Core>

namespace scanchor {

inline double sqr(double x) { return x * x; }

/// Density of the normal distribution with mean 0 at x; sigma > 0.
double normal_density(double x, double sigma);

/// P(true value <= limit) for a measurement x with standard deviation sigma >= 0; the crisp
/// predicate for sigma = 0.
double upper_likelihood(double x, double limit, double sigma);
/// P(true value >= limit).
double lower_likelihood(double x, double limit, double sigma);
/// P(low <= true value <= high); low and high may be infinite.
double between_likelihood(double x, double low, double high, double sigma);

/// P(an angle between two directions is at most `tolerance`), measured `theta`, each of the two
/// tilt components with deviation sigma [all rad]. The two components make the length of the tilt
/// Rice distributed (reasoning.md 2.3): 1 - Q1(theta/s, tol/s) with Marcum's Q. Absolute error
/// below 1e-9 for theta/s < 20, below 3e-4 beyond (normal approximation).
double cone_likelihood(double theta, double tolerance, double sigma);

/// P(length of a tilt <= tolerance) where its two components are normal and independent, with means
/// m and deviations s [all rad]: a narrow strip may turn about its long axis and not about the
/// other. Equal deviations give cone_likelihood. Absolute error below 1e-4.
double tilt_likelihood(const Eigen::Vector2d& m, const Eigen::Vector2d& s, double tolerance);

/// The same as between_likelihood for an extent that is only seen in part. `hidden` in [0, 1) is
/// the expected share that is in the shadow. The hidden share is taken as Beta(1, k) with that
/// mean, so k = (1 - hidden) / hidden and a size `low` that is larger than the measured x remains
/// possible with (x / low)^k. hidden = 0 gives between_likelihood.
double censored_likelihood(double x, double low, double high, double sigma, double hidden);

}  // namespace scanchor
