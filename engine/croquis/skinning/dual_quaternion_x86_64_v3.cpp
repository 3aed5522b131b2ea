// SPDX-License-Identifier: MIT
// Dual quaternions (kavan2008), eight vertices at a time: each vertex's dual quaternions are blended in one register,
// then eight of them are transposed so that every lane is a vertex. Compiled for AVX2 and FMA: includes nothing whose
// inline functions another file might share (the linker would keep one copy of each, and that one might be ours).
#include <immintrin.h>

#include "croquis/skinning/kernels.h"

namespace croquis::skinning_kernels {
namespace {

constexpr std::ptrdiff_t kLanes = 8;
constexpr std::ptrdiff_t kMostInfluences = 8;

// Eight vectors, one per lane.
struct Vectors {
  __m256 x, y, z;
};

inline __m256 two_halves(const float* low, const float* high) {
  return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(low)), _mm_loadu_ps(high), 1);
}

// x0 y0 z0 x1 y1 z1 ... to x0 x1 ..., y0 y1 ..., z0 z1 ... and back.
inline Vectors load(const float* from) {
  const __m256 a = two_halves(from, from + 12), b = two_halves(from + 4, from + 16),
               c = two_halves(from + 8, from + 20);
  const __m256 xy = _mm256_shuffle_ps(b, c, _MM_SHUFFLE(2, 1, 3, 2));
  const __m256 yz = _mm256_shuffle_ps(a, b, _MM_SHUFFLE(1, 0, 2, 1));
  return {_mm256_shuffle_ps(a, xy, _MM_SHUFFLE(2, 0, 3, 0)), _mm256_shuffle_ps(yz, xy, _MM_SHUFFLE(3, 1, 2, 0)),
          _mm256_shuffle_ps(yz, c, _MM_SHUFFLE(3, 0, 3, 1))};
}

inline void store(float* to, const Vectors& v) {
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

inline Vectors cross(const Vectors& a, const Vectors& b) {
  return {_mm256_fmsub_ps(a.y, b.z, _mm256_mul_ps(a.z, b.y)), _mm256_fmsub_ps(a.z, b.x, _mm256_mul_ps(a.x, b.z)),
          _mm256_fmsub_ps(a.x, b.y, _mm256_mul_ps(a.y, b.x))};
}

// s * a + b
inline Vectors multiply_add(__m256 s, const Vectors& a, const Vectors& b) {
  return {_mm256_fmadd_ps(s, a.x, b.x), _mm256_fmadd_ps(s, a.y, b.y), _mm256_fmadd_ps(s, a.z, b.z)};
}

// The weights of four influences of two vertices, negated where a quaternion points away from the first one's.
// `bad` gets bits where the first weight is not the largest or is 0.
inline __m256 signed_weights(const DualQuaternionEntry* palette, const std::uint16_t* indices, const float* weights,
                             __m256& bad) {
  const auto real = [&](int k) { return two_halves(palette[indices[k]].real, palette[indices[4 + k]].real); };
  const __m256 first = real(0);
  const __m256 p0 = _mm256_mul_ps(first, first), p1 = _mm256_mul_ps(first, real(1));
  const __m256 p2 = _mm256_mul_ps(first, real(2)), p3 = _mm256_mul_ps(first, real(3));
  const __m256 s01 = _mm256_add_ps(_mm256_unpacklo_ps(p0, p1), _mm256_unpackhi_ps(p0, p1));
  const __m256 s23 = _mm256_add_ps(_mm256_unpacklo_ps(p2, p3), _mm256_unpackhi_ps(p2, p3));
  const __m256 dots = _mm256_add_ps(_mm256_shuffle_ps(s01, s23, _MM_SHUFFLE(1, 0, 1, 0)),
                                    _mm256_shuffle_ps(s01, s23, _MM_SHUFFLE(3, 2, 3, 2)));
  const __m256 w = _mm256_loadu_ps(weights);
  const __m256 largest = _mm256_permute_ps(w, 0);
  bad = _mm256_or_ps(bad, _mm256_cmp_ps(largest, w, _CMP_LT_OQ));
  bad = _mm256_or_ps(bad, _mm256_cmp_ps(largest, _mm256_setzero_ps(), _CMP_LE_OQ));
  return _mm256_xor_ps(w, _mm256_and_ps(dots, _mm256_set1_ps(-0.0F)));
}

// The same for any number of influences of one vertex.
inline bool signed_weights_of_one(const DualQuaternionEntry* palette, const std::uint16_t* indices,
                                  const float* weights, std::ptrdiff_t influences, float* result) {
  const __m128 first = _mm_load_ps(palette[indices[0]].real);
  bool is_plain = weights[0] > 0.0F;
  result[0] = weights[0];
  for (std::ptrdiff_t k = 1; k < influences; ++k) {
    const float dot = _mm_cvtss_f32(_mm_dp_ps(first, _mm_load_ps(palette[indices[k]].real), 0xF1));
    result[k] = dot < 0.0F ? -weights[k] : weights[k];
    is_plain = is_plain && weights[k] <= weights[0];
  }
  return is_plain;
}

template <int kInfluences>
inline __m256 blend(const DualQuaternionEntry* palette, const std::uint16_t* indices, const float* weights,
                    std::ptrdiff_t influences) {
  const std::ptrdiff_t count = kInfluences > 0 ? kInfluences : influences;
  __m256 sum = _mm256_mul_ps(_mm256_broadcast_ss(weights), _mm256_load_ps(palette[indices[0]].real));
  for (std::ptrdiff_t k = 1; k < count; ++k) {
    sum = _mm256_fmadd_ps(_mm256_broadcast_ss(weights + k), _mm256_load_ps(palette[indices[k]].real), sum);
  }
  return sum;
}

// Rows of real | dual to lanes of x y z w of each; `rows` holds eight rows.
inline void transpose(const float* rows, Vectors& real, __m256& real_w, Vectors& dual, __m256& dual_w) {
  const auto quarter = [&](std::ptrdiff_t part, __m256& x, __m256& y, __m256& z, __m256& w) {
    const __m256 a = two_halves(rows + part, rows + 32 + part), b = two_halves(rows + 8 + part, rows + 40 + part);
    const __m256 c = two_halves(rows + 16 + part, rows + 48 + part), d = two_halves(rows + 24 + part, rows + 56 + part);
    const __m256 ab_low = _mm256_unpacklo_ps(a, b), ab_high = _mm256_unpackhi_ps(a, b);
    const __m256 cd_low = _mm256_unpacklo_ps(c, d), cd_high = _mm256_unpackhi_ps(c, d);
    x = _mm256_shuffle_ps(ab_low, cd_low, _MM_SHUFFLE(1, 0, 1, 0));
    y = _mm256_shuffle_ps(ab_low, cd_low, _MM_SHUFFLE(3, 2, 3, 2));
    z = _mm256_shuffle_ps(ab_high, cd_high, _MM_SHUFFLE(1, 0, 1, 0));
    w = _mm256_shuffle_ps(ab_high, cd_high, _MM_SHUFFLE(3, 2, 3, 2));
  };
  quarter(0, real.x, real.y, real.z, real_w);
  quarter(4, dual.x, dual.y, dual.z, dual_w);
}

// Eight vertices from v on.
template <int kInfluences>
inline void skin_eight(const KernelJob& job, std::ptrdiff_t v) {
  const std::ptrdiff_t influences = kInfluences > 0 ? kInfluences : job.influences;
  const std::uint16_t* indices = job.joint_indices + v * influences;
  const float* weights = job.weights + v * influences;
  alignas(32) float signed_buffer[kLanes * kMostInfluences];
  bool is_plain = true;
  if constexpr (kInfluences == 4) {
    __m256 bad = _mm256_setzero_ps();
    for (std::ptrdiff_t pair = 0; pair < kLanes; pair += 2) {
      _mm256_store_ps(signed_buffer + 4 * pair,
                      signed_weights(job.dual_quaternions, indices + 4 * pair, weights + 4 * pair, bad));
    }
    is_plain = _mm256_movemask_ps(bad) == 0;
  } else {
    for (std::ptrdiff_t lane = 0; lane < kLanes; ++lane) {
      is_plain &= signed_weights_of_one(job.dual_quaternions, indices + lane * influences, weights + lane * influences,
                                        influences, signed_buffer + lane * influences);
    }
  }
  if (!is_plain) return dual_quaternion_portable(job.slice(v, kLanes));

  alignas(32) float rows[kLanes * 8];
  for (std::ptrdiff_t lane = 0; lane < kLanes; ++lane) {
    _mm256_store_ps(rows + 8 * lane, blend<kInfluences>(job.dual_quaternions, indices + lane * influences,
                                                        signed_buffer + lane * influences, influences));
  }
  Vectors real, dual;
  __m256 real_w, dual_w;
  transpose(rows, real, real_w, dual, dual_w);

  // The formulas of the portable kernel.
  __m256 square = _mm256_mul_ps(real_w, real_w);
  square = _mm256_fmadd_ps(real.x, real.x, square);
  square = _mm256_fmadd_ps(real.y, real.y, square);
  square = _mm256_fmadd_ps(real.z, real.z, square);
  const __m256 twice = _mm256_div_ps(_mm256_set1_ps(2.0F), square);
  const auto turn = [&](const Vectors& p, const Vectors& plus) {
    const Vectors inner = cross(real, p);
    return multiply_add(twice, cross(real, multiply_add(real_w, p, inner)), plus);
  };
  const __m256 minus_dual_w = _mm256_xor_ps(dual_w, _mm256_set1_ps(-0.0F));
  const Vectors shift = multiply_add(real_w, dual, multiply_add(minus_dual_w, real, cross(real, dual)));
  const Vectors position = load(job.positions + 3 * v);
  store(job.posed_positions + 3 * v, turn(position, multiply_add(twice, shift, position)));
  if (job.normals == nullptr) return;
  const Vectors normal = load(job.normals + 3 * v);
  store(job.posed_normals + 3 * v, turn(normal, normal));
}

template <int kInfluences>
void skin(const KernelJob& job) {
  std::ptrdiff_t v = 0;
  for (; v + kLanes <= job.count; v += kLanes) skin_eight<kInfluences>(job, v);
  if (v < job.count) dual_quaternion_portable(job.slice(v, job.count - v));
}

}  // namespace

void dual_quaternion_x86_64_v3(const KernelJob& job) {
  if (job.tangents != nullptr || job.influences > kMostInfluences) return dual_quaternion_portable(job);
  switch (job.influences) {
    case 4:
      return skin<4>(job);
    case 8:
      return skin<8>(job);
    default:
      return skin<0>(job);
  }
}

void normalise_x86_64_v3(const float* otherwise, float* vectors, std::ptrdiff_t count) {
  std::ptrdiff_t v = 0;
  for (; v + kLanes <= count; v += kLanes) {
    const Vectors vector = load(vectors + 3 * v);
    __m256 square = _mm256_mul_ps(vector.x, vector.x);
    square = _mm256_fmadd_ps(vector.y, vector.y, square);
    square = _mm256_fmadd_ps(vector.z, vector.z, square);
    const __m256 has_direction = _mm256_cmp_ps(square, _mm256_set1_ps(kNoDirection), _CMP_GT_OQ);
    if (_mm256_movemask_ps(has_direction) != 0xFF) {
      normalise_portable(otherwise + 3 * v, vectors + 3 * v, kLanes);
      continue;
    }
    // An estimate of 1 / sqrt(square) and one step of Newton's method: an error of some 1e-7.
    const __m256 guess = _mm256_rsqrt_ps(square);
    const __m256 error = _mm256_fnmadd_ps(_mm256_mul_ps(square, guess), guess, _mm256_set1_ps(1.0F));
    const __m256 scale = _mm256_fmadd_ps(_mm256_mul_ps(error, _mm256_set1_ps(0.5F)), guess, guess);
    store(vectors + 3 * v,
          {_mm256_mul_ps(vector.x, scale), _mm256_mul_ps(vector.y, scale), _mm256_mul_ps(vector.z, scale)});
  }
  normalise_portable(otherwise + 3 * v, vectors + 3 * v, count - v);
}

}  // namespace croquis::skinning_kernels
