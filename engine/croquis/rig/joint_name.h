// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace croquis {

/// What a joint's name may say that it is, without its side; `carrier` is a bone of the palm or pelvis that only holds
/// others.
enum class NameRole {
  // clang-format off
  hips, spine, neck, head, eye, jaw,
  upper_leg, lower_leg, foot, toes, shoulder, upper_arm, lower_arm, hand,
  thumb, index, middle, ring, little, finger, carrier,
  // clang-format on
};

enum class NameSide { none, left, right };

/// A joint's name, read with the vocabulary of the usual rigs (VRM, Unity, Mixamo, HIK, Unreal, Rigify, Biovision, CMU,
/// Daz, MakeHuman, Biped, Character Creator, MikuMikuDance, ...): words apart at capitals, digits and separators.
struct JointName {
  NameSide side = NameSide::none;
  std::vector<std::pair<NameRole, double>> roles;  ///< what it may be, with a certainty in (0, 1]
  std::vector<std::string> numbers;                ///< the digits behind its last word ("finger1-2" -> "1", "2")
  /// It names no part of a body: an IK target, a controller, a twist helper, an end, hair, a tail, ...
  bool ignored = false;

  /// The certainty that it is `role`; 0 if the name says nothing; negative if it says something else.
  [[nodiscard]] double affinity(NameRole role) const;
  [[nodiscard]] bool says_nothing() const;
  [[nodiscard]] int number() const;  ///< the first of `numbers`, or -1
};

[[nodiscard]] JointName read_joint_name(std::string_view name);

/// The name with its side taken out, and the side ("Left Arm" -> "* arm", left): two joints whose remainders agree and
/// whose sides differ are partners. The remainder is lower case and keeps the place of the side as one '*'.
[[nodiscard]] std::pair<NameSide, std::string> split_side(std::string_view name);

}  // namespace croquis
