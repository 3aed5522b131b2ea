// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "croquis/body/body.h"
#include "croquis/project/project.h"
#include "croquis/sketch/stroke.h"

namespace croquis::cli {

/// All of a project file; for any other file, or the name of a built-in character, a project that holds it alone (a
/// file of such a name is reached as ./name).
[[nodiscard]] Project load_project(const std::string& file, const Proportions& proportions = {});

/// The project with its first actor as in frame `frame` of its first clip, counted from 0.
[[nodiscard]] Project at_frame(Project project, int frame, const std::string& file);

[[nodiscard]] Camera load_camera(const std::string& file);
[[nodiscard]] std::vector<Stroke> load_strokes(const std::string& file, const Camera& camera);

/// "FILE:N" is frame N of FILE, "FILE" the pose the file opens in; a last colon followed by digits makes the
/// difference.
[[nodiscard]] Character load_start(const std::string& file_and_frame);

}  // namespace croquis::cli
