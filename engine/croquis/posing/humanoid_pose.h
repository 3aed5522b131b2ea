// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "croquis/rig/humanoid.h"
#include "croquis/rig/pose.h"

namespace croquis {

/// A pose that any humanoid can take: for each bone its turn away from the T-pose, relative to the bone above, in the
/// axes of a body that faces +Z with Y up (VRM's normalised space). Bones without an entry stay as they are.
struct HumanoidPose {
  std::array<std::optional<Quat>, kHumanoidBoneCount> turns;
  /// How far the hips are from where they are at rest, in units of their height over the soles, body axes.
  std::optional<Vec3> hips_offset;
};

/// The skeleton's own T-pose: arms along the shoulder line, legs straight down, everything else at rest. Rigs that rest
/// in an A-pose come out with their arms raised.
[[nodiscard]] Pose make_t_pose(const Skeleton& skeleton, const HumanoidMap& humanoid, const Vec3& front);

/// The pose of one body in terms that another understands. Source: vrm1, normalised pose.
[[nodiscard]] HumanoidPose extract_humanoid_pose(const Skeleton& skeleton, const HumanoidMap& humanoid,
                                                 const Vec3& front, const Pose& pose);

/// `base` with the bones that `goal` names in its pose; a bone that this body lacks hands its turn to those below it.
[[nodiscard]] Pose apply_humanoid_pose(const Skeleton& skeleton, const HumanoidMap& humanoid, const Vec3& front,
                                       const HumanoidPose& goal, const Pose& base);

}  // namespace croquis
