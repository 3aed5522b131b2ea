// SPDX-License-Identifier: MIT
// Seeded random vectors and rotations for property tests.
#pragma once

#include "croquis/base/random.h"
#include "croquis/math/transform.h"

namespace croquis {

inline Vec3 random_vector(Random& random) {
  const double x = random.normal(), y = random.normal(), z = random.normal();
  return {x, y, z};
}

inline Quat random_rotation(Random& random) {
  const double w = random.normal(), x = random.normal(), y = random.normal(), z = random.normal();
  return Quat(w, x, y, z).normalized();
}

}  // namespace croquis
