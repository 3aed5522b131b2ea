// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "croquis/math/types.h"

namespace croquis {

/// Points joined by straight segments and addressed by arc length: `at(s)` for s in [0, length()]. Works in the plane
/// (Vec2) and in space (Vec3). Points that repeat their predecessor are harmless.
template <class Point>
class Polyline {
 public:
  /// At least one point, all finite; throws invalid_argument otherwise.
  explicit Polyline(std::vector<Point> points);

  [[nodiscard]] double length() const { return arc_.back(); }
  [[nodiscard]] const std::vector<Point>& points() const { return points_; }
  /// Arc length from the start to each point; same size as points().
  [[nodiscard]] const std::vector<double>& arc() const { return arc_; }

  /// The point at arc length s; s is clamped to [0, length()].
  [[nodiscard]] Point at(double s) const;
  /// The unit direction of travel at s; zero if all points are equal.
  [[nodiscard]] Point tangent(double s) const;
  /// The arc length of the point nearest to `point` (the first of several equally near).
  [[nodiscard]] double nearest(const Point& point) const;
  /// `count` >= 2 points at equal arc lengths from start to end.
  [[nodiscard]] std::vector<Point> resampled(int count) const;

 private:
  [[nodiscard]] int segment_at(double s) const;
  std::vector<Point> points_;
  std::vector<double> arc_;
};

using Polyline2 = Polyline<Vec2>;
using Polyline3 = Polyline<Vec3>;

}  // namespace croquis
