#pragma once
// The inner loops that every beam runs through, on whole rows: compiled once for each vector width
// and chosen when the program starts. The bits are those of the scalar functions they stand for
// (tests hold them equal): the same operations in the same order, and no fused multiply-add.

#include <cstddef>
#include <cstdint>

// Sanitizers start before the choice can be made; other compilers get the plain loop.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define SCANCHOR_EACH_VECTOR_WIDTH __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define SCANCHOR_EACH_VECTOR_WIDTH
#endif

namespace scanchor {

/// Standard normals: draws 2j and 2j + 1 come from the two halves of the words of
/// CounterRandom(seed) for the counter (a, j), by the same transforms as CounterRandom::normal.
void normal_row(std::uint64_t seed, std::uint64_t a, std::size_t count, double* out);

/// out[k] = float(angle_of_cosine(cosine[k])).
void angle_row(const double* cosine, std::size_t count, float* out);

/// Nine multiplications a vector: out = R in (+ t). R row by row; t may be null.
void transform_row(const double* R, const double* t, const double* x, const double* y,
                   const double* z, std::size_t count, double* out_x, double* out_y, double* out_z);

}  // namespace scanchor
