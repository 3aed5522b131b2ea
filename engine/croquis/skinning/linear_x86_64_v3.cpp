// SPDX-License-Identifier: MIT
// Linear blending, four vertices at a time: a vertex's matrix is blended in two registers, then position and normal
// are transformed side by side. Groups are packed before they are stored: a store that reached into the next vertex
// would hold up the loads that follow wherever input and output lie a multiple of 4 KiB apart.
#include "croquis/skinning/x86_64_v3.h"

namespace croquis::skinning_kernels {
namespace {

constexpr std::ptrdiff_t kGroup = 4;
constexpr std::ptrdiff_t kBlock = 64;

// A blended matrix in two registers: columns x | y and z | t.
struct Columns {
  __m256 xy, zt;
};

template <int kInfluences>
[[gnu::always_inline]] inline Columns blend(const MatrixEntry* matrices, const std::uint16_t* indices,
                                            const float* weights, std::ptrdiff_t influences) {
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

// The matrix times (low half of v, 1) and times (high half of v, 0).
[[gnu::always_inline]] inline __m256 transform(const Columns& m, __m256 v) {
  const __m256 x = _mm256_permute2f128_ps(m.xy, m.xy, 0x00), y = _mm256_permute2f128_ps(m.xy, m.xy, 0x11);
  const __m256 z = _mm256_permute2f128_ps(m.zt, m.zt, 0x00), t = _mm256_permute2f128_ps(m.zt, m.zt, 0x81);
  const __m256 zt = _mm256_fmadd_ps(z, _mm256_permute_ps(v, 0xAA), t);
  return _mm256_fmadd_ps(x, _mm256_permute_ps(v, 0x00), _mm256_fmadd_ps(y, _mm256_permute_ps(v, 0x55), zt));
}

// Four vectors x y z _ to x y z x | y z x y | z x y z, in each half.
struct Packed {
  __m256 a, b, c;
};
[[gnu::always_inline]] inline Packed pack(const __m256* v) {
  const __m256 x1 = _mm256_permute_ps(v[1], _MM_SHUFFLE(0, 0, 0, 0));
  const __m256 z2 = _mm256_permute_ps(v[2], _MM_SHUFFLE(2, 2, 2, 2));
  const __m256 xyz3 = _mm256_permute_ps(v[3], _MM_SHUFFLE(2, 1, 0, 0));
  return {_mm256_blend_ps(v[0], x1, 0x88), _mm256_shuffle_ps(v[1], v[2], _MM_SHUFFLE(1, 0, 2, 1)),
          _mm256_blend_ps(xyz3, z2, 0x11)};
}

[[gnu::always_inline]] inline void store_low(float* to, const Packed& packed) {
  _mm_storeu_ps(to, _mm256_castps256_ps128(packed.a));
  _mm_storeu_ps(to + 4, _mm256_castps256_ps128(packed.b));
  _mm_storeu_ps(to + 8, _mm256_castps256_ps128(packed.c));
}

[[gnu::always_inline]] inline void store_high(float* to, const Packed& packed) {
  _mm_storeu_ps(to, _mm256_extractf128_ps(packed.a, 1));
  _mm_storeu_ps(to + 4, _mm256_extractf128_ps(packed.b, 1));
  _mm_storeu_ps(to + 8, _mm256_extractf128_ps(packed.c, 1));
}

// `count` posed normals (a multiple of eight) from `first` on.
[[gnu::always_inline]] inline void normalise_eights(const KernelJob& job, std::ptrdiff_t first, std::ptrdiff_t count) {
  for (std::ptrdiff_t v = first; v < first + count; v += kLanes) {
    __m256 has_direction;
    const Vectors unit = normalised(load(job.posed_normals + 3 * v), has_direction);
    if (_mm256_movemask_ps(has_direction) == 0xFF) {
      store(job.posed_normals + 3 * v, unit);
    } else {
      normalise_portable(job.slice(v, kLanes));
    }
  }
}

// Positions, and with kNormals normals by the same matrices. Copies of what `job` points to: for all the compiler
// knows, a store may change it.
template <int kInfluences, bool kNormals>
void skin(const KernelJob& job) {
  const std::ptrdiff_t influences = kInfluences > 0 ? kInfluences : job.influences;
  const MatrixEntry* const matrices = job.matrices;
  const std::uint16_t* indices = job.joint_indices;
  const float* weights = job.weights;
  const float* positions = job.positions;
  const float* normals = kNormals ? job.normals : job.positions;
  float* posed_positions = job.posed_positions;
  float* posed_normals = job.posed_normals;
  __m256 least = _mm256_set1_ps(1.0F);
  const bool unit_normals = kNormals && job.unit_normals;
  std::ptrdiff_t v = 0;
  // A vector is read with one float beyond it: the last vertices are left to the portable kernel.
  for (; v + kLanes < job.count; v += kLanes) {
    for (int group = 0; group < kLanes / kGroup; ++group) {
      __m256 posed[kGroup];
      for (int i = 0; i < kGroup; ++i) {
        const Columns matrix = blend<kInfluences>(matrices, indices, weights, influences);
        posed[i] = transform(matrix, two_halves(positions + 3 * i, normals + 3 * i));
        least = _mm256_min_ps(least, posed[i]);
        indices += influences;
        weights += influences;
      }
      const Packed packed = pack(posed);
      store_low(posed_positions, packed);
      if constexpr (kNormals) {
        store_high(posed_normals, packed);
        posed_normals += 3 * kGroup;
      }
      positions += 3 * kGroup;
      normals += 3 * kGroup;
      posed_positions += 3 * kGroup;
    }
    // Normals are normalised a block later, when nothing waits for them any more.
    if (unit_normals && v % kBlock == kBlock - kLanes) normalise_eights(job, v + kLanes - kBlock, kBlock);
  }
  if (unit_normals) normalise_eights(job, v - v % kBlock, v % kBlock);
  // The fourth number of a posed position is the sum of the vertex's weights. Vertices without any are rare: the
  // portable kernel then looks at each.
  const bool all_follow = (_mm256_movemask_ps(_mm256_cmp_ps(least, _mm256_setzero_ps(), _CMP_GT_OQ)) & 8) != 0;
  linear_portable(all_follow ? job.slice(v, job.count - v) : job);
}

template <int kInfluences>
void skin(const KernelJob& job) {
  if (job.tangents != nullptr) return linear_portable(job);
  if (job.normals != nullptr && job.normal_matrices == nullptr) return skin<kInfluences, true>(job);
  KernelJob positions = job;
  positions.normals = nullptr;
  skin<kInfluences, false>(positions);
  if (job.normals == nullptr) return;
  // Normals by matrices of their own are positions that are not shifted.
  KernelJob normals = positions;
  normals.matrices = job.normal_matrices;
  normals.positions = job.normals;
  normals.posed_positions = job.posed_normals;
  skin<kInfluences, false>(normals);
  if (job.unit_normals) normalise_portable(job);
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
