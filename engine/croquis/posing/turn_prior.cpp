// SPDX-License-Identifier: MIT
// The spreads start from what people do in the clips of the lines-of-action benchmark (`loa_bench --spread` prints it,
// left and right together); those of neck, thigh, knee and elbow were then fitted to the benchmark with the solver's
// weights.
#include "croquis/posing/turn_prior.h"

#include "croquis/rig/joint_limits.h"

namespace croquis {
namespace {

Vec3 spread_of(std::optional<HumanoidBone> bone) {
  using enum HumanoidBone;
  if (!bone) return {0.04, 0.04, 0.04};  // twist bones and connectors
  switch (*bone) {
    case spine:
    case chest:
    case upperChest:
      return {0.09, 0.07, 0.09};
    case neck:
      return {0.16, 0.18, 0.24};
    case head:
      return {0.12, 0.09, 0.22};
    case leftShoulder:
    case rightShoulder:
      return {0.10, 0.08, 0.07};
    case leftUpperArm:
    case rightUpperArm:
      return {0.43, 0.29, 0.34};
    case leftLowerArm:
    case rightLowerArm:
      return {1.1, 0.19, 0.25};
    case leftHand:
    case rightHand:
      return {0.19, 0.19, 0.19};
    case leftUpperLeg:
    case rightUpperLeg:
      return {0.32, 0.14, 0.16};
    case leftLowerLeg:
    case rightLowerLeg:
      return {0.65, 0.09, 0.11};
    case leftFoot:
    case rightFoot:
      return {0.27, 0.14, 0.14};
    default:
      return {0.15, 0.05, 0.05};
  }
}

}  // namespace

std::vector<TurnPrior> make_turn_prior(const Skeleton& skeleton, const HumanoidMap& humanoid, const Pose& start) {
  std::vector<JointLimit> limits = make_joint_limits(skeleton, humanoid, LimitPreset::anatomical);
  if (limits.empty()) limits = make_joint_limits(skeleton, humanoid, LimitPreset::anatomical, start);
  std::vector<TurnPrior> priors;
  for (const JointLimit& limit : limits) {
    priors.push_back({limit.joint, limit.frame, spread_of(humanoid.bone_of(limit.joint))});
  }
  return priors;
}

}  // namespace croquis
