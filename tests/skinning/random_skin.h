// SPDX-License-Identifier: MIT
// Random skinned vertices, and skinning as the formulas say it, in double and without any trick.
#pragma once

#include "support/random_math.h"
#include <algorithm>
#include <vector>

#include "croquis/mesh/skin.h"
#include "croquis/skinning/skin_vertices.h"

namespace croquis {

struct RandomSkin {
  std::vector<std::uint16_t> indices;
  std::vector<float> weights;
  int influences = 4;
  std::vector<Vec3f> positions, normals;
  std::vector<Vec4f> tangents;
};

inline RandomSkin random_skin(Random& random, int vertices, int joints, int influences) {
  RandomSkin skin;
  skin.influences = influences;
  for (int v = 0; v < vertices; ++v) {
    std::vector<float> weights(static_cast<std::size_t>(influences));
    float sum = 0.0F;
    for (float& weight : weights)
      sum += weight = random.index(5) == 0 ? 0.0F : static_cast<float>(random.uniform(0.0, 1.0));
    for (float& weight : weights) weight = sum > 0.0F ? weight / sum : 0.0F;
    if (random.index(2) == 0) std::sort(weights.begin(), weights.end(), std::greater<>());
    for (const float weight : weights) {
      skin.weights.push_back(weight);
      skin.indices.push_back(static_cast<std::uint16_t>(random.index(joints)));
    }
    skin.positions.emplace_back(random_vector(random).cast<float>());
    const Vec3 normal = random_vector(random).normalized();
    skin.normals.emplace_back(normal.cast<float>());
    const Vec3 tangent = normal.unitOrthogonal();
    skin.tangents.emplace_back(
        Vec4(tangent.x(), tangent.y(), tangent.z(), random.index(2) == 0 ? 1.0 : -1.0).cast<float>());
  }
  return skin;
}

inline Affine rigid(const Quat& rotation, const Vec3& translation) {
  Affine affine = Affine::Identity();
  affine.linear() = rotation.toRotationMatrix();
  affine.translation() = translation;
  return affine;
}

inline std::vector<Affine> random_rigid_palette(Random& random, int joints) {
  std::vector<Affine> palette;
  for (int i = 0; i < joints; ++i) palette.push_back(rigid(random_rotation(random), random_vector(random)));
  return palette;
}

struct Skinned {
  std::vector<Vec3f> positions, normals;
  std::vector<Vec4f> tangents;
};

inline SkinningJob job_of(const RandomSkin& skin, Skinned& out) {
  out.positions.resize(skin.positions.size());
  out.normals.resize(skin.normals.size());
  out.tangents.resize(skin.tangents.size());
  return {.joint_indices = skin.indices,
          .weights = skin.weights,
          .influences = skin.influences,
          .positions = skin.positions,
          .normals = skin.normals,
          .tangents = skin.tangents,
          .posed_positions = out.positions,
          .posed_normals = out.normals,
          .posed_tangents = out.tangents};
}

inline Skinned skinned(const SkinningPalette& palette, const RandomSkin& skin) {
  Skinned out;
  skin_vertices(palette, job_of(skin, out));
  return out;
}

/// The heaviest influence of a vertex, or -1 for none.
inline int heaviest(const RandomSkin& skin, int vertex) {
  int best = -1;
  for (int k = vertex * skin.influences; k < (vertex + 1) * skin.influences; ++k) {
    const float weight = skin.weights[static_cast<std::size_t>(k)];
    if (weight > 0.0F && (best < 0 || weight > skin.weights[static_cast<std::size_t>(best)])) best = k;
  }
  return best;
}

/// Sum of w M, in double; entry 0 without weights.
inline Affine blended_matrix(const std::vector<Affine>& palette, const RandomSkin& skin, int vertex) {
  if (heaviest(skin, vertex) < 0) return palette[0];
  Affine sum;
  sum.matrix().setZero();
  for (int k = vertex * skin.influences; k < (vertex + 1) * skin.influences; ++k) {
    const auto slot = static_cast<std::size_t>(k);
    sum.matrix() += static_cast<double>(skin.weights[slot]) * palette[skin.indices[slot]].matrix();
  }
  return sum;
}

/// The rigid motion of the blended dual quaternions, in double, as kavan2008 gives it.
inline Affine blended_motion(const std::vector<Affine>& palette, const RandomSkin& skin, int vertex) {
  const int pivot = heaviest(skin, vertex);
  if (pivot < 0) return palette[0];
  const auto real_of = [&](int k) { return Quat(palette[skin.indices[static_cast<std::size_t>(k)]].linear()); };
  Vec4 real = Vec4::Zero(), dual = Vec4::Zero();
  for (int k = vertex * skin.influences; k < (vertex + 1) * skin.influences; ++k) {
    const Quat q = real_of(k);
    const Vec3 t = palette[skin.indices[static_cast<std::size_t>(k)]].translation();
    const Quat e = Quat(0.0, t.x() / 2, t.y() / 2, t.z() / 2) * q;
    const double sign = q.coeffs().dot(real_of(pivot).coeffs()) < 0.0 ? -1.0 : 1.0;
    real += sign * static_cast<double>(skin.weights[static_cast<std::size_t>(k)]) * q.coeffs();
    dual += sign * static_cast<double>(skin.weights[static_cast<std::size_t>(k)]) * e.coeffs();
  }
  const double length = real.norm();
  const Quat r(Vec4(real / length)), d(Vec4(dual / length));
  return rigid(r, 2.0 * (d * r.conjugate()).vec());
}

}  // namespace croquis
