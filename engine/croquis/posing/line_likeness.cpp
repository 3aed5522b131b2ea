// SPDX-License-Identifier: MIT
#include "croquis/posing/line_likeness.h"

#include <algorithm>
#include <cmath>

namespace croquis {
namespace {

BodyPart part_of(const HumanoidMap& humanoid, int joint) {
  using enum HumanoidBone;
  const std::optional<HumanoidBone> bone = humanoid.bone_of(joint);
  if (!bone) return BodyPart::trunk;
  switch (*bone) {
    case leftUpperLeg:
    case rightUpperLeg:
      return BodyPart::hip;
    case leftShoulder:
    case rightShoulder:
    case leftUpperArm:
    case rightUpperArm:
      return BodyPart::shoulder;
    case neck:
    case head:
      return BodyPart::head;
    case leftLowerLeg:
    case rightLowerLeg:
      return BodyPart::knee;
    case leftLowerArm:
    case rightLowerArm:
      return BodyPart::elbow;
    case leftFoot:
    case rightFoot:
    case leftToes:
    case rightToes:
      return BodyPart::foot;
    case leftHand:
    case rightHand:
      return BodyPart::hand;
    default:
      return BodyPart::trunk;
  }
}

}  // namespace

std::optional<SeenLine> see_line(const HumanoidMap& humanoid, std::span<const Vec3> positions, const BodyLine& line,
                                 const Camera& camera) {
  SeenLine seen;
  for (std::size_t k = 0; k < line.joints.size(); ++k) {
    const Vec3& x = positions[static_cast<std::size_t>(line.joints[k])];
    const std::optional<Vec2> pixel = camera.project(x);
    if (!pixel) return std::nullopt;
    if (k > 0) {
      const Vec3& before = positions[static_cast<std::size_t>(line.joints[k - 1])];
      seen.reach += (x - before).norm() / camera.units_per_pixel(0.5 * (x + before));
      seen.length += (*pixel - seen.joints.back()).norm();
    }
    seen.joints.push_back(*pixel);
    seen.parts.push_back(part_of(humanoid, line.joints[k]));
    seen.share.push_back(seen.reach);
  }
  if (!(seen.reach > 0.0)) return std::nullopt;
  for (double& share : seen.share) share /= seen.reach;
  return seen;
}

Unlikeness compare_line(const SeenLine& line, const Polyline2& stroke, bool forward, double body_px) {
  Unlikeness u;
  std::array<int, kBodyParts> count{};
  for (std::size_t k = 0; k < line.joints.size(); ++k) {
    const auto part = static_cast<std::size_t>(line.parts[k]);
    const double share = forward ? line.share[k] : 1.0 - line.share[k];
    u.away[part] += (stroke.at(share * stroke.length()) - line.joints[k]).norm() / body_px;
    u.aside[part] += (stroke.at(stroke.nearest(line.joints[k])) - line.joints[k]).norm() / body_px;
    ++count[part];
  }
  for (std::size_t part = 0; part < count.size(); ++part) {
    if (count[part] == 0) continue;
    u.away[part] /= count[part];
    u.aside[part] /= count[part];
  }
  const double ratio = std::log(stroke.length() / std::max(line.length, 1e-3 * stroke.length()));
  u.too_long = std::max(0.0, std::log(stroke.length() / line.reach));
  u.longer = std::max(0.0, ratio);
  u.shorter = std::max(0.0, -ratio);
  return u;
}

}  // namespace croquis
