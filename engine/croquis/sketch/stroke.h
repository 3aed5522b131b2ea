// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "croquis/math/camera.h"
#include "croquis/math/polyline.h"

namespace croquis {

/// One sample of the pen, in pixels of the stroke's view.
struct StrokeSample {
  Vec2 position = Vec2::Zero();
  double time = 0.0;      ///< seconds since the pen came down
  double pressure = 0.5;  ///< 0..1; 0.5 where the device has none
};

/// What a person drew, as it was drawn. `raw_pen` samples carry a hand's jitter and hooks; a path from a drawing
/// program does not, and is never trimmed.
struct Stroke {
  std::string name;  ///< the path's id in a file; may be empty
  std::vector<StrokeSample> samples;
  bool raw_pen = false;
};

/// Throws invalid_argument with what is wrong: fewer than two distinct points, a number that is not finite, or a point
/// outside the view by more than the view's own size.
void check_stroke(const Stroke& stroke, const Camera& camera);

struct CleanStrokeOptions {
  int points = 128;              ///< of the result, at equal arc lengths
  double smoothing_px = 1.5;     ///< standard deviation of the jitter taken out of raw pen samples
  double hook_length = 0.02;     ///< raw pen only: an end shorter than this part of the stroke ...
  double hook_degrees = 120.0;   ///< ... that turns by more than this is cut off
  double corner_degrees = 50.0;  ///< raw pen only: turns sharper than this within the smoothing length stay corners
};

/// The stroke as the solvers want it: points at equal arc lengths, so that nothing depends on the speed of the pen;
/// raw pen samples freed of hooks and smoothed with their corners and both ends kept.
[[nodiscard]] Polyline2 clean_stroke(const Stroke& stroke, const CleanStrokeOptions& options = {});

/// The plane in space that a stroke is taken to lie in: through the centre of the scene, `free` orthogonal to the
/// camera, `ground` upright (holding the ground's normal) and turned to the camera as far as that allows.
enum class DrawingPlane { free, ground };

/// The plane's unit normal. Throws invalid_argument for `ground` seen from straight above or below, or within about a
/// degree of it, where a pixel would stand for half the scene.
[[nodiscard]] Vec3 drawing_plane_normal(DrawingPlane plane, const Camera& camera);

/// The points of a picture on a plane through `centre`. Throws invalid_argument if a ray misses the plane.
[[nodiscard]] std::vector<Vec3> unproject_stroke(const std::vector<Vec2>& pixels, const Camera& camera,
                                                 DrawingPlane plane, const Vec3& centre);

}  // namespace croquis
