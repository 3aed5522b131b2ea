// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
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
  std::vector<double> pressure = {};           ///< per stroke point: how much the body heeds it there; empty: all 1
  double weight = 1.0;                         ///< of the whole line, against the others
};

/// What to do where stroke and body differ in length.
enum class LengthPolicy {
  fit,     ///< a shorter stroke stays where it was drawn, bones foreshorten; a longer one shrinks about its anchor
  scale,   ///< the stroke's shape at the body's size
  trim,    ///< the body takes as much of a longer stroke as it needs; a shorter one as in fit
  extend,  ///< a shorter stroke goes on straight, bones keep their length; a longer one as in fit
};

/// A joint that stays where it is said to, in model space, and turned as it is said to.
struct PosePin {
  int joint = -1;
  Vec3 position = Vec3::Zero();
  std::optional<Quat> rotation = {};
};

struct LineSolverOptions {
  LengthPolicy length = LengthPolicy::fit;
  bool lock_root = false;  ///< the root of the body stays; otherwise a line that holds it may turn and move it
  bool move_body = false;  ///< what is above the line may follow; otherwise it stays where it is
  /// Limits of joints (make_joint_limits), kept exactly. One that the start pose breaks is widened to hold it.
  std::vector<JointLimit> limits = {};
  std::vector<PosePin> pins = {};    ///< joints off the lines move with all joints between them and the line
  std::optional<double> floor = {};  ///< height (model y) below which nothing goes that was not below it at the start
  bool stand = true;          ///< with a floor: feet that stand on it, and that no line holds, stay where they stand
  bool balance = false;       ///< with a floor: the middle of the body's mass stays over what stands on it (soft)
  bool avoid_overlap = true;  ///< limbs, as capsules about the bones, do not pass through each other (soft)
  LineWeights weights = {};
  int iterations = 80;   ///< of the final descent, at most
  bool thorough = true;  ///< try bones that lie about in the picture both ways in depth; otherwise three times quicker
};

struct LineSolverResult {
  Pose pose;
  SolveReport report;                 ///< residual: the energy
  std::vector<bool> forward;          ///< per input: the stroke was taken to start at the line's first joint
  std::vector<LineFit> fits;          ///< per input
  double bone_length_drift = 0.0;     ///< relative; rounding only, unless `status` tells of uneven scale
  std::vector<int> limits_widened;    ///< joints whose limit the start pose breaks
  std::vector<int> limit_violations;  ///< joints of the result outside their (unwidened) limits
  std::vector<int> pins_missed;       ///< joints whose pin does not hold to 1e-4 of the body's size
  double overlap = 0.0;               ///< deepest that two limbs (capsules) pass into each other, in sizes of the body
  double turned = 0.0;  ///< how much the pose asks of the body: mean square of its weighted turns, radians^2
};

/// Poses a body so that its lines follow strokes: the line solver (docs/algorithms/line_of_action.md). `start` is the
/// pose drawn over; joints that no line holds keep their local rotations. Throws invalid_argument for an empty list, a
/// line that is no path, a stroke without length, numbers that are not finite, and lines whose bones all have no
/// length.
[[nodiscard]] LineSolverResult solve_lines(const Skeleton& skeleton, const HumanoidMap& humanoid, const Pose& start,
                                           const std::vector<LineInput>& inputs, const Camera& camera,
                                           const LineSolverOptions& options = {});

/// Up to `count` poses that answer the same strokes and differ in what a picture cannot say, the best first: which way
/// round each stroke runs (where that is automatic), and which bones come toward the viewer. The first is what
/// solve_lines returns; poses that differ nowhere by more than a few degrees count as one. Throws as solve_lines does.
[[nodiscard]] std::vector<LineSolverResult> solve_alternatives(const Skeleton& skeleton, const HumanoidMap& humanoid,
                                                               const Pose& start, const std::vector<LineInput>& inputs,
                                                               const Camera& camera, const LineSolverOptions& options,
                                                               int count);

}  // namespace croquis
