// SPDX-License-Identifier: MIT
#include "croquis/posing/body_shape.h"

#include <algorithm>
#include <cmath>

namespace croquis {
namespace {

using enum HumanoidBone;

/// The radius of the bone below a joint, in parts of a standing body's height.
double radius_of(HumanoidBone bone) {
  switch (bone) {
    case hips:
    case spine:
    case chest:
    case upperChest:
      return 0.060;
    case neck:
      return 0.028;
    case head:
      return 0.048;
    case leftUpperLeg:
    case rightUpperLeg:
      return 0.040;
    case leftLowerLeg:
    case rightLowerLeg:
      return 0.027;
    case leftUpperArm:
    case rightUpperArm:
      return 0.023;
    default:
      return 0.018;
  }
}

/// The height of a standing humanoid, from lengths that do not depend on its pose.
double height_of(const Skeleton& skeleton, const HumanoidMap& humanoid, std::span<const Vec3> x) {
  const auto length = [&](int from, int to) {
    double sum = 0.0;
    const std::vector<int> path = skeleton.path(from, to);
    for (std::size_t i = 1; i < path.size(); ++i) {
      sum += (x[static_cast<std::size_t>(path[i])] - x[static_cast<std::size_t>(path[i - 1])]).norm();
    }
    return sum;
  };
  const int foot = humanoid.joint(humanoid.has(leftFoot) ? leftFoot : leftLowerLeg);
  const int top = humanoid.joint(humanoid.has(head) ? head : neck);
  return 1.15 * (length(humanoid.joint(leftUpperLeg), foot) + length(humanoid.joint(hips), top));
}

bool is_finger(const Skeleton& skeleton, const HumanoidMap& humanoid, int joint) {
  for (const HumanoidBone hand : {leftHand, rightHand}) {
    if (humanoid.has(hand) && joint != humanoid.joint(hand) && skeleton.is_ancestor(humanoid.joint(hand), joint)) {
      return skeleton.parent(joint) != humanoid.joint(hand);  // the palm stays
    }
  }
  return false;
}

}  // namespace

std::vector<BoneCapsule> make_bone_capsules(const Skeleton& skeleton, const HumanoidMap& humanoid,
                                            std::span<const Vec3> positions) {
  constexpr std::size_t kMost = 64;
  const bool person = humanoid.is_humanoid();
  const double size = person ? height_of(skeleton, humanoid, positions) : skeleton.extent();
  std::vector<BoneCapsule> capsules;
  for (int joint = 1; joint < skeleton.joint_count(); ++joint) {
    const int parent = skeleton.parent(joint);
    if (skeleton.joint(parent).helper || (person && is_finger(skeleton, humanoid, joint))) continue;
    BoneCapsule capsule{parent, joint, positions[static_cast<std::size_t>(parent)],
                        positions[static_cast<std::size_t>(joint)], 0.0};
    const double length = (capsule.to - capsule.from).norm();
    if (!(length > 0.01 * size)) continue;
    const auto bone = humanoid.bone_of(parent);
    if (person && !bone) continue;  // hair, cloth, twist helpers
    capsule.radius = person ? size * radius_of(*bone) : std::min(0.25 * length, 0.04 * size);
    capsules.push_back(capsule);
  }
  if (person && humanoid.has(head) && skeleton.children(humanoid.joint(head)).empty()) {
    const int top = humanoid.joint(head);
    const Vec3 at = positions[static_cast<std::size_t>(top)];
    const Vec3 along = at - positions[static_cast<std::size_t>(skeleton.parent(top))];
    if (along.norm() > 0.0) {
      capsules.push_back({top, top, at, at + 0.07 * size * along.normalized(), size * radius_of(head)});
    }
  }
  if (capsules.size() > kMost) {
    std::stable_sort(capsules.begin(), capsules.end(), [](const BoneCapsule& a, const BoneCapsule& b) {
      return (a.to - a.from).squaredNorm() > (b.to - b.from).squaredNorm();
    });
    capsules.resize(kMost);
  }
  return capsules;
}

NearestPoints nearest_points(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1) {
  const Vec3 u = a1 - a0, v = b1 - b0, w = a0 - b0;
  const double a = u.squaredNorm(), b = u.dot(v), c = v.squaredNorm(), d = u.dot(w), e = v.dot(w);
  const double least = 1e-18, room = a * c - b * b;
  double s = a > least && c > least && room > 1e-12 * a * c ? std::clamp((b * e - c * d) / room, 0.0, 1.0) : 0.0;
  double t = c > least ? (b * s + e) / c : 0.0;
  if (t < 0.0 || t > 1.0) t = std::clamp(t, 0.0, 1.0);
  s = a > least ? std::clamp((b * t - d) / a, 0.0, 1.0) : 0.0;
  t = c > least ? std::clamp((b * s + e) / c, 0.0, 1.0) : 0.0;
  return {s, t, (w + s * u - t * v).norm()};
}

}  // namespace croquis
