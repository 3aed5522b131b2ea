// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "croquis/math/camera.h"
#include "croquis/posing/line_fit.h"
#include "croquis/posing/line_problem.h"
#include "croquis/rig/body_line.h"
#include "croquis/rig/humanoid.h"
#include "croquis/rig/joint_limits.h"
#include "croquis/rig/pose.h"
#include "croquis/solve/solve_report.h"

namespace croquis {

/// A body line and the stroke that it shall take, in pixels of the view, points at equal arc lengths (clean_stroke).
struct LineInput {
  enum class Direction { automatic, forward, backward };

  BodyLine line;
  Polyline2 stroke;
  Direction direction = Direction::automatic;  ///< forward: the stroke starts at the line's first joint
  std::vector<double> importance = {};         ///< per joint of the line, 0 or more; empty: all 1
};

/// What to do where stroke and body differ in length.
enum class LengthPolicy {
  fit,     ///< a shorter stroke stays where it was drawn, bones foreshorten; a longer one shrinks about its anchor
  scale,   ///< the stroke's shape at the body's size
  trim,    ///< the body takes as much of a longer stroke as it needs; a shorter one as in fit
  extend,  ///< a shorter stroke goes on straight, bones keep their length; a longer one as in fit
};

/// A joint that stays where it is said to, in model space.
struct PosePin {
  int joint = -1;
  Vec3 position = Vec3::Zero();
};

struct LineSolverOptions {
  LengthPolicy length = LengthPolicy::fit;
  bool free_root = true;   ///< a line that holds the root of the body may turn and move it
  bool move_body = false;  ///< what is above the line may follow; otherwise it stays where it is
  /// Limits of joints (make_joint_limits), kept exactly. One that the start pose breaks is widened to hold it.
  std::vector<JointLimit> limits = {};
  std::vector<PosePin> pins = {};  ///< joints off the lines move with all joints between them and the line
  LineWeights weights = {};
  int iterations = 80;  ///< of the final descent, at most
};

struct LineSolverResult {
  Pose pose;
  SolveReport report;                 ///< residual: the energy
  std::vector<bool> forward;          ///< per input: the stroke was taken to start at the line's first joint
  std::vector<LineFit> fits;          ///< per input
  double bone_length_drift = 0.0;     ///< relative; rounding only, unless `status` tells of uneven scale
  std::vector<int> limits_widened;    ///< joints whose limit the start pose breaks
  std::vector<int> limit_violations;  ///< joints of the result outside their (unwidened) limits
  double turned = 0.0;  ///< how much the pose asks of the body: mean square of its weighted turns, radians^2
};

/// Poses a body so that its lines follow strokes: the line solver (docs/algorithms/line_of_action.md). `start` is the
/// pose drawn over; joints that no line holds keep their local rotations. Throws invalid_argument for an empty list, a
/// line that is no path, a stroke without length, numbers that are not finite, and lines whose bones all have no
/// length.
[[nodiscard]] LineSolverResult solve_lines(const Skeleton& skeleton, const HumanoidMap& humanoid, const Pose& start,
                                           const std::vector<LineInput>& inputs, const Camera& camera,
                                           const LineSolverOptions& options = {});

}  // namespace croquis
