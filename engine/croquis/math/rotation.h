// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "croquis/math/types.h"

namespace croquis {

/// The shortest rotation that turns direction `from` into direction `to` (any lengths). Opposite directions turn about
/// a fixed axis orthogonal to `from`; a zero vector gives the identity.
[[nodiscard]] Quat rotation_between(const Vec3& from, const Vec3& to);

/// The rotation by |v| radians about v (the exponential map), smooth at zero; and its inverse, |log| <= pi.
[[nodiscard]] Quat rotation_from_vector(const Vec3& v);
[[nodiscard]] Vec3 rotation_to_vector(const Quat& q);

/// The angle of q in radians, in [0, pi].
[[nodiscard]] double rotation_angle(const Quat& q);

/// q = swing * twist: twist turns about `axis` (unit, in the frame before q), swing about an axis orthogonal to it.
struct SwingTwist {
  Quat swing;
  Quat twist;
};
[[nodiscard]] SwingTwist split_swing_twist(const Quat& q, const Vec3& axis);

/// The signed angle of q about `axis` (unit) in radians, in [-pi, pi].
[[nodiscard]] double twist_angle(const Quat& q, const Vec3& axis);

/// Euler angles in file order: q = R_order[0](a[0]) * R_order[1](a[1]) * R_order[2](a[2]), axes 0, 1, 2 = X, Y, Z, all
/// three different, angles in radians. `to_euler` picks the middle angle in [-pi/2, pi/2]; at gimbal lock the third
/// angle is 0. The rotation comes back to rounding error, near the lock too.
[[nodiscard]] Quat from_euler(const std::array<int, 3>& order, const Vec3& angles);
[[nodiscard]] Vec3 to_euler(const std::array<int, 3>& order, const Quat& q);

}  // namespace croquis
