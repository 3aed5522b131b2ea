// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>

#include "croquis/project/project.h"

namespace croquis {

/// The 18 points of OpenPose's COCO model, in its order: nose, neck, right shoulder, elbow, wrist, left shoulder,
/// elbow, wrist, right hip, knee, ankle, left hip, knee, ankle, right eye, left eye, right ear, left ear.
inline constexpr int kOpenPosePoints = 18;

/// Where they are on a humanoid in a pose, model space; a point whose bones are missing has none. Nose, eyes and ears
/// are placed by the head's size and turn, where the rig has no joints for them.
[[nodiscard]] std::array<std::optional<Vec3>, kOpenPosePoints> compute_open_pose(const Character& character,
                                                                                 const Pose& pose);

/// {"people": [{"pose_keypoints_2d": [x, y, confidence, ...]}], "width", "height"}: one entry for each humanoid on the
/// table; points outside the picture or missing are 0, 0, 0.
[[nodiscard]] std::string write_open_pose(const Project& project, const Camera& camera);

}  // namespace croquis
