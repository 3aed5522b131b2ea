// SPDX-License-Identifier: MIT
#pragma once

#include <immintrin.h>

#include "croquis/skinning/kernels.h"

/// Eight 3-vectors, one per lane: for the files that are compiled for AVX2 and FMA. Those include nothing whose inline
/// functions another file might share (the linker would keep one copy of each, and that one might be theirs): what
/// stands here is inlined wherever it is used.
namespace croquis::skinning_kernels {
namespace {

constexpr std::ptrdiff_t kLanes = 8;

struct Vectors {
  __m256 x, y, z;
};

[[gnu::always_inline]] inline __m256 two_halves(const float* low, const float* high) {
  return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(low)), _mm_loadu_ps(high), 1);
}

// x0 y0 z0 x1 y1 z1 ... to x0 x1 ..., y0 y1 ..., z0 z1 ... and back.
[[gnu::always_inline]] inline Vectors load(const float* from) {
  const __m256 a = two_halves(from, from + 12), b = two_halves(from + 4, from + 16);
  const __m256 c = two_halves(from + 8, from + 20);
  const __m256 xy = _mm256_shuffle_ps(b, c, _MM_SHUFFLE(2, 1, 3, 2));
  const __m256 yz = _mm256_shuffle_ps(a, b, _MM_SHUFFLE(1, 0, 2, 1));
  return {_mm256_shuffle_ps(a, xy, _MM_SHUFFLE(2, 0, 3, 0)), _mm256_shuffle_ps(yz, xy, _MM_SHUFFLE(3, 1, 2, 0)),
          _mm256_shuffle_ps(yz, c, _MM_SHUFFLE(3, 0, 3, 1))};
}

[[gnu::always_inline]] inline void store(float* to, const Vectors& v) {
  const __m256 xy = _mm256_shuffle_ps(v.x, v.y, _MM_SHUFFLE(2, 0, 2, 0));
  const __m256 yz = _mm256_shuffle_ps(v.y, v.z, _MM_SHUFFLE(3, 1, 3, 1));
  const __m256 zx = _mm256_shuffle_ps(v.z, v.x, _MM_SHUFFLE(3, 1, 2, 0));
  const __m256 a = _mm256_shuffle_ps(xy, zx, _MM_SHUFFLE(2, 0, 2, 0));
  const __m256 b = _mm256_shuffle_ps(yz, xy, _MM_SHUFFLE(3, 1, 2, 0));
  const __m256 c = _mm256_shuffle_ps(zx, yz, _MM_SHUFFLE(3, 1, 3, 1));
  _mm256_storeu_ps(to, _mm256_permute2f128_ps(a, b, 0x20));
  _mm256_storeu_ps(to + 8, _mm256_permute2f128_ps(c, a, 0x30));
  _mm256_storeu_ps(to + 16, _mm256_permute2f128_ps(b, c, 0x31));
}

// s * a + b
[[gnu::always_inline]] inline Vectors multiply_add(__m256 s, const Vectors& a, const Vectors& b) {
  return {_mm256_fmadd_ps(s, a.x, b.x), _mm256_fmadd_ps(s, a.y, b.y), _mm256_fmadd_ps(s, a.z, b.z)};
}

// Unit vectors, by an estimate of 1 / sqrt(square) and one step of Newton's method (an error of some 1e-7).
// `has_direction` has all bits in the lanes where there is a direction; the others are of no use.
[[gnu::always_inline]] inline Vectors normalised(const Vectors& v, __m256& has_direction) {
  const __m256 square = _mm256_fmadd_ps(v.z, v.z, _mm256_fmadd_ps(v.y, v.y, _mm256_mul_ps(v.x, v.x)));
  const __m256 guess = _mm256_rsqrt_ps(square);
  const __m256 error = _mm256_fnmadd_ps(_mm256_mul_ps(square, guess), guess, _mm256_set1_ps(1.0F));
  const __m256 scale = _mm256_fmadd_ps(_mm256_mul_ps(error, _mm256_set1_ps(0.5F)), guess, guess);
  has_direction = _mm256_cmp_ps(square, _mm256_set1_ps(kNoDirection), _CMP_GT_OQ);
  return {_mm256_mul_ps(v.x, scale), _mm256_mul_ps(v.y, scale), _mm256_mul_ps(v.z, scale)};
}

}  // namespace
}  // namespace croquis::skinning_kernels
