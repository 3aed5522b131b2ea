// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "croquis/posing/correspondence.h"
#include "croquis/posing/line_descent.h"
#include "croquis/posing/line_scene.h"

namespace croquis {

struct LineSolution {
  LineState state;
  DescentReport report;
  std::vector<bool> forward;  ///< per path: the stroke starts at the line's first joint
  double cost = 0.0;          ///< how implausible: how far off the strokes, how much is asked of the body
};

/// How much a state asks of the body: mean square of its weighted turns, radians^2.
[[nodiscard]] double turned_by(const LineProblem& problem, const LineState& state);

/// Searches the poses that answer a scene's strokes: a few closed-form starts, descended.
class LineSearch {
 public:
  LineSearch(LineScene& scene, const std::vector<LineInput>& inputs, const LineSolverOptions& options);

  /// The best pose; strokes whose direction is automatic are tried both ways, one after the other.
  [[nodiscard]] LineSolution best();
  /// Poses that differ from it in direction or depth and from each other, the most plausible first.
  [[nodiscard]] std::vector<LineSolution> others(const LineSolution& best);

 private:
  void set_forward(const std::vector<bool>& forward);
  [[nodiscard]] LineSolution descend(LineState start);
  [[nodiscard]] LineSolution solve_one_way();
  [[nodiscard]] LineSolution turn_over(const LineSolution& solution);
  [[nodiscard]] LineSolution solve_way(const std::vector<bool>& forward);
  void judge(LineSolution& solution) const;
  [[nodiscard]] std::vector<std::vector<std::vector<int>>> depth_guesses(const LineState& state) const;

  LineScene& scene_;
  const std::vector<LineInput>& inputs_;
  int iterations_;
  bool thorough_;
  LineDescent descent_;
  std::vector<bool> forward_;
  std::vector<LineSolution> ways_;  ///< solved already, each with its directions
};

}  // namespace croquis
