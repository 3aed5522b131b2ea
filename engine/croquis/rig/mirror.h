// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "croquis/rig/humanoid.h"
#include "croquis/rig/skeleton.h"

namespace croquis {

/// For each joint the joint of the other side; a joint of the middle (or one without partner) is its own mirror. The
/// map is an involution. Partners are found by names (Left/Right, _l/_r, .L/.R, ...), by the humanoid map, and by
/// geometry and hierarchy where the names say nothing.
[[nodiscard]] std::vector<int> compute_mirror_map(const Skeleton& skeleton, const HumanoidMap& humanoid);

}  // namespace croquis
