// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "croquis/body/body.h"
#include "croquis/posing/line_fit.h"
#include "croquis/project/project.h"

/// What can be done to a project, each a pure function of it: the command line, the studio and a script run these very
/// ones. All throw invalid_argument where an index or a size does not fit, and leave the project they were given as it
/// is.
namespace croquis {

/// The actor of that index.
[[nodiscard]] const Actor& actor_at(const Project& project, int actor);

/// Adds a character, standing as it starts.
[[nodiscard]] Project add_character(const Project& project, std::shared_ptr<const Character> character);

/// A built-in character as the table holds it: with its joints in the order in which a file gives them back, so that
/// commands and body lines mean the same after a project has been saved and opened.
[[nodiscard]] std::shared_ptr<const Character> make_builtin_actor(const std::string& name,
                                                                  const Proportions& proportions = {});

/// Adds a built-in character, and keeps its name and those of its proportions that are not as designed.
[[nodiscard]] Project add_builtin_character(const Project& project, const std::string& name,
                                            const Proportions& proportions = {});

/// The newest actor moved along x until it stands clear of the others, if there are any.
[[nodiscard]] Project set_down_beside(const Project& project);

[[nodiscard]] Project set_pose(const Project& project, int actor, Pose pose);

/// What is to be said of a pose that a line gave.
struct LineReport {
  std::string status = "ok";       ///< "ok", or one sentence on what is not as asked
  std::string body_line;           ///< its name, or its joints
  bool forward = true;             ///< the stroke was taken to start at the line's first joint
  LineFit fit;                     ///< pixels of the stroke's view
  double bone_length_drift = 0.0;  ///< relative to the pose before
  /// Joints bent beyond the table's limits (without limits: beyond a human's); none of what is no humanoid.
  std::vector<int> limit_violations;
  std::vector<int> limits_widened;  ///< joints that the pose drawn over bends beyond them: they may stay as they are
  double overlap = 0.0;             ///< deepest that two limbs pass into each other, in sizes of the body
  double solve_ms = 0.0;            ///< from the stroke as drawn to the pose
};

struct PosedLines {
  Project project;
  std::vector<LineReport> reports;  ///< one per stroke
};

/// Poses an actor along strokes, from the pose that it holds, and keeps the strokes in the project. Strokes of the
/// method "line" are one problem, with the table's settings and the actor's pins, and are solved together (root, length
/// and move as the first says); those of the other methods are matched one after another. Body lines "auto" are found
/// (assign_body_lines).
/// Throws invalid_argument for no stroke, for one that cannot be used (check_stroke), for settings that fit no joint
/// (choose_line), and for strokes of several actors, or of the method "line" and others or in different views.
[[nodiscard]] PosedLines pose_along_lines(const Project& project, const std::vector<PlacedStroke>& strokes);

/// Keeps a camera under a name; one of that name is replaced.
[[nodiscard]] Project set_view(const Project& project, const std::string& name, const Camera& camera);

}  // namespace croquis
