// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "croquis/rig/joint_limits.h"
#include "croquis/rig/pose.h"

namespace croquis {

/// Where a joint is wanted.
struct ReachGoal {
  int joint = 0;
  Vec3 position = Vec3::Zero();  ///< model space
  std::optional<Quat> rotation;  ///< model space; the joint itself turns to it
};

struct ReachOptions {
  int iterations = 60;
  double tolerance = 1e-5;  ///< distance to the goals that counts as there, in units of the skeleton's extent
};

struct ReachResult {
  Pose pose;
  std::string status = "ok";  ///< "ok", or which joint could not get where it was wanted
  double distance = 0.0;      ///< the largest distance left, model units
};

/// Inverse kinematics by damped least squares on the rotations of `moving` joints (any set; each turns what hangs on
/// it), with the joint limits kept at every step. Bone lengths hold by construction. A goal out of reach is approached
/// as far as it goes. Source: buss2004ik.
[[nodiscard]] ReachResult solve_reach(const Skeleton& skeleton, const Pose& start, std::span<const ReachGoal> goals,
                                      std::span<const int> moving, const std::vector<JointLimit>& limits,
                                      const ReachOptions& options = {});

/// The joints that follow when a hand, a foot, the head or any other joint is dragged: its limb, up to where the limb
/// leaves the trunk; elsewhere up to `most` joints above it.
[[nodiscard]] std::vector<int> limb_above(const Skeleton& skeleton, const HumanoidMap& humanoid, int joint,
                                          int most = 4);

}  // namespace croquis
