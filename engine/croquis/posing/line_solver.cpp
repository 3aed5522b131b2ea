// SPDX-License-Identifier: MIT
// M. Guay, M.-P. Cani, R. Ronfard, The Line of Action: an Intuitive Interface for Expressive Character Posing (2013)
// states the problem; what differs here is in docs/algorithms/line_of_action.md.
#include "croquis/posing/line_solver.h"

#include <algorithm>
#include <memory>

#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/posing/line_scene.h"
#include "croquis/posing/line_search.h"
#include "croquis/posing/redraw.h"
#include "croquis/posing/standing.h"

namespace croquis {
namespace {

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

/// Whether a joint lies so far off its stroke that something must be in the way.
bool misses_line(const LineProblem& problem, const LineState& state) {
  constexpr double kFar = 0.05;  // of the line's length
  for (const LinePath& path : problem.paths) {
    for (const int node : path.nodes) {
      const Vec2 seen = problem.project(state.position[static_cast<std::size_t>(node)]);
      if ((path.curve.at(path.curve.nearest(seen)) - seen).norm() > kFar) return true;
    }
  }
  return false;
}

/// What the poses of one scene share.
struct Question {
  const Skeleton& skeleton;
  const Pose& start;
  const std::vector<LineInput>& inputs;
  const Camera& camera;
  const LineSolverOptions& options;
};

std::string status_of(const LineScene& scene, const LineSolution& solution, const LineSolverResult& result,
                      const std::string& missed) {
  if (!scene.scales_evenly() && result.bone_length_drift > 1e-6) {
    return "bone lengths changed by up to " + format_double(100.0 * result.bone_length_drift, 3) +
           " %: a joint above them is scaled unevenly";
  }
  if (!missed.empty()) return missed;
  if (!solution.report.converged) {
    return "stopped after " + std::to_string(solution.report.iterations) + " iterations";
  }
  return "ok";
}

/// A start pose that keeps its pins, its floor and its balance asks for nothing but the line.
bool start_is_free(const LineProblem& problem) { return problem.bodily_energy(problem.start_state()) < 1e-10; }

LineSolverResult finish(const LineScene& scene, LineSolution solution, const Question& question) {
  LineSolverResult result;
  if (start_is_free(scene.problem)) take_share(scene.problem, redraw_share(scene.problem), solution.state);
  std::vector<Crossing> crossings;
  clamp_to_limits(scene.problem, solution.state, crossings);  // a share of a turn may pass where neither end does
  scene.write_pose(solution.state, result.pose);
  result.forward = solution.forward;
  result.report.iterations = solution.report.iterations;
  result.report.residual = solution.report.energy;
  result.bone_length_drift = bone_length_drift(question.skeleton, question.start, result.pose);
  const std::string missed = missed_pin(question.skeleton, question.options.pins, result.pose, result.pins_missed);
  result.report.status = status_of(scene, solution, result, missed);
  result.limits_widened = scene.limits_widened();
  for (const int joint : find_limit_violations(question.options.limits, result.pose)) {
    if (scene.node_of(joint) >= 0) result.limit_violations.push_back(joint);
  }
  result.turned = turned_by(scene.problem, solution.state);
  result.overlap = scene.problem.overlap(solution.state) * scene.unit() / question.skeleton.extent();
  for (const LineInput& input : question.inputs) {
    result.fits.push_back(measure_fit(question.skeleton, result.pose, input.line, input.stroke, question.camera));
  }
  return result;
}

}  // namespace

std::vector<LineSolverResult> solve_alternatives(const Skeleton& skeleton, const HumanoidMap& humanoid,
                                                 const Pose& start, const std::vector<LineInput>& inputs,
                                                 const Camera& camera, const LineSolverOptions& options, int count) {
  if (count < 1) throw_invalid_argument("line solver: wanted " + std::to_string(count) + " poses, at least one");
  // Feet that stand go on standing, unless the line then is out of reach: a jump.
  LineSolverOptions held = options;
  for (const PosePin& pin : pin_standing_feet(skeleton, humanoid, start, inputs, options)) held.pins.push_back(pin);
  auto scene = std::make_unique<LineScene>(skeleton, humanoid, start, inputs, camera, held);
  auto search = std::make_unique<LineSearch>(*scene, inputs, options);
  LineSolution best = search->best();
  if (held.pins.size() > options.pins.size() && misses_line(scene->problem, best.state)) {
    auto free_scene = std::make_unique<LineScene>(skeleton, humanoid, start, inputs, camera, options);
    auto free_search = std::make_unique<LineSearch>(*free_scene, inputs, options);
    LineSolution leaping = free_search->best();
    if (!misses_line(free_scene->problem, leaping.state)) {
      search = std::move(free_search);
      scene = std::move(free_scene);
      best = std::move(leaping);
      held.pins = options.pins;
    }
  }
  const Question question{skeleton, start, inputs, camera, held};
  std::vector<LineSolution> others;
  if (count > 1) others = search->others(best);
  std::vector<LineSolverResult> results{finish(*scene, std::move(best), question)};
  for (LineSolution& other : others) {
    if (std::ssize(results) >= count) break;
    results.push_back(finish(*scene, std::move(other), question));
  }
  return results;
}

LineSolverResult solve_lines(const Skeleton& skeleton, const HumanoidMap& humanoid, const Pose& start,
                             const std::vector<LineInput>& inputs, const Camera& camera,
                             const LineSolverOptions& options) {
  return std::move(solve_alternatives(skeleton, humanoid, start, inputs, camera, options, 1).front());
}

}  // namespace croquis
