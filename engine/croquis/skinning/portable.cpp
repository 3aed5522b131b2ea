// SPDX-License-Identifier: MIT
// Linear blending, and dual quaternions after Kavan, Collins, Zara, O'Sullivan 2008 (kavan2008), one vertex after the
// other on vectors of four floats: SSE2 on x86-64, SIMD128 in WebAssembly, NEON on ARM.
#include <cmath>
#include <cstring>

#include "croquis/skinning/kernels.h"

namespace croquis::skinning_kernels {

KernelJob KernelJob::slice(std::ptrdiff_t first, std::ptrdiff_t length) const {
  KernelJob part = *this;
  const auto forward = [&](auto*& array, std::ptrdiff_t stride) {
    if (array != nullptr) array += first * stride;
  };
  forward(part.joint_indices, influences);
  forward(part.weights, influences);
  forward(part.positions, 3);
  forward(part.normals, 3);
  forward(part.tangents, 4);
  forward(part.posed_positions, 3);
  forward(part.posed_normals, 3);
  forward(part.posed_tangents, 4);
  part.count = length;
  return part;
}

namespace {

using Float4 = float __attribute__((vector_size(16)));

inline Float4 load4(const float* from) {
  Float4 v;
  std::memcpy(&v, from, sizeof v);
  return v;
}
inline Float4 load3(const float* from) { return Float4{from[0], from[1], from[2], 0.0F}; }
inline void store3(float* to, Float4 v) {
  to[0] = v[0];
  to[1] = v[1];
  to[2] = v[2];
}
inline Float4 all(float s) { return Float4{s, s, s, s}; }
inline Float4 yzx(Float4 v) { return __builtin_shufflevector(v, v, 1, 2, 0, 3); }
inline Float4 cross(Float4 a, Float4 b) { return yzx(a * yzx(b) - yzx(a) * b); }
// In every lane.
inline Float4 dot(Float4 a, Float4 b) {
  const Float4 p = a * b;
  const Float4 pairs = p + __builtin_shufflevector(p, p, 1, 0, 3, 2);
  return pairs + __builtin_shufflevector(pairs, pairs, 2, 3, 0, 1);
}
// `value`, negated where `sign` is below 0.
inline Float4 with_sign_of(Float4 sign, Float4 value) { return sign < all(0.0F) ? -value : value; }

// With unit length; `otherwise` where there is no direction.
inline void store_direction(float* to, Float4 v, const float* otherwise) {
  const Float4 direction = __builtin_shufflevector(v, all(0.0F), 0, 1, 2, 4);
  const float square = dot(direction, direction)[0];
  store3(to, square > kNoDirection ? direction * all(1.0F / std::sqrt(square)) : load3(otherwise));
}

inline void store_normal(const KernelJob& job, std::ptrdiff_t v, Float4 normal) {
  if (job.unit_normals) {
    store_direction(job.posed_normals + 3 * v, normal, job.normals + 3 * v);
  } else {
    store3(job.posed_normals + 3 * v, normal);
  }
}

struct Columns {
  Float4 x, y, z, t;

  [[nodiscard]] Float4 turn(const float* v) const { return x * all(v[0]) + y * all(v[1]) + z * all(v[2]); }
};

// kInfluences 0: as many as `influences` says.
template <int kInfluences>
inline Columns blend(const MatrixEntry* matrices, const std::uint16_t* indices, const float* weights,
                     std::ptrdiff_t influences) {
  Columns sum = {all(0.0F), all(0.0F), all(0.0F), all(0.0F)};
  const std::ptrdiff_t count = kInfluences > 0 ? kInfluences : influences;
  for (std::ptrdiff_t k = 0; k < count; ++k) {
    const MatrixEntry& entry = matrices[indices[k]];
    const Float4 weight = all(weights[k]);
    sum.x += weight * load4(entry.columns[0]);
    sum.y += weight * load4(entry.columns[1]);
    sum.z += weight * load4(entry.columns[2]);
    sum.t += weight * load4(entry.columns[3]);
  }
  if (!(sum.t[3] > 0.0F)) {
    const MatrixEntry& entry = matrices[0];
    sum = {load4(entry.columns[0]), load4(entry.columns[1]), load4(entry.columns[2]), load4(entry.columns[3])};
  }
  return sum;
}

template <int kInfluences>
void linear(const KernelJob& job) {
  for (std::ptrdiff_t v = 0; v < job.count; ++v) {
    const std::uint16_t* indices = job.joint_indices + v * job.influences;
    const float* weights = job.weights + v * job.influences;
    const Columns matrix = blend<kInfluences>(job.matrices, indices, weights, job.influences);
    store3(job.posed_positions + 3 * v, matrix.turn(job.positions + 3 * v) + matrix.t);
    if (job.normals != nullptr) {
      const Columns normal_matrix = job.normal_matrices == nullptr
                                        ? matrix
                                        : blend<kInfluences>(job.normal_matrices, indices, weights, job.influences);
      store_normal(job, v, normal_matrix.turn(job.normals + 3 * v));
    }
    if (job.tangents != nullptr) {
      store_direction(job.posed_tangents + 4 * v, matrix.turn(job.tangents + 4 * v), job.tangents + 4 * v);
      job.posed_tangents[4 * v + 3] = job.tangents[4 * v + 3];
    }
  }
}

// The blended dual quaternion of one vertex: every influence is taken with the sign that is nearer to the heaviest's,
// because q and -q are the same rotation. The largest weight is positive, so the sum cannot vanish.
inline void blend_dual(const DualQuaternionEntry* palette, const std::uint16_t* indices, const float* weights,
                       std::ptrdiff_t influences, Float4& real, Float4& dual) {
  std::ptrdiff_t heaviest = 0;
  for (std::ptrdiff_t k = 1; k < influences; ++k) {
    if (weights[k] > weights[heaviest]) heaviest = k;
  }
  const bool follows_none = !(weights[heaviest] > 0.0F);
  const DualQuaternionEntry& first = palette[follows_none ? 0 : indices[heaviest]];
  const Float4 pivot = load4(first.real);
  if (follows_none) {
    real = pivot;
    dual = load4(first.dual);
    return;
  }
  real = all(0.0F);
  dual = all(0.0F);
  for (std::ptrdiff_t k = 0; k < influences; ++k) {
    const DualQuaternionEntry& entry = palette[indices[k]];
    const Float4 entry_real = load4(entry.real);
    const Float4 weight = with_sign_of(dot(pivot, entry_real), all(weights[k]));
    real += weight * entry_real;
    dual += weight * load4(entry.dual);
  }
}

}  // namespace

void linear_portable(const KernelJob& job) {
  switch (job.influences) {
    case 1:
      return linear<1>(job);
    case 4:
      return linear<4>(job);
    case 8:
      return linear<8>(job);
    default:
      return linear<0>(job);
  }
}

void dual_quaternion_portable(const KernelJob& job) {
  for (std::ptrdiff_t v = 0; v < job.count; ++v) {
    Float4 real, dual;
    blend_dual(job.dual_quaternions, job.joint_indices + v * job.influences, job.weights + v * job.influences,
               job.influences, real, dual);
    // With r the real and d the dual part, neither normalised:
    //   rotated v = v + 2 / |r|^2 r x (r x v + r_w v),   translation = 2 / |r|^2 (r_w d - d_w r + r x d).
    const Float4 twice = all(2.0F) / dot(real, real), scalar = all(real[3]);
    const auto rotated = [&](const float* vector) {
      const Float4 p = load3(vector);
      return p + twice * cross(real, cross(real, p) + scalar * p);
    };
    const Float4 translation = twice * (scalar * dual - all(dual[3]) * real + cross(real, dual));
    store3(job.posed_positions + 3 * v, rotated(job.positions + 3 * v) + translation);
    if (job.normals != nullptr) store_normal(job, v, rotated(job.normals + 3 * v));
    if (job.tangents != nullptr) {
      store_direction(job.posed_tangents + 4 * v, rotated(job.tangents + 4 * v), job.tangents + 4 * v);
      job.posed_tangents[4 * v + 3] = job.tangents[4 * v + 3];
    }
  }
}

void normalise_portable(const KernelJob& job) {
  for (std::ptrdiff_t v = 0; v < job.count; ++v) {
    store_direction(job.posed_normals + 3 * v, load3(job.posed_normals + 3 * v), job.normals + 3 * v);
  }
}

}  // namespace croquis::skinning_kernels
