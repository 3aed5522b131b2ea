// SPDX-License-Identifier: MIT
// Dual quaternions (kavan2008), eight vertices at a time: each vertex's dual quaternions are blended in one register,
// then eight of them are transposed so that every lane is a vertex.
#include "croquis/skinning/x86_64_v3.h"

namespace croquis::skinning_kernels {
namespace {

// Vertices whose blended dual quaternions fit in the first-level cache.
constexpr std::ptrdiff_t kBlock = 64;
constexpr float kLeastWeight = 1e-30F;

[[gnu::always_inline]] inline Vectors cross(const Vectors& a, const Vectors& b) {
  return {_mm256_fmsub_ps(a.y, b.z, _mm256_mul_ps(a.z, b.y)), _mm256_fmsub_ps(a.z, b.x, _mm256_mul_ps(a.x, b.z)),
          _mm256_fmsub_ps(a.x, b.y, _mm256_mul_ps(a.y, b.x))};
}

// The weights of four influences of two vertices, negated where a quaternion points away from the first one's. `bad`
// gets bits where the first weight is not the largest, or is 0.
[[gnu::always_inline]] inline __m256 signed_weights(const DualQuaternionEntry* palette, const std::uint16_t* indices,
                                                    const float* weights, __m256& bad) {
  const auto real = [&](int k) __attribute__((always_inline)) {
    return two_halves(palette[indices[k]].real, palette[indices[k + 4]].real);
  };
  const __m256 first = real(0);
  const __m256 p0 = _mm256_mul_ps(first, first), p1 = _mm256_mul_ps(first, real(1));
  const __m256 p2 = _mm256_mul_ps(first, real(2)), p3 = _mm256_mul_ps(first, real(3));
  const __m256 s01 = _mm256_add_ps(_mm256_unpacklo_ps(p0, p1), _mm256_unpackhi_ps(p0, p1));
  const __m256 s23 = _mm256_add_ps(_mm256_unpacklo_ps(p2, p3), _mm256_unpackhi_ps(p2, p3));
  const __m256 dots = _mm256_add_ps(_mm256_shuffle_ps(s01, s23, _MM_SHUFFLE(1, 0, 1, 0)),
                                    _mm256_shuffle_ps(s01, s23, _MM_SHUFFLE(3, 2, 3, 2)));
  const __m256 w = _mm256_loadu_ps(weights);
  const __m256 most = _mm256_max_ps(w, _mm256_set1_ps(kLeastWeight));
  bad = _mm256_or_ps(bad, _mm256_cmp_ps(_mm256_permute_ps(w, 0), most, _CMP_LT_OQ));
  return _mm256_xor_ps(w, _mm256_and_ps(dots, _mm256_set1_ps(-0.0F)));
}

// The signed weights of `count` vertices (an even number) with four influences each. False: somewhere the first weight
// is not the largest, or is 0, and the result is of no use.
bool sign_weights(const KernelJob& block, float* signed_weights_of_all) {
  __m256 bad = _mm256_setzero_ps();
  for (std::ptrdiff_t slot = 0; slot < 4 * block.count; slot += 8) {
    _mm256_store_ps(signed_weights_of_all + slot,
                    signed_weights(block.dual_quaternions, block.joint_indices + slot, block.weights + slot, bad));
  }
  return _mm256_movemask_ps(bad) == 0;
}

// Blends dual quaternions into rows of real | dual. kInfluences 0: as many as the block says.
template <int kInfluences>
void blend(const KernelJob& block, const float* weights, float* rows) {
  const std::ptrdiff_t influences = kInfluences > 0 ? kInfluences : block.influences;
  const DualQuaternionEntry* const palette = block.dual_quaternions;
  const std::uint16_t* indices = block.joint_indices;
  for (std::ptrdiff_t v = 0; v < block.count; ++v) {
    __m256 sum = _mm256_mul_ps(_mm256_broadcast_ss(weights), _mm256_load_ps(palette[indices[0]].real));
    for (std::ptrdiff_t k = 1; k < influences; ++k) {
      sum = _mm256_fmadd_ps(_mm256_broadcast_ss(weights + k), _mm256_load_ps(palette[indices[k]].real), sum);
    }
    _mm256_store_ps(rows + 8 * v, sum);
    indices += influences;
    weights += influences;
  }
}

// Of every vertex with four influences the first weighs most, and more than nothing. `count` is even.
bool first_weighs_most(const float* weights, std::ptrdiff_t count) {
  __m256 bad = _mm256_setzero_ps();
  for (std::ptrdiff_t slot = 0; slot < 4 * count; slot += 8) {
    const __m256 w = _mm256_loadu_ps(weights + slot);
    const __m256 most = _mm256_max_ps(w, _mm256_set1_ps(kLeastWeight));
    bad = _mm256_or_ps(bad, _mm256_cmp_ps(_mm256_permute_ps(w, 0), most, _CMP_LT_OQ));
  }
  return _mm256_movemask_ps(bad) == 0;
}

// As `blend`, four influences with signs from the table.
void blend_by_table(const KernelJob& block, float* rows) {
  const DualQuaternionEntry* const palette = block.dual_quaternions;
  const std::uint16_t* i = block.joint_indices;
  const float* w = block.weights;
  for (std::ptrdiff_t v = 0; v < block.count; ++v, i += 4, w += 4) {
    const float* const signs = block.signs + i[0] * block.palette_size;
    __m256 sum = _mm256_mul_ps(_mm256_broadcast_ss(w), _mm256_load_ps(palette[i[0]].real));
    for (int k = 1; k < 4; ++k) {
      const __m256 weight = _mm256_xor_ps(_mm256_broadcast_ss(w + k), _mm256_broadcast_ss(signs + i[k]));
      sum = _mm256_fmadd_ps(weight, _mm256_load_ps(palette[i[k]].real), sum);
    }
    _mm256_store_ps(rows + 8 * v, sum);
  }
}

// The same with signs, for any number of influences and without a table. False as above.
bool blend_signed(const KernelJob& block, float* rows) {
  bool is_plain = true;
  const DualQuaternionEntry* const palette = block.dual_quaternions;
  for (std::ptrdiff_t v = 0; v < block.count; ++v) {
    const std::uint16_t* i = block.joint_indices + v * block.influences;
    const float* w = block.weights + v * block.influences;
    const __m256 first = _mm256_load_ps(palette[i[0]].real);
    __m256 sum = _mm256_mul_ps(_mm256_broadcast_ss(w), first);
    is_plain &= w[0] >= kLeastWeight;
    for (std::ptrdiff_t k = 1; k < block.influences; ++k) {
      const __m256 entry = _mm256_load_ps(palette[i[k]].real);
      const __m128 dot = _mm_dp_ps(_mm256_castps256_ps128(first), _mm256_castps256_ps128(entry), 0xFF);
      const __m128 weight = _mm_xor_ps(_mm_broadcast_ss(w + k), _mm_and_ps(dot, _mm_set1_ps(-0.0F)));
      sum = _mm256_fmadd_ps(_mm256_insertf128_ps(_mm256_castps128_ps256(weight), weight, 1), entry, sum);
      is_plain &= w[k] <= w[0];
    }
    _mm256_store_ps(rows + 8 * v, sum);
  }
  return is_plain;
}

// Rows of real | dual to lanes of x y z w of each; `rows` holds eight rows.
[[gnu::always_inline]] inline void transpose(const float* rows, Vectors& real, __m256& real_w, Vectors& dual,
                                             __m256& dual_w) {
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

// The rigid motions of eight vertices, one per lane: columns of a rotation, and a translation.
struct Motions {
  Vectors x, y, z, t;
};

// `least` is lowered to the least |r|^2. With r the real and d the dual part, neither normalised, and s = 2 / |r|^2:
//   rotation = 1 + s (r_w [r]x + [r]x [r]x),   translation = s (r_w d - d_w r + r x d).
[[gnu::always_inline]] inline Motions to_motions(const float* rows, __m256& least) {
  Vectors r, d;
  __m256 rw, dw;
  transpose(rows, r, rw, d, dw);
  const __m256 xx = _mm256_mul_ps(r.x, r.x), yy = _mm256_mul_ps(r.y, r.y), zz = _mm256_mul_ps(r.z, r.z);
  const __m256 square = _mm256_add_ps(_mm256_fmadd_ps(rw, rw, xx), _mm256_add_ps(yy, zz));
  least = _mm256_min_ps(least, square);
  const __m256 s = _mm256_div_ps(_mm256_set1_ps(2.0F), square);
  const Vectors u = {_mm256_mul_ps(s, r.x), _mm256_mul_ps(s, r.y), _mm256_mul_ps(s, r.z)};
  const __m256 w = _mm256_mul_ps(s, rw), one = _mm256_set1_ps(1.0F);
  const __m256 wx = _mm256_mul_ps(w, r.x), wy = _mm256_mul_ps(w, r.y), wz = _mm256_mul_ps(w, r.z);
  const Vectors inner = multiply_add(rw, d, cross(r, d));
  return {
      {_mm256_fnmadd_ps(s, _mm256_add_ps(yy, zz), one), _mm256_fmadd_ps(u.x, r.y, wz), _mm256_fmsub_ps(u.x, r.z, wy)},
      {_mm256_fmsub_ps(u.x, r.y, wz), _mm256_fnmadd_ps(s, _mm256_add_ps(xx, zz), one), _mm256_fmadd_ps(u.y, r.z, wx)},
      {_mm256_fmadd_ps(u.x, r.z, wy), _mm256_fmsub_ps(u.y, r.z, wx), _mm256_fnmadd_ps(s, _mm256_add_ps(xx, yy), one)},
      {_mm256_mul_ps(s, _mm256_fnmadd_ps(dw, r.x, inner.x)), _mm256_mul_ps(s, _mm256_fnmadd_ps(dw, r.y, inner.y)),
       _mm256_mul_ps(s, _mm256_fnmadd_ps(dw, r.z, inner.z))}};
}

[[gnu::always_inline]] inline Vectors turn(const Motions& m, const Vectors& v) {
  const Vectors x = {_mm256_mul_ps(m.x.x, v.x), _mm256_mul_ps(m.x.y, v.x), _mm256_mul_ps(m.x.z, v.x)};
  return multiply_add(v.z, m.z, multiply_add(v.y, m.y, x));
}

// Moves the eight vertices from v on.
[[gnu::always_inline]] inline void move_eight(const KernelJob& job, std::ptrdiff_t v, const Motions& motions) {
  const Vectors p = load(job.positions + 3 * v);
  const Vectors posed =
      multiply_add(p.z, motions.z, multiply_add(p.y, motions.y, multiply_add(p.x, motions.x, motions.t)));
  if (job.normals == nullptr) return store(job.posed_positions + 3 * v, posed);
  const Vectors normal = load(job.normals + 3 * v);
  const Vectors turned = turn(motions, normal);
  // Stores come after all loads: one may hold up a load that lies a multiple of 4 KiB away.
  store(job.posed_positions + 3 * v, posed);
  if (!job.unit_normals) return store(job.posed_normals + 3 * v, turned);
  __m256 has_direction;
  const Vectors unit = normalised(turned, has_direction);
  store(job.posed_normals + 3 * v,
        {_mm256_blendv_ps(normal.x, unit.x, has_direction), _mm256_blendv_ps(normal.y, unit.y, has_direction),
         _mm256_blendv_ps(normal.z, unit.z, has_direction)});
}

bool blend_block(const KernelJob& block, float* rows) {
  alignas(32) float weights[4 * kBlock];
  if (block.share_hemisphere) {
    block.influences == 4 ? blend<4>(block, block.weights, rows) : blend<0>(block, block.weights, rows);
    return true;
  }
  if (block.influences != 4) return blend_signed(block, rows);
  if (block.signs != nullptr) {
    if (!first_weighs_most(block.weights, block.count)) return false;
    blend_by_table(block, rows);
    return true;
  }
  if (!sign_weights(block, weights)) return false;
  blend<4>(block, weights, rows);
  return true;
}

// Loop after loop, so that none waits for another.
void skin_block(const KernelJob& block) {
  alignas(32) float rows[8 * kBlock];
  if (!blend_block(block, rows)) return dual_quaternion_portable(block);
  __m256 least = _mm256_set1_ps(1.0F);
  for (std::ptrdiff_t v = 0; v < block.count; v += kLanes) move_eight(block, v, to_motions(rows + 8 * v, least));
  const __m256 follow_none = _mm256_cmp_ps(least, _mm256_set1_ps(kLeastWeight), _CMP_LT_OQ);
  if (_mm256_movemask_ps(follow_none) != 0) dual_quaternion_portable(block);  // over what was written
}

}  // namespace

void dual_quaternion_x86_64_v3(const KernelJob& job) {
  if (job.tangents != nullptr) return dual_quaternion_portable(job);
  const std::ptrdiff_t whole_lanes = job.count - job.count % kLanes;
  for (std::ptrdiff_t v = 0; v < whole_lanes; v += kBlock) {
    const std::ptrdiff_t left = whole_lanes - v;
    skin_block(job.slice(v, left < kBlock ? left : kBlock));
  }
  dual_quaternion_portable(job.slice(whole_lanes, job.count - whole_lanes));
}

}  // namespace croquis::skinning_kernels
