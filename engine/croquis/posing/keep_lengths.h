// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "croquis/rig/pose.h"

namespace croquis {

/// Under an ancestor that scales unevenly a rotation changes the lengths of the bones below it, and no rotation but a
/// few keeps them. What can be kept are positions: every joint there gets the translation that puts it where `wanted`
/// (model space, one per joint) says, or, if that is empty, at its bone's length in `start` along the direction that
/// `pose` gives it. Other joints stay as they are; nothing is allocated if there are none.
void keep_bone_lengths(const Skeleton& skeleton, const Pose& start, std::span<const Vec3> wanted, Pose& pose);

/// Whether a linear map is not a multiple of a rotation or mirroring.
[[nodiscard]] bool scales_unevenly(const Mat3& linear);

}  // namespace croquis
