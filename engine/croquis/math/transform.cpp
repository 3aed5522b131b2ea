// SPDX-License-Identifier: MIT
#include "croquis/math/transform.h"

#include <algorithm>
#include <cmath>

namespace croquis {

Affine Transform::to_affine() const {
  Affine affine = Affine::Identity();
  affine.linear() = rotation.toRotationMatrix() * scale.asDiagonal();
  affine.translation() = translation;
  return affine;
}

bool Transform::is_finite() const {
  return translation.allFinite() && rotation.coeffs().allFinite() && scale.allFinite();
}

Transform decompose(const Affine& affine, double* shear) {
  Transform t;
  t.translation = affine.translation();
  Mat3 m = affine.linear();
  for (int c = 0; c < 3; ++c) t.scale[c] = m.col(c).norm();
  if (m.determinant() < 0.0) t.scale.x() = -t.scale.x();
  for (int c = 0; c < 3; ++c) {
    if (t.scale[c] != 0.0) m.col(c) /= t.scale[c];
  }
  if (shear != nullptr) {
    *shear = std::max(
        {std::abs(m.col(0).dot(m.col(1))), std::abs(m.col(1).dot(m.col(2))), std::abs(m.col(2).dot(m.col(0)))});
  }
  // A flattened axis leaves its direction open: any direction orthogonal to the others will do.
  for (int c = 0; c < 3; ++c) {
    if (t.scale[c] != 0.0) continue;
    const Vec3 other = m.col((c + 1) % 3), third = m.col((c + 2) % 3);
    const Vec3 normal = other.cross(third);
    m.col(c) = normal.norm() > 1e-12 ? Vec3(normal.normalized())
               : other.norm() > 0.0  ? Vec3(other.unitOrthogonal())
               : third.norm() > 0.0  ? Vec3(third.unitOrthogonal())
                                     : Vec3(Vec3::Unit(c));
  }
  // Gram-Schmidt, x before y before z, leaves orthogonal columns as they are to the last digit.
  const Vec3 x = m.col(0).normalized();
  Vec3 y = m.col(1) - x * x.dot(m.col(1));
  y = y.norm() > 1e-12 ? Vec3(y.normalized()) : Vec3(x.unitOrthogonal());
  m << x, y, x.cross(y);
  t.rotation = Quat(m).normalized();
  return t;
}

Transform interpolate(const Transform& a, const Transform& b, double t) {
  return {a.translation + t * (b.translation - a.translation), a.rotation.slerp(t, b.rotation),
          a.scale + t * (b.scale - a.scale)};
}

Quat rotation_of(const Affine& affine) { return decompose(affine).rotation; }

}  // namespace croquis
