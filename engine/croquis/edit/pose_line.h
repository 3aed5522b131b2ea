// SPDX-License-Identifier: MIT
#pragma once

#include "croquis/posing/extract_line.h"
#include "croquis/project/project.h"

namespace croquis {

/// The line that a pose has, as somebody would have drawn it.
struct PoseLine {
  Stroke stroke;  ///< named as the body line is, in the pixels of the view, from the line's first joint on
  BodyLine line;
  LineCharacter character;
};

/// Reads the line off the pose that an actor holds; `settings` say which (choose_line). Drawing the stroke again over
/// the same pose changes nothing. Throws invalid_argument for a selection that is no path, and as extract_line does.
[[nodiscard]] PoseLine read_pose_line(const Actor& actor, const StrokeSettings& settings, const Camera& camera);

}  // namespace croquis
