// SPDX-License-Identifier: MIT
// M. Guay, M.-P. Cani, R. Ronfard, The Line of Action: an Intuitive Interface for Expressive Character Posing (2013)
// states the problem; what differs here is in docs/algorithms/line_of_action.md.
#include "croquis/posing/line_solver.h"

#include <algorithm>
#include <limits>

#include "croquis/base/text.h"
#include "croquis/posing/correspondence.h"
#include "croquis/posing/line_descent.h"
#include "croquis/posing/line_scene.h"
#include "croquis/posing/line_start.h"
#include "croquis/posing/redraw.h"

namespace croquis {
namespace {

struct Solution {
  LineState state;
  DescentReport report;
};

/// The best of a few starts, descended to the end.
Solution solve_scene(const LineScene& scene, LineDescent& descent, const LineSolverOptions& options) {
  const LineProblem& problem = scene.problem;
  std::vector<LineState> starts;
  Correspondence correspondence;
  std::vector<BoneSpan> bones;
  LineState state = problem.start_state();
  lay_on_chords(problem, {}, state);  // stepped by the lengths of the bones
  starts.push_back(state);
  for (const double depth : {1.0, 0.1}) {
    CorrespondenceWeights weights;
    weights.depth = depth;
    for (std::size_t i = 0; i < problem.paths.size(); ++i) {
      measure_bones(problem, problem.paths[i], bones);
      correspondence.solve(problem.paths[i].curve, bones, weights, state.along[i]);
    }
    lay_on_chords(problem, {}, state);
    starts.push_back(state);
  }

  Solution best;
  best.report.energy = std::numeric_limits<double>::infinity();
  for (LineState& start : starts) {
    const DescentReport report = descent.minimise(problem, start, {8, 1e-4});
    if (report.energy < best.report.energy) best = {start, report};
  }
  const int before = best.report.iterations;
  best.report = descent.minimise(problem, best.state, {options.iterations, 1e-6});
  best.report.iterations += before;
  return best;
}

}  // namespace

LineSolverResult solve_lines(const Skeleton& skeleton, const HumanoidMap& humanoid, const Pose& start,
                             const std::vector<LineInput>& inputs, const Camera& camera,
                             const LineSolverOptions& options) {
  LineScene scene(skeleton, humanoid, start, inputs, camera, options);
  LineDescent descent;
  descent.prepare(scene.problem);

  // Directions that are not given are tried both ways, one line at a time.
  Solution best;
  LineSolverResult result;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    result.forward.push_back(inputs[i].direction != LineInput::Direction::backward);
    if (!result.forward[i]) scene.set_stroke(i, inputs[i].stroke, true);
  }
  best = solve_scene(scene, descent, options);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (inputs[i].direction != LineInput::Direction::automatic) continue;
    scene.set_stroke(i, inputs[i].stroke, true);
    Solution turned = solve_scene(scene, descent, options);
    if (turned.report.energy < best.report.energy) {
      best = std::move(turned);
      result.forward[i] = false;
    } else {
      scene.set_stroke(i, inputs[i].stroke, false);
    }
  }

  take_share(scene.problem, redraw_share(scene.problem), best.state);
  scene.write_pose(best.state, result.pose);
  result.report.iterations = best.report.iterations;
  result.report.residual = best.report.energy;
  result.bone_length_drift = bone_length_drift(skeleton, start, result.pose);
  if (!scene.scales_evenly() && result.bone_length_drift > 1e-9) {
    result.report.status = "bone lengths changed by up to " + format_double(100.0 * result.bone_length_drift, 3) +
                           " %: a joint above them is scaled unevenly";
  } else if (!best.report.converged) {
    result.report.status = "stopped after " + std::to_string(best.report.iterations) + " iterations";
  }
  for (const LineInput& input : inputs) {
    result.fits.push_back(measure_fit(skeleton, result.pose, input.line, input.stroke, camera));
  }
  return result;
}

}  // namespace croquis
