// SPDX-License-Identifier: MIT
#pragma once

#include "croquis/body/armature.h"
#include "croquis/body/body.h"
#include "croquis/body/implicit_surface.h"

namespace croquis {

/// The landmarks of the mannequin in metres, from its proportions: the only place where proportions are read.
struct MannequinMeasures {
  explicit MannequinMeasures(const Proportions& proportions);

  double unit;         ///< a seventh of the height up to the chin at limbs = 1: the length that the body is measured in
  double head;         ///< chin to crown
  double chin;         ///< height of the chin
  double thick;        ///< thickness of limbs and masses, in units
  double trunk_thick;  ///< the same for trunk and neck, which vary less
  double hip_wide, shoulder_wide;
  double lift;  ///< what longer legs raise the trunk by, metres
  double arm_long, leg_long;
  double hand;  ///< wrist to fingertip, metres
  double foot;  ///< the foot's own unit, metres
};

/// The mannequin's joints, named as VRM humanoid bones: T-pose, facing +Z, ankles over flat soles at y = 0.
[[nodiscard]] Armature make_mannequin_armature(const MannequinMeasures& measures);

/// The left half's masses, limb by limb. Each finds its joints in the armature by name.
[[nodiscard]] Limb make_trunk(const MannequinMeasures& measures, const Armature& armature);
[[nodiscard]] Limb make_head(const MannequinMeasures& measures, const Armature& armature);
[[nodiscard]] Limb make_arm(const MannequinMeasures& measures, const Armature& armature);
[[nodiscard]] Limb make_leg(const MannequinMeasures& measures, const Armature& armature);

[[nodiscard]] Character make_mannequin(const Proportions& proportions);

}  // namespace croquis
