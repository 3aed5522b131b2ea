// SPDX-License-Identifier: MIT
#include "croquis/math/rotation.h"

#include <algorithm>
#include <cmath>

namespace croquis {

Quat rotation_between(const Vec3& from, const Vec3& to) {
  const double scale = from.norm() * to.norm();
  if (!(scale > 0.0)) return Quat::Identity();
  const double cosine = from.dot(to) / scale;
  if (cosine < -1.0 + 1e-12) {
    const Vec3 axis = from.unitOrthogonal();
    return {0.0, axis.x(), axis.y(), axis.z()};
  }
  const Vec3 cross = from.cross(to) / scale;
  return Quat(1.0 + cosine, cross.x(), cross.y(), cross.z()).normalized();
}

Quat rotation_from_vector(const Vec3& v) {
  const double angle = v.norm();
  // sin(x/2)/x, by its series where the quotient loses digits.
  const double s = angle < 1e-4 ? 0.5 - angle * angle / 48.0 : std::sin(0.5 * angle) / angle;
  return Quat(std::cos(0.5 * angle), s * v.x(), s * v.y(), s * v.z()).normalized();
}

Vec3 rotation_to_vector(const Quat& q) {
  const double sign = q.w() < 0.0 ? -1.0 : 1.0;
  const double sine = q.vec().norm();
  if (sine < 1e-12) return 2.0 * sign * q.vec();
  return (2.0 * sign * std::atan2(sine, sign * q.w()) / sine) * q.vec();
}

double rotation_angle(const Quat& q) { return 2.0 * std::atan2(q.vec().norm(), std::abs(q.w())); }

SwingTwist split_swing_twist(const Quat& q, const Vec3& axis) {
  const double along = q.vec().dot(axis);
  const double length = std::hypot(q.w(), along);
  // A half turn orthogonal to the axis has no twist to speak of.
  Quat twist = Quat::Identity();
  if (length > 1e-12) {
    const Vec3 v = (along / length) * axis;
    twist = Quat(q.w() / length, v.x(), v.y(), v.z());
  }
  return {q * twist.conjugate(), twist};
}

double twist_angle(const Quat& q, const Vec3& axis) {
  const double along = q.vec().dot(axis);
  return q.w() < 0.0 ? 2.0 * std::atan2(-along, -q.w()) : 2.0 * std::atan2(along, q.w());
}

Quat from_euler(const std::array<int, 3>& order, const Vec3& angles) {
  Quat q = Quat::Identity();
  for (int i = 0; i < 3; ++i)
    q = q * Quat(Eigen::AngleAxisd(angles[i], Vec3::Unit(order[static_cast<std::size_t>(i)])));
  return q;
}

Vec3 to_euler(const std::array<int, 3>& order, const Quat& q) {
  const int i = order[0], j = order[1], k = order[2];
  const double parity = (j - i + 3) % 3 == 1 ? 1.0 : -1.0;
  const Mat3 m = q.normalized().toRotationMatrix();
  const double level = std::hypot(m(j, k), m(k, k));  // cosine of the middle angle
  const double middle = std::atan2(parity * m(i, k), level);
  const double first = level < 1e-12 ? parity * std::atan2(m(k, j), m(j, j)) : std::atan2(-parity * m(j, k), m(k, k));
  // Near the lock `first` is noise; the third angle is read from what `first` leaves, so that their noises cancel.
  const Mat3 rest = Eigen::AngleAxisd(-first, Vec3::Unit(i)).toRotationMatrix() * m;
  return {first, middle, std::atan2(parity * rest(j, i), rest(j, j))};
}

}  // namespace croquis
