// SPDX-License-Identifier: MIT
#include "skinning_plain_loop.h"

namespace croquis {

void skin_plainly(const PlainMatrix* palette, const std::uint16_t* indices, const float* weights, int influences,
                  std::size_t vertices, const float* positions, const float* normals, float* posed_positions,
                  float* posed_normals) {
  skin_by_the_formula(palette, indices, weights, influences, vertices, positions, normals, posed_positions,
                      posed_normals);
}

}  // namespace croquis
