// SPDX-License-Identifier: MIT
#pragma once

#include "croquis/math/types.h"

namespace croquis {

/// Translation, rotation, scale, applied as T * R * S (glTF's order). Scale may be non-uniform and negative.
struct Transform {
  Vec3 translation = Vec3::Zero();
  Quat rotation = Quat::Identity();
  Vec3 scale = Vec3::Ones();

  [[nodiscard]] Affine to_affine() const;
  [[nodiscard]] bool is_finite() const;
  [[nodiscard]] friend bool operator==(const Transform&, const Transform&) = default;
};

/// The transform whose affine form is nearest to `affine`; a mirroring comes out as a negative x scale. Shear cannot be
/// held by a Transform: `shear` (if given) receives its size, the largest |cosine| between two columns.
[[nodiscard]] Transform decompose(const Affine& affine, double* shear = nullptr);

/// Component-wise linear, rotation by the shorter slerp; t = 0 gives a, t = 1 gives b.
[[nodiscard]] Transform interpolate(const Transform& a, const Transform& b, double t);

/// The rotation part of an affine map that may scale and mirror (columns orthonormalised, right-handed).
[[nodiscard]] Quat rotation_of(const Affine& affine);

}  // namespace croquis
