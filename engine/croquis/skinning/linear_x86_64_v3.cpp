// SPDX-License-Identifier: MIT
// Compiled for AVX2 and FMA: includes nothing whose inline functions another file might share (the linker would keep
// one copy of each, and that one might be ours).
#include <immintrin.h>

#include "croquis/skinning/kernels.h"

namespace croquis::skinning_kernels {
namespace {

// A blended matrix in two registers: columns x | y and z | t.
struct Columns {
  __m256 xy, zt;
};

// kInfluences 0: as many as `influences` says.
template <int kInfluences>
inline Columns blend(const MatrixEntry* matrices, const std::uint16_t* indices, const float* weights,
                     std::ptrdiff_t influences) {
  const std::ptrdiff_t count = kInfluences > 0 ? kInfluences : influences;
  const float* entry = matrices[indices[0]].columns[0];
  __m256 weight = _mm256_broadcast_ss(weights);
  Columns sum = {_mm256_mul_ps(weight, _mm256_load_ps(entry)), _mm256_mul_ps(weight, _mm256_load_ps(entry + 8))};
  for (std::ptrdiff_t k = 1; k < count; ++k) {
    entry = matrices[indices[k]].columns[0];
    weight = _mm256_broadcast_ss(weights + k);
    sum.xy = _mm256_fmadd_ps(weight, _mm256_load_ps(entry), sum.xy);
    sum.zt = _mm256_fmadd_ps(weight, _mm256_load_ps(entry + 8), sum.zt);
  }
  return sum;
}

// The two halves of a matrix times (v, last): their sum is the product. `v` holds one vector in both halves.
inline __m256 halves(const Columns& matrix, __m256 v, __m256 last) {
  const __m256 first_two = _mm256_permutevar_ps(v, _mm256_setr_epi32(0, 0, 0, 0, 1, 1, 1, 1));
  const __m256 third = _mm256_blend_ps(_mm256_permute_ps(v, 0xAA), last, 0xF0);
  return _mm256_fmadd_ps(matrix.xy, first_two, _mm256_mul_ps(matrix.zt, third));
}

inline __m128 sum_of_halves(__m256 v) { return _mm_add_ps(_mm256_castps256_ps128(v), _mm256_extractf128_ps(v, 1)); }

inline __m128i first_three() { return _mm_setr_epi32(-1, -1, -1, 0); }

// Reads and writes one float beyond each vector where there is a next one (kIsLast: where not).
template <bool kIsLast>
inline __m256 load(const float* from) {
  if constexpr (kIsLast) {
    const __m128 v = _mm_maskload_ps(from, first_three());
    return _mm256_insertf128_ps(_mm256_castps128_ps256(v), v, 1);
  }
  return _mm256_broadcast_ps(reinterpret_cast<const __m128*>(from));
}
template <bool kIsLast>
inline void store(float* to, __m128 v) {
  if constexpr (kIsLast) {
    _mm_maskstore_ps(to, first_three(), v);
  } else {
    _mm_storeu_ps(to, v);
  }
}

enum class Vectors { positions, positions_normals, any };

// Vertex v; returns its position, then its sum of weights.
template <int kInfluences, Vectors kVectors, bool kIsLast>
inline __m128 skin_one(const KernelJob& job, std::ptrdiff_t v) {
  const __m256 zero = _mm256_setzero_ps();
  const std::uint16_t* indices = job.joint_indices + v * job.influences;
  const float* weights = job.weights + v * job.influences;
  const Columns matrix = blend<kInfluences>(job.matrices, indices, weights, job.influences);
  const __m256 position = halves(matrix, load<kIsLast>(job.positions + 3 * v), _mm256_set1_ps(1.0F));
  if constexpr (kVectors == Vectors::positions_normals) {
    const __m256 normal = halves(matrix, load<kIsLast>(job.normals + 3 * v), zero);
    const __m256 both =
        _mm256_add_ps(_mm256_permute2f128_ps(position, normal, 0x20), _mm256_permute2f128_ps(position, normal, 0x31));
    const __m128 posed = _mm256_castps256_ps128(both);
    store<kIsLast>(job.posed_positions + 3 * v, posed);
    store<kIsLast>(job.posed_normals + 3 * v, _mm256_extractf128_ps(both, 1));
    return posed;
  }
  const __m128 posed = sum_of_halves(position);
  store<kIsLast>(job.posed_positions + 3 * v, posed);
  if constexpr (kVectors == Vectors::any) {
    if (job.normals != nullptr) {
      const Columns normal_matrix = job.normal_matrices == nullptr
                                        ? matrix
                                        : blend<kInfluences>(job.normal_matrices, indices, weights, job.influences);
      store<kIsLast>(job.posed_normals + 3 * v,
                     sum_of_halves(halves(normal_matrix, load<kIsLast>(job.normals + 3 * v), zero)));
    }
    if (job.tangents != nullptr) {
      const __m256 tangent = load<false>(job.tangents + 4 * v);
      const __m128 turned = sum_of_halves(halves(matrix, tangent, zero));
      _mm_storeu_ps(job.posed_tangents + 4 * v, _mm_blend_ps(turned, _mm256_castps256_ps128(tangent), 8));
    }
  }
  return posed;
}

template <int kInfluences, Vectors kVectors>
void skin(const KernelJob& job) {
  __m128 least = _mm_set1_ps(1.0F);
  for (std::ptrdiff_t v = 0; v + 1 < job.count; ++v) {
    least = _mm_min_ps(least, skin_one<kInfluences, kVectors, false>(job, v));
  }
  if (job.count > 0) least = _mm_min_ps(least, skin_one<kInfluences, kVectors, true>(job, job.count - 1));
  // Vertices without any weight are rare: the portable kernel looks at each.
  if ((_mm_movemask_ps(_mm_cmpgt_ps(least, _mm_setzero_ps())) & 8) == 0) linear_portable(job);
}

template <int kInfluences>
void skin(const KernelJob& job) {
  if (job.tangents != nullptr || (job.normals != nullptr && job.normal_matrices != nullptr)) {
    skin<kInfluences, Vectors::any>(job);
  } else if (job.normals != nullptr) {
    skin<kInfluences, Vectors::positions_normals>(job);
  } else {
    skin<kInfluences, Vectors::positions>(job);
  }
}

}  // namespace

void linear_x86_64_v3(const KernelJob& job) {
  switch (job.influences) {
    case 1:
      return skin<1>(job);
    case 2:
      return skin<2>(job);
    case 3:
      return skin<3>(job);
    case 4:
      return skin<4>(job);
    case 8:
      return skin<8>(job);
    default:
      return skin<0>(job);
  }
}

}  // namespace croquis::skinning_kernels
