// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "croquis/rig/pose.h"

namespace croquis {

enum class Interpolation { step, linear, cubic_spline };

/// What a curve moves: a part of a joint's local transform, or the shape weights of a mesh.
enum class CurveTarget { translation, rotation, scale, weights };

/// One animated quantity after glTF: key i is at times[i] seconds, its value the `width` numbers from
/// values[i * width] (for cubic_spline from values[(3 * i + 1) * width], between in- and out-tangent). Rotations are
/// quaternions xyzw, interpolated by slerp where linear.
struct Curve {
  CurveTarget target = CurveTarget::rotation;
  int joint = -1;  ///< for weights: the index of the part whose shapes they move
  Interpolation interpolation = Interpolation::linear;
  int width = 4;  ///< 3, 4, or the number of shapes
  std::vector<double> times;
  std::vector<double> values;

  /// Throws invalid_argument unless sizes agree, times are finite and increase, and values are finite.
  void check() const;
  /// The value at `time`, clamped to the first and last key; `width` numbers. Rotations come out normalised.
  [[nodiscard]] std::vector<double> sample(double time) const;
};

struct Clip {
  std::string name;
  std::vector<Curve> curves;

  [[nodiscard]] double start_time() const;  ///< the first key of any curve, seconds; 0 without keys
  [[nodiscard]] double end_time() const;
  /// The number of frames: the keys of the curve that has the most (all have as many in a BVH).
  [[nodiscard]] int frame_count() const;
  /// The time of frame n, counted from 0: the n-th key of the curve with the most keys. Throws invalid_argument
  /// beyond frame_count().
  [[nodiscard]] double frame_time(int frame) const;
};

/// The pose at `time`: what the clip does not move stays as in `base`. Shape weights are left to `sample_weights`.
[[nodiscard]] Pose sample_pose(const Clip& clip, double time, const Pose& base);

/// The shape weights of part `part` at `time`; `base` where the clip does not move them.
[[nodiscard]] std::vector<float> sample_weights(const Clip& clip, double time, int part,
                                                const std::vector<float>& base);

}  // namespace croquis
