// SPDX-License-Identifier: MIT
#include "croquis/rig/joint_limits.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "croquis/math/rotation.h"

namespace croquis {
namespace {

constexpr std::array<std::string_view, 4> kPresetNames = {"anatomical", "dancer", "cartoon", "none"};

/// The half axes of the quarter ellipse that a swing lies in.
Vec2 radii_at(const JointLimit& limit, const Vec2& swing) {
  constexpr double kSmallest = 1e-9;
  const Vec2 radii(swing.x() < 0.0 ? -limit.swing_min.x() : limit.swing_max.x(),
                   swing.y() < 0.0 ? -limit.swing_min.y() : limit.swing_max.y());
  return radii.cwiseMax(kSmallest);
}

/// The point of the swing's region nearest to `swing`: for a point outside an ellipse with half axes a, b it is
/// (a^2 x / (t + a^2), b^2 y / (t + b^2)), where t > 0 puts it on the ellipse. The equation for t is convex and falls,
/// so Newton's method from t = 0 climbs to its root without passing it.
Vec2 nearest_swing(const JointLimit& limit, const Vec2& swing) {
  const Vec2 radii = radii_at(limit, swing);
  if (swing.cwiseQuotient(radii).squaredNorm() <= 1.0) return swing;
  const Vec2 squares = radii.cwiseAbs2();
  double t = 0.0;
  for (int step = 0; step < 60; ++step) {
    const Vec2 ratio = radii.cwiseProduct(swing).cwiseQuotient(squares + Vec2::Constant(t));
    const double value = ratio.squaredNorm() - 1.0;
    if (value < 1e-14) break;
    const double slope = -2.0 * ratio.cwiseAbs2().cwiseQuotient(squares + Vec2::Constant(t)).sum();
    t -= value / slope;
  }
  return squares.cwiseProduct(swing).cwiseQuotient(squares + Vec2::Constant(t));
}

/// Of the two rotation vectors of one swing the one nearer to the region. The other way round only matters beyond a
/// half turn: so a swing that passes the far pole stays next to the part of the region that it came from.
Vec2 unwrap_swing(const JointLimit& limit, const Vec2& swing) {
  const double angle = swing.norm();
  if (angle < 0.5 * kPi) return swing;
  const Vec2 other = swing * ((angle - 2.0 * kPi) / angle);
  const double here = (swing - nearest_swing(limit, swing)).norm();
  return here <= (other - nearest_swing(limit, other)).norm() ? swing : other;
}

double unwrap_twist(const JointLimit& limit, double twist) {
  const double middle = 0.5 * (limit.twist_min + limit.twist_max);
  return twist - 2.0 * kPi * std::round((twist - middle) / (2.0 * kPi));
}

Quat from_limit_coordinates(const JointLimit& limit, const Vec3& at) {
  const Quat swing = rotation_from_vector(Vec3(at.x(), at.y(), 0.0));
  const Quat twist = rotation_from_vector(Vec3(0.0, 0.0, at.z()));
  return (limit.neutral * limit.frame * swing * twist * limit.frame.conjugate()).normalized();
}

Vec3 nearest_coordinates(const JointLimit& limit, const Vec3& at) {
  const Vec2 swing = nearest_swing(limit, at.head<2>());
  return {swing.x(), swing.y(), std::clamp(at.z(), limit.twist_min, limit.twist_max)};
}

}  // namespace

std::string_view to_string(LimitPreset preset) { return kPresetNames[static_cast<std::size_t>(preset)]; }

std::optional<LimitPreset> parse_limit_preset(std::string_view name) {
  for (std::size_t i = 0; i < kPresetNames.size(); ++i) {
    if (kPresetNames[i] == name) return static_cast<LimitPreset>(i);
  }
  return std::nullopt;
}

Vec3 limit_coordinates(const JointLimit& limit, const Quat& local_rotation) {
  const Quat turn = limit.frame.conjugate() * limit.neutral.conjugate() * local_rotation * limit.frame;
  const SwingTwist parts = split_swing_twist(turn, Vec3::UnitZ());
  const Vec2 swing = unwrap_swing(limit, rotation_to_vector(parts.swing).head<2>());
  return {swing.x(), swing.y(), unwrap_twist(limit, twist_angle(turn, Vec3::UnitZ()))};
}

double limit_violation(const JointLimit& limit, const Quat& local_rotation) {
  const Vec3 at = limit_coordinates(limit, local_rotation);
  return (at - nearest_coordinates(limit, at)).norm();
}

Quat clamp_to_limit(const JointLimit& limit, const Quat& local_rotation) {
  const Vec3 at = limit_coordinates(limit, local_rotation);
  Vec3 inside = nearest_coordinates(limit, at);
  if (inside == at) return local_rotation;
  // A hair inside the border, so that rounding does not put the result out again.
  constexpr double kInward = 1.0 - 1e-10;
  inside.head<2>() *= kInward;
  const double middle = 0.5 * (limit.twist_min + limit.twist_max);
  inside.z() = middle + kInward * (inside.z() - middle);
  return from_limit_coordinates(limit, inside);
}

std::vector<int> find_limit_violations(const std::vector<JointLimit>& limits, const Pose& pose, double tolerance) {
  std::vector<int> found;
  for (const JointLimit& limit : limits) {
    const Quat& local = pose.local[static_cast<std::size_t>(limit.joint)].rotation;
    if (limit_violation(limit, local) > tolerance) found.push_back(limit.joint);
  }
  return found;
}

}  // namespace croquis
