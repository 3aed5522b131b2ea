// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "croquis/rig/humanoid.h"

namespace croquis {

/// What a joint is like to turn.
enum class JointRole {
  root,    ///< carries the whole body
  spine,   ///< shares its bend with its neighbours
  collar,  ///< a collar bone: gives way a little
  ball,    ///< hip, shoulder
  hinge,   ///< knee, elbow
  end,     ///< hand, foot, toe, finger
  plain,   ///< of a body that is no humanoid
};

/// The role of every joint. Of what is no humanoid: the body's root is `root`, a joint from which several branches with
/// bones of their own start is `ball`, the rest `plain`.
[[nodiscard]] std::vector<JointRole> compute_joint_roles(const Skeleton& skeleton, const HumanoidMap& humanoid);

/// The joint that carries the body: a humanoid's hips, else the first joint from which something branches off and that
/// has nothing but its own ancestors above it; a chain's first joint that is no helper and has a bone of its own.
[[nodiscard]] int find_body_root(const Skeleton& skeleton, const HumanoidMap& humanoid);

}  // namespace croquis
