// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "croquis/math/polyline.h"

namespace croquis {

/// A stroke as the line solver reads it: a C1 curve c(s) over arc length s (cubic Hermite pieces between equally spaced
/// knots), that goes on straight beyond both ends. Units are the caller's. Holds room for `capacity` knots from the
/// start, so that drawing on never allocates.
class StrokeCurve {
 public:
  static constexpr int kKnots = 129;

  StrokeCurve();

  /// Takes the shape of `line`, each point p as scale * p + offset per axis (scale.y may be negative: pixels grow
  /// downward), from its last point to its first if `reversed`. Throws invalid_argument if it has no length.
  void assign(std::span<const Vec2> points, const Vec2& scale, const Vec2& offset, bool reversed = false);

  [[nodiscard]] double length() const { return length_; }
  [[nodiscard]] Vec2 at(double s) const;
  /// dc/ds; close to unit length, as knots are spaced by the arc length of the polyline.
  [[nodiscard]] Vec2 derivative(double s) const;
  /// Mean squared distance of the curve between a and b (a < b, inside the curve) from the chord's straight line.
  [[nodiscard]] double unevenness(double a, double b) const;
  /// The arc length of the knot-wise nearest point.
  [[nodiscard]] double nearest(const Vec2& point) const;
  /// Scales about `centre`.
  void scale_about(const Vec2& centre, double factor);
  void shift(const Vec2& offset);

 private:
  void finish();
  double length_ = 0.0, step_ = 0.0;
  std::vector<Vec2> knots_, slopes_;
  struct Moments {
    double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  };
  std::vector<Moments> sums_;  ///< of knots before each
};

}  // namespace croquis
