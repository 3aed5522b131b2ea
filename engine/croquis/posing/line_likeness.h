// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "croquis/math/camera.h"
#include "croquis/math/polyline.h"
#include "croquis/rig/body_line.h"
#include "croquis/rig/humanoid.h"

namespace croquis {

/// The parts of a body, by how far they usually move from where they are: hips hardly, hands a long way. Everything of
/// what is no humanoid is `trunk`.
enum class BodyPart { trunk, hip, shoulder, head, knee, elbow, foot, hand };
inline constexpr int kBodyParts = 8;

/// A body line as it stands in a picture.
struct SeenLine {
  std::vector<Vec2> joints;  ///< pixels
  std::vector<BodyPart> parts;
  std::vector<double> share;  ///< per joint: part of the line's length before it, 0 to 1
  double length = 0.0;        ///< of its picture, pixels
  double reach = 0.0;         ///< pixels that its bones would cover lying flat
};

/// Nothing if a joint lies behind the camera, or if the line has no length. `positions`: all joints, world space.
[[nodiscard]] std::optional<SeenLine> see_line(const HumanoidMap& humanoid, std::span<const Vec3> positions,
                                               const BodyLine& line, const Camera& camera);

/// How a stroke differs from a line that stands so. Lengths are in body sizes (leg and trunk).
struct Unlikeness {
  std::array<double, kBodyParts> away{};  ///< mean, per part: from joints to the stroke at the same share of its length
  std::array<double, kBodyParts> aside{};  ///< mean, per part: from joints to the stroke's nearest point
  double too_long = 0.0;                   ///< longer than the bones reach: log of the ratio
  double longer = 0.0, shorter = 0.0;      ///< than the line is now: log of the ratio
};

/// `forward`: the stroke starts at the line's first joint; `body_px`: leg and trunk, pixels.
[[nodiscard]] Unlikeness compare_line(const SeenLine& line, const Polyline2& stroke, bool forward, double body_px);

}  // namespace croquis
