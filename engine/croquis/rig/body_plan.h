// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "croquis/rig/joint_name.h"
#include "croquis/rig/skeleton.h"

namespace croquis {

/// Three joints that bend as an arm (shoulder, elbow, wrist) or a leg (hip, knee, ankle) does.
struct Limb {
  int upper = -1, lower = -1;
  int end = -1;         ///< -1: names say what the first two are, and there is no third
  double names = 0.0;   ///< 0..1: how far the names say so
  double score = -1e9;  ///< for comparing candidates
  NameSide side = NameSide::none;
};

/// Where the parts of a humanoid hang together.
struct BodyPlan {
  int hips = -1;   ///< carries the legs and the trunk
  int chest = -1;  ///< carries the arms
  int head = -1;
  Limb left_arm, right_arm, left_leg, right_leg;
  double names = 0.0;  ///< 0..1: how far names say what is what
  bool head_named = false;
  bool sides_named = false;  ///< else left and right come from the geometry
};

/// Reads every name; unnamed leaves of a skeleton that has names (End Sites) count as ignored.
[[nodiscard]] std::vector<JointName> read_joint_names(const Skeleton& skeleton);

/// Looks for two pairs of limbs and a head that hang together as in a human, by names, hierarchy and rest geometry.
/// Without names the trunk must stand over the legs; with them any rest pose will do, unless it is a quadruped's. The
/// sides come from names, else from where feet, knees and elbows point (else the body is taken to face +Z).
[[nodiscard]] std::optional<BodyPlan> find_body_plan(const Skeleton& skeleton, const std::vector<JointName>& names);

}  // namespace croquis
