// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "croquis/math/types.h"

namespace croquis {

/// How a mesh hangs on joints. The palette has one entry per element of `joints`; vertex v is held by palette entries
/// joint_indices[v * influences + k] with weights[v * influences + k], k in [0, influences). Weights are not negative
/// and sum to 1 (or are all 0: the vertex then follows palette entry 0); unused slots are index 0, weight 0.
struct Skin {
  std::vector<int> joints;                   ///< palette entry -> joint of the skeleton
  std::vector<Affine> inverse_bind;          ///< palette entry -> joint_from_mesh when the mesh was bound
  int influences = 4;                        ///< slots per vertex, >= 1
  std::vector<std::uint16_t> joint_indices;  ///< [vertex_count * influences], palette entries
  std::vector<float> weights;                ///< [vertex_count * influences]

  [[nodiscard]] int vertex_count() const { return influences > 0 ? static_cast<int>(weights.size()) / influences : 0; }
  /// Throws invalid_argument unless sizes agree, indices are in range and weights are finite and not negative.
  void check(int vertex_count, int joint_count) const;
};

/// Makes each vertex's weights sum to 1, the largest first, and clears slots of weight 0.
void normalise_weights(Skin& skin);

}  // namespace croquis
