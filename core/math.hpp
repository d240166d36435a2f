#pragma once
// Elementary functions whose bits do not depend on the C library. libm differs between platforms in
// the last bit, and one bit is enough to give a data set another hash. Only +, -, *, /, sqrt and
// bit operations are used (IEEE 754 rounds those exactly), and the build forbids contraction into
// fused multiply-add.

namespace scanchor {

inline constexpr double pi = 3.14159265358979323846;

/// Degrees to radians. Angles are radians everywhere unless a name ends in `_deg`.
constexpr double radians(double degrees) { return degrees * (pi / 180.0); }
/// Radians to degrees.
constexpr double degrees(double radians) { return radians * (180.0 / pi); }

/// Natural logarithm of x > 0; relative error below 1e-15.
double portable_log(double x);
/// e^x; relative error below 1e-15 for |x| < 700.
double portable_exp(double x);
struct SinCos {
  double sin, cos;
};
/// Sine and cosine of x in radians; absolute error below 1e-15 for |x| < 1e5.
SinCos portable_sincos(double x);

/// Cumulative distribution of the standard normal, Phi(x). Not bit-portable (erfc); for
/// likelihoods, not for data sets.
double normal_cdf(double x);
/// Quantile of the standard normal, the inverse of Phi, for 0 < p < 1; relative error below 1e-15,
/// bit-portable. Wichura, Algorithm AS 241 (PPND16), Applied Statistics 37 (1988).
double normal_quantile(double p);

}  // namespace scanchor
