// SPDX-License-Identifier: MIT
// M. Guay, M.-P. Cani, R. Ronfard, The Line of Action: an Intuitive Interface for Expressive Character Posing (2013)
// states the problem; what differs here is in docs/algorithms/line_of_action.md.
#include "croquis/posing/line_solver.h"

#include <algorithm>
#include <limits>

#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/math/rotation.h"
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
  const bool open =
      std::any_of(problem.paths.begin(), problem.paths.end(), [](const LinePath& p) { return !p.hold_last; });
  for (const double depth : {1.0, 0.1}) {
    if (open) break;
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
  // A pose drawn over that is nearly right already is the best start of all.
  state = problem.start_state();
  const DescentReport from_start = descent.minimise(problem, state, {8, 1e-4});
  if (from_start.energy < best.report.energy) best = {state, from_start};
  const int before = best.report.iterations;
  best.report = descent.minimise(problem, best.state, {options.iterations, 1e-6});
  best.report.iterations += before;
  return best;
}

/// The joint that misses its pin farthest, by more than 1e-4 of the body's size, in words; empty if all hold.
std::string missed_pin(const Skeleton& skeleton, const std::vector<PosePin>& pins, const Pose& pose,
                       std::vector<int>& missed) {
  const std::vector<Vec3> positions = compute_positions(skeleton, pose);
  double worst = 1e-4 * skeleton.extent();
  std::string text;
  for (const PosePin& pin : pins) {
    const double miss = (positions[static_cast<std::size_t>(pin.joint)] - pin.position).norm();
    if (miss > 1e-4 * skeleton.extent()) missed.push_back(pin.joint);
    if (miss <= worst) continue;
    worst = miss;
    text = "joint " + printable(skeleton.reference(pin.joint)) + " could not be held: it is " + format_double(miss, 3) +
           " from its pin";
  }
  return text;
}

void fill_report(const LineScene& scene, const Solution& solution, const std::vector<LineInput>& inputs,
                 const LineSolverOptions& options, const Skeleton& skeleton, const Pose& start, const Camera& camera,
                 LineSolverResult& result) {
  result.report.iterations = solution.report.iterations;
  result.report.residual = solution.report.energy;
  result.bone_length_drift = bone_length_drift(skeleton, start, result.pose);
  const std::string missed = missed_pin(skeleton, options.pins, result.pose, result.pins_missed);
  if (!scene.scales_evenly() && result.bone_length_drift > 1e-9) {
    result.report.status = "bone lengths changed by up to " + format_double(100.0 * result.bone_length_drift, 3) +
                           " %: a joint above them is scaled unevenly";
  } else if (!missed.empty()) {
    result.report.status = missed;
  } else if (!solution.report.converged) {
    result.report.status = "stopped after " + std::to_string(solution.report.iterations) + " iterations";
  }
  result.limits_widened = scene.limits_widened();
  for (const int joint : find_limit_violations(options.limits, result.pose)) {
    if (scene.node_of(joint) >= 0) result.limit_violations.push_back(joint);
  }
  int turning = 0;
  for (std::size_t i = 0; i < scene.problem.nodes.size(); ++i) {
    const LineNode& node = scene.problem.nodes[i];
    if (node.column < 0) continue;
    result.turned += (node.stiffness * rotation_to_vector(solution.state.turn[i])).squaredNorm();
    ++turning;
  }
  if (turning > 0) result.turned /= turning;
  for (const LineInput& input : inputs) {
    result.fits.push_back(measure_fit(skeleton, result.pose, input.line, input.stroke, camera));
  }
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
    if (!result.forward[i]) scene.set_stroke(i, inputs[i].stroke.points(), true);
  }
  best = solve_scene(scene, descent, options);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (inputs[i].direction != LineInput::Direction::automatic) continue;
    scene.set_stroke(i, inputs[i].stroke.points(), true);
    Solution turned = solve_scene(scene, descent, options);
    if (turned.report.energy < best.report.energy) {
      best = std::move(turned);
      result.forward[i] = false;
    } else {
      scene.set_stroke(i, inputs[i].stroke.points(), false);
    }
  }

  take_share(scene.problem, redraw_share(scene.problem), best.state);
  std::vector<Crossing> crossings;
  clamp_to_limits(scene.problem, best.state, crossings);  // a share of a turn may pass where neither end does
  scene.write_pose(best.state, result.pose);
  fill_report(scene, best, inputs, options, skeleton, start, camera, result);
  return result;
}

std::vector<LineSolverResult> solve_alternatives(const Skeleton& skeleton, const HumanoidMap& humanoid,
                                                 const Pose& start, const std::vector<LineInput>& inputs,
                                                 const Camera& camera, const LineSolverOptions& options, int count) {
  if (count < 1) throw_invalid_argument("line solver: wanted " + std::to_string(count) + " poses, at least one");
  return {solve_lines(skeleton, humanoid, start, inputs, camera, options)};
}

}  // namespace croquis
