// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "croquis/edit/commands.h"
#include "croquis/project/project.h"

/// What can be done to the strokes on the table: pure functions of the project, as in commands.h. Strokes are named by
/// their ids.
namespace croquis {

/// A stroke that was read in one of the ways it may be meant, and solved.
struct DrawnStroke {
  Project project;
  LineReport report;
  BodyLine line;                      ///< the line that was posed
  std::vector<std::string> readings;  ///< the labels of all readings, likeliest first
  int chosen = 0;  ///< which of them this is: the settings' `alternative`, as far as there are as many
};

/// The place of a stroke in `project.strokes`; throws invalid_argument if no stroke has that id.
[[nodiscard]] int stroke_index(const Project& project, int id);

/// Draws a new stroke over the pose that its actor holds.
[[nodiscard]] DrawnStroke draw_stroke(const Project& project, const PlacedStroke& stroke);

/// Puts other samples or settings into a stroke and solves it again: the joints of its line start from where they
/// stood when it was drawn, all others stay as they are now.
[[nodiscard]] DrawnStroke change_stroke(const Project& project, int id, const std::vector<StrokeSample>& samples,
                                        const StrokeSettings& settings);

[[nodiscard]] Project hide_stroke(const Project& project, int id, bool hidden);
/// Takes a stroke off the table; the pose stays.
[[nodiscard]] Project delete_stroke(const Project& project, int id);

}  // namespace croquis
