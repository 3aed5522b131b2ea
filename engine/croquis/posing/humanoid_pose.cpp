// SPDX-License-Identifier: MIT
#include "croquis/posing/humanoid_pose.h"

#include <algorithm>
#include <cmath>

#include "croquis/base/error.h"
#include "croquis/base/index.h"
#include "croquis/math/rotation.h"
#include "croquis/posing/pose_edit.h"

namespace croquis {
namespace {

using Bone = HumanoidBone;

std::size_t at(Bone bone) { return croquis::at(static_cast<int>(bone)); }
using croquis::at;

/// The bone that a bone hangs on in the full humanoid.
std::optional<Bone> bone_above(Bone bone) {
  switch (bone) {
    case Bone::hips:
      return std::nullopt;
    case Bone::spine:
    case Bone::leftUpperLeg:
    case Bone::rightUpperLeg:
      return Bone::hips;
    case Bone::leftEye:
    case Bone::rightEye:
    case Bone::jaw:
      return Bone::head;
    case Bone::neck:
    case Bone::leftShoulder:
    case Bone::rightShoulder:
      return Bone::upperChest;
    default:
      break;
  }
  const auto index = static_cast<int>(bone);
  const auto first_left = static_cast<int>(Bone::leftThumbMetacarpal),
             first_right = static_cast<int>(Bone::rightThumbMetacarpal);
  const int finger = index >= first_right ? index - first_right : index - first_left;
  if (index >= first_left && finger % 3 == 0) return index >= first_right ? Bone::rightHand : Bone::leftHand;
  return static_cast<Bone>(index - 1);
}

/// From the axes of a body that faces +Z to the model's.
Quat model_from_body(const Vec3& front) {
  return Quat(Eigen::AngleAxisd(std::atan2(front.x(), front.z()), Vec3::UnitY()));
}

/// Turns `joint` so that the bone to `tip` points along `direction`.
void aim(const Skeleton& skeleton, Pose& pose, int joint, int tip, const Vec3& direction) {
  const std::vector<Vec3> positions = compute_positions(skeleton, pose);
  const Vec3 now = positions[at(tip)] - positions[at(joint)];
  if (now.norm() < 1e-9 * skeleton.extent()) return;
  pose = turn_joint(skeleton, pose, joint, rotation_between(now, direction));
}

/// Turns of all bones away from the T-pose in model space, in the body's axes; missing bones take the turn above them.
std::array<Quat, kHumanoidBoneCount> model_turns(const Skeleton& skeleton, const HumanoidMap& humanoid,
                                                 const Vec3& front, const Pose& pose) {
  const std::vector<Quat> t_model = compute_model_rotations(skeleton, make_t_pose(skeleton, humanoid, front));
  const std::vector<Quat> model = compute_model_rotations(skeleton, pose);
  const Quat body = model_from_body(front);
  std::array<Quat, kHumanoidBoneCount> turns;
  for (int i = 0; i < kHumanoidBoneCount; ++i) {
    const auto bone = static_cast<Bone>(i);
    const int joint = humanoid.joint(bone);
    const std::optional<Bone> above = bone_above(bone);
    turns[at(i)] = joint >= 0 ? Quat(body.conjugate() * model[at(joint)] * t_model[at(joint)].conjugate() * body)
                   : above    ? turns[at(*above)]
                              : Quat::Identity();
  }
  return turns;
}

/// Height of the hips over the lowest joint at rest; positive.
double hips_height(const Skeleton& skeleton, const HumanoidMap& humanoid) {
  const double hips = skeleton.rest_position(humanoid.joint(Bone::hips)).y();
  double lowest = hips;
  for (const Bone foot : {Bone::leftFoot, Bone::rightFoot, Bone::leftToes, Bone::rightToes}) {
    if (humanoid.has(foot)) lowest = std::min(lowest, skeleton.rest_position(humanoid.joint(foot)).y());
  }
  return std::max(hips - lowest, 1e-6 * skeleton.extent());
}

void want_humanoid(const HumanoidMap& humanoid, const char* function) {
  if (!humanoid.has(Bone::hips)) throw_invalid_argument(std::string(function) + ": this character is no humanoid");
}

}  // namespace

Pose make_t_pose(const Skeleton& skeleton, const HumanoidMap& humanoid, const Vec3& front) {
  Pose pose = rest_pose(skeleton);
  const Vec3 left = Vec3::UnitY().cross(front).normalized();
  const std::array<std::array<Bone, 3>, 4> limbs{{{Bone::leftUpperArm, Bone::leftLowerArm, Bone::leftHand},
                                                  {Bone::rightUpperArm, Bone::rightLowerArm, Bone::rightHand},
                                                  {Bone::leftUpperLeg, Bone::leftLowerLeg, Bone::leftFoot},
                                                  {Bone::rightUpperLeg, Bone::rightLowerLeg, Bone::rightFoot}}};
  const std::array<Vec3, 4> directions{left, -left, -Vec3::UnitY(), -Vec3::UnitY()};
  const std::vector<Quat> rest_model = compute_model_rotations(skeleton, pose);
  for (std::size_t i = 0; i < limbs.size(); ++i) {
    const int upper = humanoid.joint(limbs[i][0]), lower = humanoid.joint(limbs[i][1]),
              end = humanoid.joint(limbs[i][2]);
    if (upper < 0 || lower < 0 || end < 0) continue;
    aim(skeleton, pose, upper, lower, directions[i]);
    aim(skeleton, pose, lower, end, directions[i]);
    if (i < 2) {
      // The hand goes on straight where the forearm ends.
      const int finger = humanoid.joint(i == 0 ? Bone::leftMiddleProximal : Bone::rightMiddleProximal);
      if (finger >= 0) aim(skeleton, pose, end, finger, directions[i]);
    } else {
      // The foot stands as it stood at rest, however the leg was turned.
      const std::vector<Quat> model = compute_model_rotations(skeleton, pose);
      pose = turn_joint(skeleton, pose, end, rest_model[at(end)] * model[at(end)].conjugate());
    }
  }
  return pose;
}

HumanoidPose extract_humanoid_pose(const Skeleton& skeleton, const HumanoidMap& humanoid, const Vec3& front,
                                   const Pose& pose) {
  want_humanoid(humanoid, "extract_humanoid_pose");
  const auto turns = model_turns(skeleton, humanoid, front, pose);
  HumanoidPose result;
  for (int i = 0; i < kHumanoidBoneCount; ++i) {
    const auto bone = static_cast<Bone>(i);
    if (!humanoid.has(bone)) continue;
    const std::optional<Bone> above = bone_above(bone);
    result.turns[at(i)] = above ? Quat(turns[at(*above)].conjugate() * turns[at(i)]).normalized() : turns[at(i)];
  }
  const int hips = humanoid.joint(Bone::hips);
  const Vec3 moved = compute_positions(skeleton, pose)[at(hips)] - skeleton.rest_position(hips);
  result.hips_offset = model_from_body(front).conjugate() * moved / hips_height(skeleton, humanoid);
  return result;
}

Pose apply_humanoid_pose(const Skeleton& skeleton, const HumanoidMap& humanoid, const Vec3& front,
                         const HumanoidPose& goal, const Pose& base) {
  want_humanoid(humanoid, "apply_humanoid_pose");
  if (std::ssize(base.local) != skeleton.joint_count()) {
    throw_invalid_argument("apply_humanoid_pose: the base pose does not fit the skeleton");
  }
  const std::vector<Quat> t_model = compute_model_rotations(skeleton, make_t_pose(skeleton, humanoid, front));
  const auto base_turns = model_turns(skeleton, humanoid, front, base);
  const Quat body = model_from_body(front);
  std::array<Quat, kHumanoidBoneCount> turns;
  Pose pose = base;
  for (int i = 0; i < kHumanoidBoneCount; ++i) {
    const auto bone = static_cast<Bone>(i);
    const std::optional<Bone> above = bone_above(bone);
    const Quat parent_turn = above ? turns[at(*above)] : Quat::Identity();
    const Quat kept = above ? Quat(base_turns[at(*above)].conjugate() * base_turns[at(i)]) : base_turns[at(i)];
    turns[at(i)] = (parent_turn * goal.turns[at(i)].value_or(kept)).normalized();
    const int joint = humanoid.joint(bone);
    if (joint < 0 || !goal.turns[at(i)]) continue;
    const Quat wanted = body * turns[at(i)] * body.conjugate() * t_model[at(joint)];
    const int parent = skeleton.parent(joint);
    const Quat parent_model = parent < 0 ? Quat::Identity() : compute_model_rotations(skeleton, pose)[at(parent)];
    pose.local[at(joint)].rotation = (parent_model.conjugate() * wanted).normalized();
  }
  if (goal.hips_offset) {
    const int hips = humanoid.joint(Bone::hips);
    const Vec3 place = skeleton.rest_position(hips) + body * *goal.hips_offset * hips_height(skeleton, humanoid);
    pose = place_joint(skeleton, pose, hips, place);
  }
  return pose;
}

}  // namespace croquis
