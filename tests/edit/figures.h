// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "croquis/project/character.h"

namespace croquis {

/// A stalk of `bones` bones of length 1 that stands on the origin, joints "j0", "j1", ...
inline Character stalk(int bones) {
  std::vector<Joint> joints{{"j0", -1, {}}};
  for (int i = 1; i <= bones; ++i) {
    Transform up;
    up.translation = Vec3(0, 1, 0);
    joints.push_back({"j" + std::to_string(i), i - 1, up});
  }
  const Skeleton skeleton(std::move(joints));
  return Character{.name = "stalk", .skeleton = skeleton, .start = rest_pose(skeleton)};
}

/// A root with two arms of two bones each, along +X and -X: joints root, a1, a2, b1, b2.
inline Character cross() {
  const auto at = [](double x) {
    Transform transform;
    transform.translation = Vec3(x, 0, 0);
    return transform;
  };
  const Skeleton skeleton({{"root", -1, {}}, {"a1", 0, at(1)}, {"a2", 1, at(1)}, {"b1", 0, at(-1)}, {"b2", 3, at(-1)}});
  return Character{.name = "cross", .skeleton = skeleton, .start = rest_pose(skeleton)};
}

/// A clip that turns joint 1 about z by `degrees` from frame 0 to frame 2, and lifts joint 0.
inline Clip waving_clip(double degrees) {
  const double half = 0.5 * degrees * kDegree;
  Curve turn;
  turn.joint = 1;
  turn.times = {0.0, 0.5, 1.0};
  turn.values = {0, 0, 0, 1, 0, 0, std::sin(0.5 * half), std::cos(0.5 * half), 0, 0, std::sin(half), std::cos(half)};
  Curve lift;
  lift.target = CurveTarget::translation;
  lift.joint = 0;
  lift.width = 3;
  lift.times = {0.0, 1.0};
  lift.values = {0, 0, 0, 0, 4, 0};
  return {"wave", {turn, lift}};
}

}  // namespace croquis
