// SPDX-License-Identifier: MIT
#pragma once

#include "croquis/math/camera.h"
#include "croquis/math/polyline.h"
#include "croquis/rig/body_line.h"
#include "croquis/rig/pose.h"

namespace croquis {

/// How near the posed line comes to what was drawn, in the picture.
struct LineFit {
  double mean_px = 0.0;  ///< mean distance from the projected joints of the line to the stroke
  double max_px = 0.0;
  double tangent_deg = 0.0;  ///< mean angle between projected bones and the stroke there, degrees
};

/// The fit of a body line in a pose to a stroke. Joints that the camera has behind it are left out; bones that project
/// to less than half a pixel have no direction and do not enter `tangent_deg`.
[[nodiscard]] LineFit measure_fit(const Skeleton& skeleton, const Pose& pose, const BodyLine& line,
                                  const Polyline2& stroke, const Camera& camera);

}  // namespace croquis
