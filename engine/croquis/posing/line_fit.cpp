// SPDX-License-Identifier: MIT
#include "croquis/posing/line_fit.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace croquis {

LineFit measure_fit(const Skeleton& skeleton, const Pose& pose, const BodyLine& line, const Polyline2& stroke,
                    const Camera& camera) {
  const std::vector<Vec3> positions = compute_positions(skeleton, pose);
  std::vector<std::optional<Vec2>> pixels;
  LineFit fit;
  int seen = 0;
  for (const int joint : line.joints) {
    pixels.push_back(camera.project(positions[static_cast<std::size_t>(joint)]));
    if (!pixels.back()) continue;
    const double distance = (stroke.at(stroke.nearest(*pixels.back())) - *pixels.back()).norm();
    fit.mean_px += distance;
    fit.max_px = std::max(fit.max_px, distance);
    ++seen;
  }
  if (seen > 0) fit.mean_px /= seen;

  // The stroke may run either way along the line: whichever way the bones agree with better is meant.
  double along = 0.0, against = 0.0;
  int bones = 0;
  for (std::size_t i = 0; i + 1 < pixels.size(); ++i) {
    if (!pixels[i] || !pixels[i + 1]) continue;
    const Vec2 bone = *pixels[i + 1] - *pixels[i];
    if (bone.norm() < 0.5) continue;
    const Vec2 tangent = stroke.tangent(stroke.nearest(0.5 * (*pixels[i] + *pixels[i + 1])));
    const double angle = std::acos(std::clamp(bone.normalized().dot(tangent), -1.0, 1.0)) / kDegree;
    along += angle;
    against += 180.0 - angle;
    ++bones;
  }
  if (bones > 0) fit.tangent_deg = std::min(along, against) / bones;
  return fit;
}

}  // namespace croquis
