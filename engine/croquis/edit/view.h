// SPDX-License-Identifier: MIT
#pragma once

#include "croquis/math/camera.h"
#include "croquis/project/project.h"

namespace croquis {

/// The box around everything that is seen of a character in a pose: its skinned vertices and its bones.
[[nodiscard]] Box posed_box(const Character& character, const Pose& pose);

/// A named view of the actors as they stand, all of them in the picture with a 10 % margin; `front` is the first
/// actor's front. The views of every face are these. Throws invalid_argument if there is no actor.
[[nodiscard]] Camera make_named_view(const std::vector<Actor>& actors, View view, int width_px, int height_px);

}  // namespace croquis
