// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "croquis/math/camera.h"
#include "croquis/posing/line_fit.h"
#include "croquis/rig/body_line.h"
#include "croquis/rig/pose.h"
#include "croquis/sketch/stroke.h"

namespace croquis {

/// The methods of the lines-of-action report. `near` and `curvilinear` move joints and so stretch bones; the two
/// rotation methods (Algorithm 1) keep their lengths.
enum class MatchMethod {
  near,            ///< each joint to the nearest point of the line
  curvilinear,     ///< joint i to the line's point at parameter i/K, as printed
  rotation_index,  ///< Algorithm 1 with targets by index
  rotation,        ///< Algorithm 1 with targets by arc length
};
[[nodiscard]] std::optional<MatchMethod> parse_match_method(std::string_view name);
[[nodiscard]] std::string_view to_string(MatchMethod method);

enum class RootMode {
  lock,     ///< the root of the skeleton neither moves nor turns
  tangent,  ///< the root's up axis turns to the line's tangent p(r + e) - p(r - e) where the root is matched
};

/// Which way along the line a segment runs.
enum class DirectionRule {
  scalar_product,  ///< toward the part of the line it now points along
  length,          ///< toward the part whose length is nearer to its own
  forward,         ///< the line starts at the body line's first joint
  backward,
};

struct MatchOptions {
  MatchMethod method = MatchMethod::rotation;
  RootMode root = RootMode::lock;
  DirectionRule direction = DirectionRule::scalar_product;
  DrawingPlane plane = DrawingPlane::free;
};

struct MatchResult {
  Pose pose;
  std::string status = "ok";  ///< "ok", or one sentence on what is not as asked ("bones were stretched by 12 %")
  bool forward = true;        ///< the stroke was taken to start at the first joint of the line
  LineFit fit;
  double bone_length_drift = 0.0;  ///< relative; 0 for the rotation methods up to rounding
};

/// Poses the joints of `segments` (see rig/body_line.h) along a stroke seen by `camera`. `start` is the pose the
/// stroke was drawn over; the stroke lies in the drawing plane through the centre of the box around its joints.
///
/// All segments share the stroke: the root of each is matched with the stroke's nearest point, and from there the
/// segment runs along it one way. Two segments with one root run opposite ways. `forward` sends a lone segment (and the
/// second of two) the way the stroke was drawn. For each pivot in turn the rotation methods apply the shortest rotation
/// that turns the next joint toward its target, to the pivot and everything below it; a joint from which several
/// segments start is no pivot, as its turn for one would spoil the others. `near` and `curvilinear` move joints where
/// their points are, so the pose has translations that it did not have.
///
/// Throws invalid_argument for an empty list, a segment that is none, a stroke without length, a pose of another size
/// and a camera that cannot see the plane. Source: bergeres_loa, sections III and IV.
[[nodiscard]] MatchResult match_line(const Skeleton& skeleton, const Pose& start,
                                     std::span<const SkeletonSegment> segments, const Polyline2& stroke,
                                     const Camera& camera, const MatchOptions& options = {});

/// The same for a body line: `forward` and `backward` mean its own order, and the fit is measured along it.
[[nodiscard]] MatchResult match_line(const Skeleton& skeleton, const Pose& start, const BodyLine& line,
                                     const Polyline2& stroke, const Camera& camera, const MatchOptions& options = {});

}  // namespace croquis
