// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "croquis/rig/humanoid.h"
#include "croquis/rig/pose.h"

namespace croquis {

/// How far people turn one joint: the root mean square of its turns away from a neutral stance, in radians, about axes
/// of its own.
struct TurnPrior {
  int joint = -1;
  Quat frame = Quat::Identity();  ///< joint_from_axes: x the axis of flexion, y across, z along the bone (JointLimit)
  Vec3 spread = Vec3::Ones();
};

/// The turns that a humanoid's joints are used to, but for its root; of fingers, toes and joints between bones a guess.
/// The axes come from the geometry of the rest pose, or of `start` where the rest pose is no standing body, so that no
/// bone roll enters. Empty for what is no humanoid, and where neither pose stands.
[[nodiscard]] std::vector<TurnPrior> make_turn_prior(const Skeleton& skeleton, const HumanoidMap& humanoid,
                                                     const Pose& start);

}  // namespace croquis
