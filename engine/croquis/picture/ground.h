// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "croquis/picture/scene.h"

namespace croquis {

/// The direction towards the key light, unit, world axes: from the upper left in front, whatever the camera looks at.
[[nodiscard]] Vec3 key_light_direction(const Camera& camera);

/// How dark the figures make the ground: the shadow of the key light, wider and fainter the higher what casts it, and
/// the sky that they hide, deep under what touches the ground. Computed on a grid seen from above.
class GroundShade {
 public:
  GroundShade(const Scene& scene, const Vec3& towards_light);

  struct Value {
    float shadow = 0.0F;   ///< part of the key light that does not arrive
    float contact = 0.0F;  ///< part of the sky that is hidden
  };
  /// At a point (x, z) of the ground, scene space; nothing beyond the grid.
  [[nodiscard]] Value at(double x, double z) const;

 private:
  double left_ = 0.0, back_ = 0.0, cell_ = 1.0;
  int width_ = 0, depth_ = 0;
  std::vector<Value> values_;
};

/// From pixels to the ground, as a homography: (x w, z w, w) = matrix * (pixel x, pixel y, 1), scene space; the ray
/// meets the ground in front of the camera where w > 0. A camera that looks along the ground sees it tilted towards it
/// by a few degrees, so that there is a ground to see; one that looks from below sees none (zero matrix).
[[nodiscard]] Mat3 ground_from_pixel(const Scene& scene, const Camera& camera);

/// 0 below `low`, 1 above `high`, a cubic with level ends between.
[[nodiscard]] float smooth_step(float low, float high, float value);

}  // namespace croquis
