// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "croquis/rig/humanoid.h"
#include "croquis/rig/pose.h"

namespace croquis {

/// Which half of the body gives the pose to the other.
enum class MirrorSide {
  both,   ///< the two sides change places
  left,   ///< the right side takes the left side's pose; left side and middle stay
  right,  ///< the left side takes the right side's
};

/// The pose mirrored in the body's own sagittal plane: upright, through the hips (or the topmost bone) where they are,
/// at the heading that they have. Works on model-space turns away from rest, so that neither bone roll nor a file's
/// axes enter; `mirror_map` as from compute_mirror_map, `front` the direction faced at rest. Mirroring twice gives the
/// pose back. The rest pose should be symmetric; where it is not, its asymmetry stays.
[[nodiscard]] Pose mirror_pose(const Skeleton& skeleton, const HumanoidMap& humanoid,
                               const std::vector<int>& mirror_map, const Vec3& front, const Pose& pose,
                               MirrorSide side = MirrorSide::both);

/// `pose` moved toward `goal` by `amount` (0 keeps, 1 is the goal), rotations by the shorter slerp; only the joints
/// given, or all where `joints` is empty.
[[nodiscard]] Pose blend_pose(const Pose& pose, const Pose& goal, double amount, std::span<const int> joints = {});

/// `pose` with one joint, and all that hangs on it, turned by `turn_model` about the joint's place.
[[nodiscard]] Pose turn_joint(const Skeleton& skeleton, const Pose& pose, int joint, const Quat& turn_model);

/// `pose` with one joint, and all that hangs on it, moved to `position` (model space).
[[nodiscard]] Pose place_joint(const Skeleton& skeleton, const Pose& pose, int joint, const Vec3& position);

/// The joint that carries the body, whose heading is the body's: the hips, else the topmost bone.
[[nodiscard]] int carrying_joint(const Skeleton& skeleton, const HumanoidMap& humanoid);

/// Model-space rotations: the product of the local rotations from the root to each joint (scales left out).
[[nodiscard]] std::vector<Quat> compute_model_rotations(const Skeleton& skeleton, const Pose& pose);

}  // namespace croquis
