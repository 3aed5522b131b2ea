// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "croquis/posing/humanoid_pose.h"
#include "croquis/project/character.h"

namespace croquis {

/// A pose as JSON that travels between characters. Of a humanoid: {"bones": {"leftUpperArm": [x,y,z,w], ...}, "hips":
/// [x,y,z]} (see posing/humanoid_pose.h); "grounded": true puts the lowest joint where the lowest is at rest. Of any
/// other: {"joints": {"name": [x,y,z,w], ...}}, its local rotations.
[[nodiscard]] std::string write_pose_text(const Character& character, const Pose& pose);
[[nodiscard]] std::string write_pose_text(const HumanoidPose& pose, bool grounded);

/// The pose on `character`, over `base` where the text is silent. Throws bad_file with the JSON pointer; bones and
/// joints that this character lacks are passed over, but a text of which nothing fits is an error.
[[nodiscard]] Pose read_pose_text(std::string_view text, const Character& character, const Pose& base);

/// The pose of the shelf (body/pose_shelf.h) with that name, capitals aside and "-" for a space if one likes, on a
/// humanoid; nothing if there is none.
[[nodiscard]] std::optional<Pose> find_shelf_pose(const Character& character, std::string_view name);

}  // namespace croquis
