// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "croquis/rig/humanoid.h"
#include "croquis/rig/pose.h"

namespace croquis {

enum class LimitPreset { anatomical, dancer, cartoon, none };
[[nodiscard]] std::optional<LimitPreset> parse_limit_preset(std::string_view name);
[[nodiscard]] std::string_view to_string(LimitPreset preset);

/// How far one joint may turn away from its neutral rotation. In the joint's limit frame z runs along the bone and x is
/// the axis of flexion; the turn from neutral is split as swing * twist about z. Swing: the rotation vector (about x
/// and y, radians) stays inside [swing_min, swing_max], whose four quarters are quarter-ellipses (a cone with four
/// different angles); swing_min <= 0 <= swing_max, all below pi. Twist: the angle about z stays in [twist_min,
/// twist_max]. A hinge has next to no room in y.
struct JointLimit {
  int joint = -1;
  Quat neutral = Quat::Identity();  ///< parent_from_joint in which nothing is turned
  Quat frame = Quat::Identity();    ///< joint_from_limit_frame
  Vec2 swing_min = Vec2::Zero(), swing_max = Vec2::Zero();
  double twist_min = 0.0, twist_max = 0.0;
  bool hinge = false;
};

/// The turn of a joint in the coordinates that its limit is written in: (swing x, swing y, twist), radians. Of the
/// coordinates that mean the same turn (a swing has two, a twist any number) the nearest to the limit: they are smooth
/// in the rotation inside the limit and around it, and jump only far outside.
[[nodiscard]] Vec3 limit_coordinates(const JointLimit& limit, const Quat& local_rotation);
/// How far outside its limit a joint's local rotation is: the distance of its coordinates from the allowed ones, in
/// radians; 0 inside.
[[nodiscard]] double limit_violation(const JointLimit& limit, const Quat& local_rotation);
/// The local rotation with the nearest allowed coordinates; what is inside comes back as it is.
[[nodiscard]] Quat clamp_to_limit(const JointLimit& limit, const Quat& local_rotation);

/// The limits of a humanoid's joints after a preset (range-of-motion table: docs/conventions.md), from the rest pose's
/// geometry: no bone roll, no axis convention of the file enters. Neutral is the anatomical position, whether the rest
/// is a T- or an A-pose: arms and legs hang straight, elbows, knees and fingers are straight; trunk, neck, clavicles,
/// hands and feet are neutral as they rest. Ordered by joint. Empty for `none`, for what is no humanoid, and where the
/// rest pose is no standing body (zeroed motion capture).
[[nodiscard]] std::vector<JointLimit> make_joint_limits(const Skeleton& skeleton, const HumanoidMap& humanoid,
                                                        LimitPreset preset);
/// The same from a pose in which the body stands, for skeletons whose rest pose means nothing. Throws invalid_argument
/// if the pose has not one transform per joint.
[[nodiscard]] std::vector<JointLimit> make_joint_limits(const Skeleton& skeleton, const HumanoidMap& humanoid,
                                                        LimitPreset preset, const Pose& stance);

/// The joints whose limit a pose exceeds by more than `tolerance` radians.
[[nodiscard]] std::vector<int> find_limit_violations(const std::vector<JointLimit>& limits, const Pose& pose,
                                                     double tolerance = 1e-6);

}  // namespace croquis
