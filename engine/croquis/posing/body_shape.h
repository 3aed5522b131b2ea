// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "croquis/rig/humanoid.h"
#include "croquis/rig/skeleton.h"

namespace croquis {

/// A bone with flesh on it: a capsule about the straight line from a joint's parent to the joint, model units. A
/// humanoid's head without a joint at its top goes on along the neck.
struct BoneCapsule {
  int parent = -1, joint = -1;  ///< a head's: the same joint twice
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();
  double radius = 0.0;
};

/// The capsules of a body in a pose (its joints' positions), bones of next to no length and fingers left out; at most
/// 64, the longest. A humanoid's radii are those of people, in parts of the height; of other bodies a quarter of the
/// bone's length, and no more than 4 % of the body's size.
[[nodiscard]] std::vector<BoneCapsule> make_bone_capsules(const Skeleton& skeleton, const HumanoidMap& humanoid,
                                                          std::span<const Vec3> positions);

/// Where two segments are nearest to each other: a0 + s (a1 - a0) and b0 + t (b1 - b0). Source: ericson2005.
struct NearestPoints {
  double s = 0.0, t = 0.0, distance = 0.0;
};
[[nodiscard]] NearestPoints nearest_points(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1);

}  // namespace croquis
