// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "croquis/project/project.h"
#include "croquis/rig/body_line.h"

namespace croquis {

/// A way to read a stroke: settings in which body line, direction and depth are said.
struct StrokeReading {
  std::string label;  ///< the line's name, and how it is read: "trunk (backward)", "left_arm (depth 2)"
  BodyLine line;      ///< `joints` empty for a selection that is no path
  bool forward = true;
  double cost = 0.0;  ///< how implausible it is, the least first; comparable among the readings of one stroke
  StrokeSettings settings;
};

/// How a line read that way round is called: "trunk", "trunk (backward)".
[[nodiscard]] std::string reading_label(const BodyLine& line, bool forward);

/// What a stroke drawn over the pose that its actor holds may mean, likeliest first, at most `most`: the body lines
/// that it may be meant for (where its settings say body_line "auto" and name no joints; see rank_body_lines), either
/// way round (where they say direction "auto"), and, of the likeliest, the other depths that the picture leaves open.
/// Throws invalid_argument for a stroke that cannot be used and for settings that fit no joint.
[[nodiscard]] std::vector<StrokeReading> readings_of(const Project& project, const PlacedStroke& stroke, int most = 6);

/// Says for each of several strokes of one actor which body line it is for, where its settings say "auto": the line
/// that its name (the id in an SVG) names, else the one that it is likeliest meant for of those that share no bone with
/// another stroke's. Throws invalid_argument, naming the stroke, where none is left.
[[nodiscard]] std::vector<PlacedStroke> assign_body_lines(const Project& project, std::vector<PlacedStroke> strokes);

}  // namespace croquis
