// SPDX-License-Identifier: MIT
#include "croquis/posing/joint_roles.h"

#include <algorithm>

namespace croquis {

int find_body_root(const Skeleton& skeleton, const HumanoidMap& humanoid) {
  if (humanoid.has(HumanoidBone::hips)) return humanoid.joint(HumanoidBone::hips);
  int joint = 0;
  const auto only_child = [&](int i) { return skeleton.children(i).size() == 1 ? skeleton.children(i).front() : -1; };
  while (skeleton.joint(joint).helper && only_child(joint) >= 0) joint = only_child(joint);
  // Joints of an exporter's own, in one place with what they carry.
  const auto carries_in_place = [&](int i) {
    const int child = only_child(i);
    return child >= 0 && !skeleton.children(child).empty() &&
           (skeleton.rest_position(child) - skeleton.rest_position(i)).norm() < 1e-6 * skeleton.extent();
  };
  while (carries_in_place(joint)) joint = only_child(joint);
  // A ground joint above the body: one child that branches.
  const std::vector<int>& below = skeleton.children(joint);
  if (below.size() == 1 && skeleton.children(below.front()).size() > 1) joint = below.front();
  return joint;
}

std::vector<JointRole> compute_joint_roles(const Skeleton& skeleton, const HumanoidMap& humanoid) {
  using enum HumanoidBone;
  std::vector<JointRole> roles(skeleton.joints().size(), JointRole::plain);
  const int root = find_body_root(skeleton, humanoid);
  for (int i = 0; i < skeleton.joint_count(); ++i) {
    const auto& children = skeleton.children(i);
    const auto branches =
        std::count_if(children.begin(), children.end(), [&](int child) { return !skeleton.children(child).empty(); });
    if (branches > 1) roles[static_cast<std::size_t>(i)] = JointRole::ball;
  }
  if (humanoid.is_humanoid()) {
    std::fill(roles.begin(), roles.end(), JointRole::end);
    const auto give = [&](HumanoidBone bone, JointRole role) {
      if (humanoid.has(bone)) roles[static_cast<std::size_t>(humanoid.joint(bone))] = role;
    };
    // Joints between hips and head that have no name of their own belong to the spine too.
    const int top = humanoid.has(head) ? humanoid.joint(head) : humanoid.joint(neck);
    for (int joint = top; joint >= 0 && joint != root; joint = skeleton.parent(joint)) {
      roles[static_cast<std::size_t>(joint)] = JointRole::spine;
    }
    for (const HumanoidBone bone : {leftShoulder, rightShoulder}) give(bone, JointRole::collar);
    for (const HumanoidBone bone : {leftUpperLeg, rightUpperLeg, leftUpperArm, rightUpperArm}) {
      give(bone, JointRole::ball);
    }
    for (const HumanoidBone bone : {leftLowerLeg, rightLowerLeg, leftLowerArm, rightLowerArm}) {
      give(bone, JointRole::hinge);
    }
  }
  roles[static_cast<std::size_t>(root)] = JointRole::root;
  return roles;
}

}  // namespace croquis
