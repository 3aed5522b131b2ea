// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace croquis {

/// 3x4, row by row.
struct PlainMatrix {
  float rows[3][4];
};

/// What skinning looks like when it is written down as the formula says it: a loop over vertices and influences. It
/// leaves the normals with the length that comes out.
[[gnu::always_inline]] inline void skin_by_the_formula(const PlainMatrix* palette, const std::uint16_t* indices,
                                                       const float* weights, int influences, std::size_t vertices,
                                                       const float* positions, const float* normals,
                                                       float* posed_positions, float* posed_normals) {
  const auto per_vertex = static_cast<std::size_t>(influences);
  for (std::size_t v = 0; v < vertices; ++v) {
    const float* p = positions + 3 * v;
    const float* n = normals + 3 * v;
    float position[3] = {0.0F, 0.0F, 0.0F}, normal[3] = {0.0F, 0.0F, 0.0F};
    for (std::size_t k = 0; k < per_vertex; ++k) {
      const float weight = weights[v * per_vertex + k];
      const PlainMatrix& m = palette[indices[v * per_vertex + k]];
      for (int r = 0; r < 3; ++r) {
        position[r] += weight * (m.rows[r][0] * p[0] + m.rows[r][1] * p[1] + m.rows[r][2] * p[2] + m.rows[r][3]);
        normal[r] += weight * (m.rows[r][0] * n[0] + m.rows[r][1] * n[1] + m.rows[r][2] * n[2]);
      }
    }
    for (int r = 0; r < 3; ++r) {
      posed_positions[3 * v + r] = position[r];
      posed_normals[3 * v + r] = normal[r];
    }
  }
}

/// That loop, compiled with the flags of the fastest kernels; and with leave to fuse multiplications and additions
/// besides (the kernels do so by hand, the project's flags do not allow it to the compiler).
void skin_plainly(const PlainMatrix* palette, const std::uint16_t* indices, const float* weights, int influences,
                  std::size_t vertices, const float* positions, const float* normals, float* posed_positions,
                  float* posed_normals);
void skin_plainly_fused(const PlainMatrix* palette, const std::uint16_t* indices, const float* weights, int influences,
                        std::size_t vertices, const float* positions, const float* normals, float* posed_positions,
                        float* posed_normals);

}  // namespace croquis
