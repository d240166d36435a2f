#include "sensors/vector_rows.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/math.hpp"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace scanchor {
namespace {

constexpr std::size_t block = 64;

// Coefficients of AS 241 for |p - 1/2| <= 0.425, as in core/math.cpp.
constexpr double a[] = {3.3871328727963666080e0,  1.3314166789178437745e+2,
                        1.9715909503065514427e+3, 1.3731693765509461125e+4,
                        4.5921953931549871457e+4, 6.7265770927008700853e+4,
                        3.3430575583588128105e+4, 2.5090809287301226727e+3};
constexpr double b[] = {1.0,
                        4.2313330701600911252e+1,
                        6.8718700749205790830e+2,
                        5.3941960214247511077e+3,
                        2.1213794301586595867e+4,
                        3.9307895800092710610e+4,
                        2.8729085735721942674e+4,
                        5.2264952788528545610e+3};
// The same for the tails down to exp(-25).
constexpr double c[] = {1.42343711074968357734e0,  4.63033784615654529590e0,
                        5.76949722146069140550e0,  3.64784832476320460504e0,
                        1.27045825245236838258e0,  2.41780725177450611770e-1,
                        2.27238449892691845833e-2, 7.74545014278341407640e-4};
constexpr double d[] = {1.0,
                        2.05319162663775882187e0,
                        1.67638483018380384940e0,
                        6.89767334985100004550e-1,
                        1.48103976427480074590e-1,
                        1.51986665636164571966e-2,
                        5.47593808499534494600e-4,
                        1.05075007164441684324e-9};

/// Square roots of an even number of values, in place. std::sqrt may set errno, and a loop that can
/// branch for that has no vectors.
void square_roots(double* x, std::size_t count) {
#if defined(__SSE2__)
  for (std::size_t i = 0; i < count; i += 2) _mm_storeu_pd(x + i, _mm_sqrt_pd(_mm_loadu_pd(x + i)));
#else
  for (std::size_t i = 0; i < count; ++i) x[i] = std::sqrt(x[i]);
#endif
}

inline double horner(const double (&k)[8], double r) {
  return ((((((k[7] * r + k[6]) * r + k[5]) * r + k[4]) * r + k[3]) * r + k[2]) * r + k[1]) * r +
         k[0];
}

}  // namespace

/// Philox4x32-10 for the counters (a, first + k, 0): two uniforms each.
SCANCHOR_EACH_VECTOR_WIDTH
static void uniform_block(std::uint64_t seed, std::uint64_t counter, std::uint32_t first,
                          double* p) {
  constexpr std::size_t half = block / 2;
  std::uint32_t x0[half], x1[half], x2[half], x3[half];
  for (std::size_t i = 0; i < half; ++i) {
    x0[i] = static_cast<std::uint32_t>(counter);
    x1[i] = static_cast<std::uint32_t>(counter >> 32);
    x2[i] = first + static_cast<std::uint32_t>(i);
    x3[i] = 0;
  }
  auto k0 = static_cast<std::uint32_t>(seed);
  auto k1 = static_cast<std::uint32_t>(seed >> 32);
  for (int round = 0; round < 10; ++round) {
    for (std::size_t i = 0; i < half; ++i) {
      const std::uint64_t p0 = std::uint64_t{0xD2511F53} * x0[i];
      const std::uint64_t p1 = std::uint64_t{0xCD9E8D57} * x2[i];
      const std::uint32_t n0 = static_cast<std::uint32_t>(p1 >> 32) ^ x1[i] ^ k0;
      const std::uint32_t n2 = static_cast<std::uint32_t>(p0 >> 32) ^ x3[i] ^ k1;
      x0[i] = n0;
      x1[i] = static_cast<std::uint32_t>(p1);
      x2[i] = n2;
      x3[i] = static_cast<std::uint32_t>(p0);
    }
    k0 += 0x9E3779B9;
    k1 += 0xBB67AE85;
  }
  // 53 bits, w0 << 21 ^ w1 >> 11, as two halves that convert exactly through signed 32-bit
  // integers.
  const auto uniform = [](std::uint32_t w0, std::uint32_t w1) {
    const std::uint32_t low = (w0 << 21) ^ (w1 >> 11);
    const double low_part =
        static_cast<double>(static_cast<std::int32_t>(low ^ 0x80000000U)) + 2147483648.0;
    const double bits =
        static_cast<double>(static_cast<std::int32_t>(w0 >> 11)) * 4294967296.0 + low_part;
    return std::min((bits + 0.5) * 0x1p-53, 1.0 - 0x1p-53);
  };
  for (std::size_t i = 0; i < half; ++i) {
    p[2 * i] = uniform(x0[i], x1[i]);
    p[2 * i + 1] = uniform(x2[i], x3[i]);
  }
}

SCANCHOR_EACH_VECTOR_WIDTH
static void central_quantile_block(const double* p, double* z) {
  for (std::size_t i = 0; i < block; ++i) {
    const double q = p[i] - 0.5;
    const double r = 0.180625 - q * q;
    z[i] = q * horner(a, r) / horner(b, r);
  }
}

/// -portable_log(min(p, 1 - p)) without its branches; p is no subnormal.
SCANCHOR_EACH_VECTOR_WIDTH
static void minus_log_block(const double* p, std::size_t count, double* out) {
  for (std::size_t i = 0; i < count; ++i) {
    const double x = p[i] < 0.5 ? p[i] : 1.0 - p[i];
    std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
    double e = static_cast<double>(static_cast<std::int32_t>(bits >> 52) - 1022);
    bits = (bits & 0x000fffffffffffffULL) | 0x3fe0000000000000ULL;
    double m = std::bit_cast<double>(bits);
    const bool small = m < 0.70710678118654752440;
    m = small ? m * 2.0 : m;
    e = small ? e - 1.0 : e;
    const double f = (m - 1.0) / (m + 1.0);
    const double s = f * f;
    double series = 0.0;
#pragma GCC unroll 11
    for (int k = 23; k >= 3; k -= 2) series = (series + 1.0 / k) * s;
    out[i] = -(e * 6.93147180369123816490e-01 +
               (2.0 * f + (2.0 * f * series + e * 1.90821492927058770002e-10)));
  }
}

/// For |p - 1/2| > 0.425, from the square root of minus the logarithm.
SCANCHOR_EACH_VECTOR_WIDTH
static void tail_quantile_block(const double* p, const double* root, std::size_t count, double* z) {
  for (std::size_t i = 0; i < count; ++i) {
    const double r = root[i] - 1.6;
    const double value = horner(c, r) / horner(d, r);
    z[i] = p[i] < 0.5 ? -value : value;
  }
}

void normal_row(std::uint64_t seed, std::uint64_t counter, std::size_t count, double* out) {
  double p[block], z[block], tail_p[block + 8], tail_z[block + 8], root[block + 8];
  std::size_t tail[block + 1];
  for (std::size_t first = 0; first < count; first += block) {
    uniform_block(seed, counter, static_cast<std::uint32_t>(first / 2), p);
    central_quantile_block(p, z);
    const std::size_t n = std::min(block, count - first);
    std::size_t tails = 0;
    for (std::size_t i = 0; i < n; ++i) {
      out[first + i] = z[i];
      tail[tails] = i;
      tail_p[tails] = p[i];
      tails += std::fabs(p[i] - 0.5) <= 0.425 ? 0U : 1U;
    }
    // Filled up to whole vectors: what is left over would be worked on one by one.
    const std::size_t whole = (tails + 7) & ~std::size_t{7};
    for (std::size_t i = tails; i < whole; ++i) tail_p[i] = 0.01;
    minus_log_block(tail_p, whole, root);
    square_roots(root, whole);
    tail_quantile_block(tail_p, root, whole, tail_z);
    for (std::size_t i = 0; i < tails; ++i) {
      // Beyond exp(-25) AS 241 has a third pair of polynomials: once in 7e10 draws.
      const bool far = tail_p[i] < 1.4e-11 || 1.0 - tail_p[i] < 1.4e-11;
      out[first + tail[i]] = far ? normal_quantile(tail_p[i]) : tail_z[i];
    }
  }
}

SCANCHOR_EACH_VECTOR_WIDTH
static void angle_block(const double* cosine, const double* root, std::size_t count, float* out) {
  for (std::size_t k = 0; k < count; ++k) {
    const double x = cosine[k];
    const double sum =
        ((((((-0.0012624911 * x + 0.0066700901) * x - 0.0170881256) * x + 0.0308918810) * x -
           0.0501743046) *
              x +
          0.0889789874) *
             x -
         0.2145988016) *
            x +
        1.5707963050;
    out[k] = static_cast<float>(root[k] * sum);
  }
}

void angle_row(const double* cosine, std::size_t count, float* out) {
  double root[block];
  for (std::size_t first = 0; first < count; first += block) {
    const std::size_t n = std::min(block, count - first);
    for (std::size_t i = 0; i < block; ++i) root[i] = i < n ? 1.0 - cosine[first + i] : 0.0;
    square_roots(root, block);
    angle_block(cosine + first, root, n, out + first);
  }
}

SCANCHOR_EACH_VECTOR_WIDTH
void transform_row(const double* R, const double* t, const double* x, const double* y,
                   const double* z, std::size_t count, double* __restrict out_x,
                   double* __restrict out_y, double* __restrict out_z) {
  const double tx = t != nullptr ? t[0] : 0.0;
  const double ty = t != nullptr ? t[1] : 0.0;
  const double tz = t != nullptr ? t[2] : 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    out_x[k] = R[0] * x[k] + R[1] * y[k] + R[2] * z[k] + tx;
    out_y[k] = R[3] * x[k] + R[4] * y[k] + R[5] * z[k] + ty;
    out_z[k] = R[6] * x[k] + R[7] * y[k] + R[8] * z[k] + tz;
  }
}

}  // namespace scanchor
