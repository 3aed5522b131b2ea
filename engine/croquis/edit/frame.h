// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "croquis/io/character_file.h"
#include "croquis/project/character.h"

namespace croquis {

/// The character as it stands in frame `frame`, counted from 0, of its first clip: `start` is that frame's pose, and
/// the parts' shape weights are that frame's. Throws invalid_argument if there is no clip or no such frame.
[[nodiscard]] Character character_at_frame(Character character, int frame);

/// The pose that `source` starts in, for a target with the same skeleton: as many joints with the same names under the
/// same parents (End Sites, which one program writes and another does not, may be missing on either side). Throws
/// invalid_argument that names the first joint that differs.
[[nodiscard]] Pose start_pose_of(const Character& source, const Character& target);

/// What a pose makes of each part's vertices, for a file that holds the bent mesh itself (PoseForm::baked).
[[nodiscard]] std::vector<BakedPart> bake_parts(const Character& character, const Pose& pose);

}  // namespace croquis
