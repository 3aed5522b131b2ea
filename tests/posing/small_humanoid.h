// SPDX-License-Identifier: MIT
// A humanoid of fifteen joints in a T-pose, facing +Z; each joint's axes may be rolled at will, which must not matter.
#pragma once

#include "support/random_math.h"
#include <array>
#include <string>

#include "croquis/rig/humanoid.h"
#include "croquis/rig/pose.h"

namespace croquis {

struct SmallHumanoid {
  Skeleton skeleton;
  HumanoidMap map;
};

inline SmallHumanoid make_small_humanoid(Random* rolls = nullptr, double arm_drop = 0.0, double scale = 1.0) {
  struct Place {
    HumanoidBone bone;
    int parent;
    Vec3 position;
  };
  using B = HumanoidBone;
  const auto arm = [&](double side, double length) {
    return Vec3(side * (0.18 + length * std::cos(arm_drop)), 1.4 - length * std::sin(arm_drop), 0.0);
  };
  const std::array<Place, 15> places{{{B::hips, -1, {0, 1, 0}},
                                      {B::spine, 0, {0, 1.2, 0}},
                                      {B::head, 1, {0, 1.55, 0}},
                                      {B::leftUpperArm, 1, arm(1, 0)},
                                      {B::leftLowerArm, 3, arm(1, 0.3)},
                                      {B::leftHand, 4, arm(1, 0.55)},
                                      {B::rightUpperArm, 1, arm(-1, 0)},
                                      {B::rightLowerArm, 6, arm(-1, 0.3)},
                                      {B::rightHand, 7, arm(-1, 0.55)},
                                      {B::leftUpperLeg, 0, {0.1, 0.95, 0}},
                                      {B::leftLowerLeg, 9, {0.1, 0.5, 0}},
                                      {B::leftFoot, 10, {0.1, 0.08, 0}},
                                      {B::rightUpperLeg, 0, {-0.1, 0.95, 0}},
                                      {B::rightLowerLeg, 12, {-0.1, 0.5, 0}},
                                      {B::rightFoot, 13, {-0.1, 0.08, 0}}}};
  std::vector<Joint> joints;
  std::vector<Affine> model;
  HumanoidMap map;
  for (const Place& place : places) {
    Affine here = Affine::Identity();
    here.translation() = scale * place.position;
    if (rolls != nullptr) here.linear() = random_rotation(*rolls).toRotationMatrix();
    const Affine local =
        place.parent < 0 ? here : Affine(model[static_cast<std::size_t>(place.parent)].inverse() * here);
    map.set(place.bone, static_cast<int>(joints.size()), 1.0);
    joints.push_back({std::string(to_string(place.bone)), place.parent, decompose(local)});
    model.push_back(here);
  }
  return {Skeleton(std::move(joints)), map};
}

inline std::vector<int> mirror_of(const SmallHumanoid& body) {
  std::vector<int> map;
  for (int i = 0; i < body.skeleton.joint_count(); ++i) map.push_back(body.map.joint(mirror(*body.map.bone_of(i))));
  return map;
}

inline Pose random_pose(const Skeleton& skeleton, Random& random, double size) {
  Pose pose = rest_pose(skeleton);
  for (Transform& local : pose.local) {
    local.rotation = (local.rotation * Quat::Identity().slerp(size, random_rotation(random))).normalized();
  }
  return pose;
}

}  // namespace croquis
