// SPDX-License-Identifier: MIT
#include "croquis/posing/line_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "croquis/math/rotation.h"
#include "croquis/posing/line_start.h"

namespace croquis {
namespace {

/// How far the body's upright has tipped, in half turns: nobody stands on the head unless the line leaves no choice.
double tipped(const LineProblem& problem, const LineState& state) {
  for (std::size_t i = 0; i < problem.nodes.size(); ++i) {
    if (problem.nodes[i].column < 0) continue;
    const double cosine = problem.body.up.dot(state.frame[i] * problem.body.up);
    return std::acos(std::clamp(cosine, -1.0, 1.0)) / kPi;
  }
  return 0.0;
}

/// Mean distance of the strokes from the lines as they stand in the start pose, parts of equal length compared.
double drawn_away(const LineProblem& problem) {
  constexpr int kParts = 16;
  double sum = 0.0;
  for (const LinePath& path : problem.paths) {
    std::vector<Vec2> joints;
    for (const int node : path.nodes) {
      joints.push_back(problem.project(problem.nodes[static_cast<std::size_t>(node)].start));
    }
    const Polyline2 own(std::move(joints));
    for (int i = 0; i <= kParts; ++i) {
      const double part = static_cast<double>(i) / kParts;
      sum += (path.curve.at(part * path.curve.length()) - own.at(part * own.length())).norm();
    }
  }
  return sum / (static_cast<double>(problem.paths.size()) * (kParts + 1));
}

constexpr double kPinnedBend = 0.2;  // radians, of straight limbs between a line and a pin

/// The largest distance between the same joints of two states, problem units.
double apart(const LineState& a, const LineState& b) {
  double most = 0.0;
  for (std::size_t i = 0; i < a.position.size(); ++i) most = std::max(most, (a.position[i] - b.position[i]).norm());
  return most;
}

/// How far joints are from where they should be, root mean square, in lengths of the line.
double miss(const LineProblem& problem, const LineSolution& solution) {
  double joints = 0.0;
  for (const LinePath& path : problem.paths) joints += static_cast<double>(path.nodes.size());
  return std::sqrt(2.0 * solution.report.energy / joints);
}

void soften(LineWeights& weights) {
  weights.pin *= 0.005;
  weights.pin_turn *= 0.05;
  weights.floor *= 0.02;
}

}  // namespace

double turned_by(const LineProblem& problem, const LineState& state) {
  double sum = 0.0;
  int turning = 0;
  for (std::size_t i = 0; i < problem.nodes.size(); ++i) {
    const LineNode& node = problem.nodes[i];
    if (node.column < 0) continue;
    sum += (node.stiffness * rotation_to_vector(state.turn[i])).squaredNorm();
    ++turning;
  }
  return turning > 0 ? sum / turning : 0.0;
}

LineSearch::LineSearch(LineScene& scene, const std::vector<LineInput>& inputs, const LineSolverOptions& options)
    : scene_(scene), inputs_(inputs), iterations_(options.iterations), thorough_(options.thorough) {
  descent_.prepare(scene.problem);
  for (const LineInput& input : inputs) forward_.push_back(input.direction != LineInput::Direction::backward);
  std::vector<bool> wanted = forward_;
  forward_.assign(inputs.size(), true);
  set_forward(wanted);
}

void LineSearch::set_forward(const std::vector<bool>& forward) {
  for (std::size_t i = 0; i < forward.size(); ++i) {
    if (forward[i] != forward_[i]) scene_.set_stroke(i, inputs_[i].stroke.points(), !forward[i]);
  }
  forward_ = forward;
}

void LineSearch::judge(LineSolution& solution) const {
  solution.cost = 10.0 * miss(scene_.problem, solution) + std::sqrt(turned_by(scene_.problem, solution.state)) +
                  tipped(scene_.problem, solution.state) + 6.0 * drawn_away(scene_.problem);
  solution.forward = forward_;
}

LineSolution LineSearch::descend(LineState start) {
  LineSolution solution{std::move(start), {}, {}, 0.0};
  LineWeights& weights = scene_.problem.weights;
  // What must hold is made stiff last: a body finds its way around pins sooner while they give a little.
  if (!scene_.problem.pins.empty() || !scene_.problem.body.floor.empty()) {
    const LineWeights given = weights;
    soften(weights);
    solution.report = descent_.minimise(scene_.problem, solution.state, {iterations_, 1e-5});
    weights = given;
  }
  const int before = solution.report.iterations;
  solution.report = descent_.minimise(scene_.problem, solution.state, {iterations_, 1e-9});
  solution.report.iterations += before;
  judge(solution);
  return solution;
}

/// The best of a few starts, descended to the end.
LineSolution LineSearch::solve_one_way() {
  const LineProblem& problem = scene_.problem;
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
  // A pose drawn over that is nearly right already is the best start of all.
  starts.push_back(problem.start_state());

  LineState best;
  DescentReport found;
  found.energy = std::numeric_limits<double>::infinity();
  const LineWeights given = scene_.problem.weights;
  soften(scene_.problem.weights);
  for (LineState& start : starts) {
    bend_pinned_hinges(problem, start, kPinnedBend);
    const DescentReport report = descent_.minimise(problem, start, {thorough_ ? 20 : 8, 1e-4});
    if (!(report.energy < found.energy)) continue;
    best = start;
    found = report;
  }
  scene_.problem.weights = given;
  LineSolution solution = descend(std::move(best));
  solution.report.iterations += found.iterations;
  return thorough_ ? turn_over(solution) : solution;
}

/// The solution, or what comes of it when some of its bones come toward the viewer that went away, whichever is better:
/// a bone that lies in the picture is a saddle between the two, and descent alone does not choose.
LineSolution LineSearch::turn_over(const LineSolution& solution) {
  constexpr double kHopeful = 1.5;  // times the energy, after a few steps
  LineSolution best = solution;
  for (const auto& guess : depth_guesses(solution.state)) {
    LineState state = solution.state;
    lay_on_chords(scene_.problem, guess, state);
    bend_pinned_hinges(scene_.problem, state, kPinnedBend);
    const DescentReport report = descent_.minimise(scene_.problem, state, {12, 1e-4});
    if (report.energy > kHopeful * best.report.energy) continue;
    LineSolution other = descend(std::move(state));
    if (other.report.energy < 0.999 * best.report.energy) best = std::move(other);
  }
  return best;
}

LineSolution LineSearch::solve_way(const std::vector<bool>& forward) {
  set_forward(forward);
  const auto known =
      std::find_if(ways_.begin(), ways_.end(), [&](const LineSolution& way) { return way.forward == forward; });
  return known != ways_.end() ? *known : ways_.emplace_back(solve_one_way());
}

LineSolution LineSearch::best() {
  LineSolution best = solve_way(forward_);
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    if (inputs_[i].direction != LineInput::Direction::automatic) continue;
    std::vector<bool> turned = best.forward;
    turned[i] = !turned[i];
    LineSolution other = solve_way(turned);
    if (other.cost < best.cost) best = std::move(other);
  }
  set_forward(best.forward);
  return best;
}

/// Other ways in which the bones of a state may stand in depth: the whole line turned over, and each limb's bones, or
/// runs of neighbouring bones, that stand out of the picture.
std::vector<std::vector<std::vector<int>>> LineSearch::depth_guesses(const LineState& state) const {
  constexpr double kFlat = 0.2;  // parts of its length by which a bone stands out
  constexpr std::size_t kMost = 12;
  const LineProblem& problem = scene_.problem;
  std::vector<std::vector<int>> now;
  for (const LinePath& path : problem.paths) {
    std::vector<int>& signs = now.emplace_back();
    for (std::size_t k = 0; k < path.bones.size(); ++k) {
      const double z = state.position[static_cast<std::size_t>(path.nodes[k + 1])].z() -
                       state.position[static_cast<std::size_t>(path.nodes[k])].z();
      signs.push_back(z < 0.0 ? -1 : 1);
    }
  }
  std::vector<std::vector<std::vector<int>>> guesses;
  for (std::size_t i = 0; i < now.size(); ++i) {
    const LinePath& path = problem.paths[i];
    const auto add = [&](std::size_t from, std::size_t to) {
      if (guesses.size() >= kMost) return;
      auto& guess = guesses.emplace_back(now);
      for (std::size_t k = from; k < to; ++k) guess[i][k] = -guess[i][k];
    };
    add(0, now[i].size());
    for (std::size_t k = 0; k < path.bones.size();) {
      std::size_t end = k + 1;
      while (end < path.bones.size() && now[i][end] == now[i][k]) ++end;
      double deepest = 0.0;
      for (std::size_t b = k; b < end; ++b) {
        const double z = state.position[static_cast<std::size_t>(path.nodes[b + 1])].z() -
                         state.position[static_cast<std::size_t>(path.nodes[b])].z();
        deepest = std::max(deepest, std::abs(z) / std::max(path.bones[b], 1e-9));
      }
      if (deepest > kFlat && end - k < path.bones.size()) add(k, end);
      k = end;
    }
  }
  return guesses;
}

std::vector<LineSolution> LineSearch::others(const LineSolution& best) {
  constexpr double kSame = 0.03, kMissed = 0.03;  // of the line's length
  std::vector<LineSolution> found;
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    if (inputs_[i].direction != LineInput::Direction::automatic) continue;
    std::vector<bool> turned = best.forward;
    turned[i] = !turned[i];
    found.push_back(solve_way(turned));
  }
  set_forward(best.forward);
  const auto try_guess = [&](const std::vector<std::vector<int>>& guess, LineState state) {
    lay_on_chords(scene_.problem, guess, state);
    bend_pinned_hinges(scene_.problem, state, kPinnedBend);
    found.push_back(descend(std::move(state)));
  };
  for (const auto& guess : depth_guesses(best.state)) try_guess(guess, best.state);
  // All bones foreshortened alike, toward the viewer and away.
  for (const int sign : {1, -1}) {
    std::vector<std::vector<int>> guess;
    for (const LinePath& path : scene_.problem.paths) guess.emplace_back(path.bones.size(), sign);
    try_guess(guess, scene_.problem.start_state());
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const LineSolution& a, const LineSolution& b) { return a.cost < b.cost; });
  std::vector<LineSolution> distinct;
  for (LineSolution& solution : found) {
    const auto same = [&](const LineSolution& other) { return apart(other.state, solution.state) < kSame; };
    if (miss(scene_.problem, solution) > miss(scene_.problem, best) + kMissed) continue;  // stuck at a limit
    if (same(best) || std::any_of(distinct.begin(), distinct.end(), same)) continue;
    distinct.push_back(std::move(solution));
  }
  return distinct;
}

}  // namespace croquis
