// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "croquis/math/types.h"

namespace croquis {

struct SmoothingOptions {
  double most_removed = 1.5;     ///< root mean square distance that smoothing may move points, pixels
  double corner_reach = 12.0;    ///< length before and after a point over which its turn is measured, pixels
  double corner_degrees = 50.0;  ///< turns sharper than this are corners
};

/// The curve that a shaking hand meant: the points at equal arc lengths, moved by a discrete smoothing spline
///     min sum |p_i - y_i|^2 + lambda sum |p_{i-1} - 2 p_i + p_{i+1}|^2
/// between corners, which stay where they are, as do both ends. lambda is the largest that moves the points by no more
/// than the jitter found in them (estimated from their fourth differences across the stroke) and never by more than
/// `most_removed`: what is smooth already comes back unchanged. At most 4096 points. Source: reinsch1967,
/// whittaker1923.
[[nodiscard]] std::vector<Vec2> smooth_curve(const std::vector<Vec2>& points, const SmoothingOptions& options);

/// The standard deviation of the jitter across the curve, in the units of the points; 0 for fewer than 7 points.
[[nodiscard]] double estimate_jitter(const std::vector<Vec2>& points);

}  // namespace croquis
