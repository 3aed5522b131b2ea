// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "croquis/edit/commands.h"
#include "croquis/edit/live_stroke.h"
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

/// What helps to solve a stroke faster; what comes of it is the same.
struct DrawHelp {
  LiveStroke* live = nullptr;  ///< one that may have followed the stroke already
  bool readings = true;        ///< list the other readings; otherwise the one that is taken alone
};

/// The place of a stroke in `project.strokes`; throws invalid_argument if no stroke has that id.
[[nodiscard]] int stroke_index(const Project& project, int id);

/// Draws a new stroke over the pose that its actor holds: followed as it was drawn where its settings say so
/// (is_followed_live), so that lifting the pen changes nothing, else as a whole.
[[nodiscard]] DrawnStroke draw_stroke(const Project& project, const PlacedStroke& stroke, const DrawHelp& help = {});

/// Puts other samples or settings into a stroke and solves it again: the joints that it moved start from where they
/// stood when it was drawn, all others stay as they are now. With other samples it keeps its body line and direction,
/// and is solved as a whole.
[[nodiscard]] DrawnStroke change_stroke(const Project& project, int id, const std::vector<StrokeSample>& samples,
                                        const StrokeSettings& settings, const DrawHelp& help = {});

[[nodiscard]] Project hide_stroke(const Project& project, int id, bool hidden);
/// Takes a stroke off the table; the pose stays.
[[nodiscard]] Project delete_stroke(const Project& project, int id);

}  // namespace croquis
