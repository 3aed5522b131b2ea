// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "croquis/rig/skeleton.h"

namespace croquis {

/// The bones of the VRM 1.0 humanoid, in its spelling.
enum class HumanoidBone {
  // clang-format off
  hips, spine, chest, upperChest, neck, head, leftEye, rightEye, jaw,
  leftUpperLeg, leftLowerLeg, leftFoot, leftToes, rightUpperLeg, rightLowerLeg, rightFoot, rightToes,
  leftShoulder, leftUpperArm, leftLowerArm, leftHand, rightShoulder, rightUpperArm, rightLowerArm, rightHand,
  leftThumbMetacarpal, leftThumbProximal, leftThumbDistal,
  leftIndexProximal, leftIndexIntermediate, leftIndexDistal,
  leftMiddleProximal, leftMiddleIntermediate, leftMiddleDistal,
  leftRingProximal, leftRingIntermediate, leftRingDistal,
  leftLittleProximal, leftLittleIntermediate, leftLittleDistal,
  rightThumbMetacarpal, rightThumbProximal, rightThumbDistal,
  rightIndexProximal, rightIndexIntermediate, rightIndexDistal,
  rightMiddleProximal, rightMiddleIntermediate, rightMiddleDistal,
  rightRingProximal, rightRingIntermediate, rightRingDistal,
  rightLittleProximal, rightLittleIntermediate, rightLittleDistal,
  // clang-format on
};
inline constexpr int kHumanoidBoneCount = static_cast<int>(HumanoidBone::rightLittleDistal) + 1;

[[nodiscard]] std::string_view to_string(HumanoidBone bone);
[[nodiscard]] std::optional<HumanoidBone> parse_humanoid_bone(std::string_view vrm_name);
/// The bone of the other side; bones of the middle are their own mirror.
[[nodiscard]] HumanoidBone mirror(HumanoidBone bone);

/// Which joint of a skeleton plays which humanoid bone.
struct HumanoidMap {
  struct Entry {
    int joint = -1;           ///< -1: this skeleton has no such bone
    double confidence = 0.0;  ///< 0..1; 1 where the file itself says so
  };
  std::array<Entry, kHumanoidBoneCount> entries;

  [[nodiscard]] int joint(HumanoidBone bone) const { return entries[static_cast<std::size_t>(bone)].joint; }
  [[nodiscard]] bool has(HumanoidBone bone) const { return joint(bone) >= 0; }
  void set(HumanoidBone bone, int joint, double confidence);
  /// The bone that a joint plays, if any.
  [[nodiscard]] std::optional<HumanoidBone> bone_of(int joint) const;
  /// Hips, a head or neck, both arms and both legs are there; hands and feet may be missing.
  [[nodiscard]] bool is_humanoid() const;
};

/// Recognises the humanoid in a skeleton by the names of its joints (VRM, Mixamo with any prefix, Unity, Unreal,
/// Rigify, CMU/cgspeed, Daz, MakeHuman, ...), its hierarchy and its rest geometry together. A skeleton that is no
/// humanoid gives an empty map.
[[nodiscard]] HumanoidMap recognise_humanoid(const Skeleton& skeleton);

/// The horizontal unit direction that the body faces in the given joint positions: from hip line and shoulder line
/// where there is a humanoid, else +Z.
[[nodiscard]] Vec3 compute_facing(const HumanoidMap& humanoid, std::span<const Vec3> positions);

}  // namespace croquis
