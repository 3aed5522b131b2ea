// SPDX-License-Identifier: MIT
// The labelled skeletons of tests/rig/rigs.txt.
#pragma once

#include <string>
#include <vector>

#include "croquis/rig/humanoid.h"
#include "croquis/rig/skeleton.h"

namespace croquis {

struct LabelledRig {
  std::string name;
  std::vector<Joint> joints;  ///< identity rotations
  HumanoidMap labels;

  [[nodiscard]] Skeleton skeleton() const { return Skeleton(joints); }
  [[nodiscard]] bool is_humanoid() const { return !name.starts_with("none/"); }
};

[[nodiscard]] const std::vector<LabelledRig>& labelled_rigs();
[[nodiscard]] const LabelledRig& labelled_rig(const std::string& name);

/// The same body with every joint's axes turned at random (all bone rolls different, positions and names as before).
[[nodiscard]] Skeleton with_random_axes(const Skeleton& skeleton, std::uint64_t seed);

}  // namespace croquis
