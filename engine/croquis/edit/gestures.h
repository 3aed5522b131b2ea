// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "croquis/edit/commands.h"
#include "croquis/math/camera.h"

namespace croquis {

/// A gesture that people learn to draw from, as strokes in a picture of 1000 x 1000: a figure of 700 stands with its
/// soles at (500, 900), seen from `view`. The first stroke is the line of action.
struct Gesture {
  std::string name;
  View view = View::front;
  bool on_floor = true;  ///< feet that no stroke moves stay on the floor
  std::string paths;     ///< SVG <path> elements whose ids are body lines
};

/// C, reversed C, S, lunge, jump, bow, throw, contrapposto.
[[nodiscard]] const std::vector<Gesture>& all_gestures();

/// An actor in a gesture, and the picture of it.
struct GesturePose {
  Project project;
  Camera camera;
  std::vector<LineReport> reports;  ///< one per stroke; the strokes are the project's
};

/// Poses the first actor of a project, alone. A humanoid starts relaxed and takes all strokes at the height of its own
/// hips and shoulders; any other body takes the line of action along its middle, in its shape alone, in the view that
/// shows most of it.
[[nodiscard]] GesturePose pose_gesture(const Project& project, const Gesture& gesture, int side_px);

}  // namespace croquis
