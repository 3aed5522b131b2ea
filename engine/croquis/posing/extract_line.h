// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include "croquis/math/camera.h"
#include "croquis/math/polyline.h"
#include "croquis/rig/body_line.h"
#include "croquis/rig/pose.h"

namespace croquis {

/// What an illustrator calls a line of action.
enum class LineShape {
  straight,
  c,        ///< bends one way
  s,        ///< one way, then the other
  compound  ///< more often
};
[[nodiscard]] std::string_view to_string(LineShape shape);

struct LineCharacter {
  LineShape shape = LineShape::straight;
  /// Largest distance from the chord between the ends, per length of the line: 0 straight, about 0.29 a half circle.
  double strength = 0.0;
  double turn_degrees = 0.0;          ///< all turning, either way
  std::vector<double> bends_degrees;  ///< of each bend in order, left (counter-clockwise as seen) positive
};

/// Reads the shape of a curve in pixels (y down). Bends of less than `least_degrees` are taken for straight.
[[nodiscard]] LineCharacter classify_line(const Polyline2& line, double least_degrees = 21.0);

/// The smooth curve through points (centripetal Catmull-Rom: no loops, no overshoot), `count` points at equal arc
/// lengths. Source: yuksel2011.
[[nodiscard]] Polyline2 curve_through(const std::vector<Vec2>& points, int count = 96);

/// The line that a pose has, in the picture: the curve through the projected joints of the body line, from its first
/// joint on. Drawing it again over the same pose changes nothing. Throws invalid_argument if the camera has a joint
/// behind it, or if all joints project to one point.
[[nodiscard]] Polyline2 extract_line(const Skeleton& skeleton, const Pose& pose, const BodyLine& line,
                                     const Camera& camera, int count = 96);

/// The curve with its bends multiplied, 0 straight, 1 as it is, 2 twice as bent: the turning of its direction is scaled
/// about its mean; length, middle and mean direction stay. `factor` in [0, 2].
[[nodiscard]] Polyline2 exaggerate_line(const Polyline2& line, double factor);

}  // namespace croquis
