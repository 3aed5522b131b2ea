// SPDX-License-Identifier: MIT
#include "croquis/rig/humanoid.h"

#include <string>

namespace croquis {
namespace {

constexpr std::array<std::string_view, kHumanoidBoneCount> kBoneNames = {
    // clang-format off
    "hips", "spine", "chest", "upperChest", "neck", "head", "leftEye", "rightEye", "jaw",
    "leftUpperLeg", "leftLowerLeg", "leftFoot", "leftToes", "rightUpperLeg", "rightLowerLeg", "rightFoot", "rightToes",
    "leftShoulder", "leftUpperArm", "leftLowerArm", "leftHand",
    "rightShoulder", "rightUpperArm", "rightLowerArm", "rightHand",
    "leftThumbMetacarpal", "leftThumbProximal", "leftThumbDistal",
    "leftIndexProximal", "leftIndexIntermediate", "leftIndexDistal",
    "leftMiddleProximal", "leftMiddleIntermediate", "leftMiddleDistal",
    "leftRingProximal", "leftRingIntermediate", "leftRingDistal",
    "leftLittleProximal", "leftLittleIntermediate", "leftLittleDistal",
    "rightThumbMetacarpal", "rightThumbProximal", "rightThumbDistal",
    "rightIndexProximal", "rightIndexIntermediate", "rightIndexDistal",
    "rightMiddleProximal", "rightMiddleIntermediate", "rightMiddleDistal",
    "rightRingProximal", "rightRingIntermediate", "rightRingDistal",
    "rightLittleProximal", "rightLittleIntermediate", "rightLittleDistal",
    // clang-format on
};

}  // namespace

std::string_view to_string(HumanoidBone bone) { return kBoneNames[static_cast<std::size_t>(bone)]; }

std::optional<HumanoidBone> parse_humanoid_bone(std::string_view vrm_name) {
  for (std::size_t i = 0; i < kBoneNames.size(); ++i) {
    if (kBoneNames[i] == vrm_name) return static_cast<HumanoidBone>(i);
  }
  return std::nullopt;
}

HumanoidBone mirror(HumanoidBone bone) {
  const std::string_view name = to_string(bone);
  if (name.starts_with("left")) return *parse_humanoid_bone("right" + std::string(name.substr(4)));
  if (name.starts_with("right")) return *parse_humanoid_bone("left" + std::string(name.substr(5)));
  return bone;
}

void HumanoidMap::set(HumanoidBone bone, int joint, double confidence) {
  entries[static_cast<std::size_t>(bone)] = {joint, confidence};
}

std::optional<HumanoidBone> HumanoidMap::bone_of(int joint) const {
  if (joint < 0) return std::nullopt;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (entries[i].joint == joint) return static_cast<HumanoidBone>(i);
  }
  return std::nullopt;
}

bool HumanoidMap::is_humanoid() const {
  using enum HumanoidBone;
  for (const HumanoidBone bone : {hips, leftUpperLeg, leftLowerLeg, rightUpperLeg, rightLowerLeg, leftUpperArm,
                                  leftLowerArm, rightUpperArm, rightLowerArm}) {
    if (!has(bone)) return false;
  }
  return has(head) || has(neck);
}

Vec3 compute_facing(const HumanoidMap& humanoid, std::span<const Vec3> positions) {
  using enum HumanoidBone;
  const auto to_left = [&](HumanoidBone left, HumanoidBone right) -> Vec3 {
    if (!humanoid.has(left) || !humanoid.has(right)) return Vec3::Zero();
    return positions[static_cast<std::size_t>(humanoid.joint(left))] -
           positions[static_cast<std::size_t>(humanoid.joint(right))];
  };
  // Facing is left x up. Hips and shoulders count alike, whatever their widths: a twisted body faces between the two.
  Vec3 facing = Vec3::Zero();
  for (const Vec3& left : {to_left(leftUpperLeg, rightUpperLeg), to_left(leftUpperArm, rightUpperArm)}) {
    const Vec3 side = left.cross(Vec3::UnitY());
    if (side.norm() > 1e-6 * left.norm()) facing += side.normalized();
  }
  if (facing.norm() < 1e-6) return Vec3::UnitZ();
  return facing.normalized();
}

}  // namespace croquis
