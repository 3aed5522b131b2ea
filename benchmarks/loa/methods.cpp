// SPDX-License-Identifier: MIT
#include "loa/methods.h"

#include "croquis/posing/line_descent.h"
#include "croquis/posing/line_matching.h"
#include "croquis/posing/line_scene.h"
#include "croquis/posing/line_start.h"

namespace croquis::loa {
namespace {

Method matching(MatchMethod method, bool direction_known) {
  return {
      std::string(to_string(method)), [=](const Draw& draw) {
        MatchOptions options;
        options.method = method;
        options.root = RootMode::tangent;
        options.direction = direction_known ? DirectionRule::forward : DirectionRule::scalar_product;
        return match_line(draw.clip->character.skeleton, draw.start, draw.line, draw.stroke, draw.camera, options).pose;
      }};
}

enum class Told { correspondence, depth };

/// The line solver's energy and descent, told what a line does not say.
Pose solve_told(const Draw& draw, Told told) {
  const Skeleton& skeleton = draw.clip->character.skeleton;
  const LineInput input{draw.line, draw.stroke, LineInput::Direction::forward};
  LineScene scene(skeleton, draw.clip->character.humanoid, draw.start, {input}, draw.camera,
                  solver_options(draw, LimitPreset::none));
  LinePath& path = scene.problem.paths.front();
  LineState state = scene.problem.start_state();
  const std::vector<Vec3> truth = compute_positions(skeleton, draw.truth);
  const Affine view = draw.camera.view_from_world();
  std::vector<int> signs;
  for (std::size_t k = 0; k + 1 < draw.line.joints.size(); ++k) {
    const Vec3 bone =
        truth[static_cast<std::size_t>(draw.line.joints[k + 1])] - truth[static_cast<std::size_t>(draw.line.joints[k])];
    const double depth = (view.linear() * bone).z() / scene.unit();
    signs.push_back(depth < 0.0 ? -1 : 1);
    if (told == Told::depth) path.start_depth[k] = depth;
  }
  if (told == Told::depth) {
    scene.problem.weights.depth = 1.0;
    Correspondence correspondence;
    std::vector<BoneSpan> bones;
    measure_bones(scene.problem, path, bones);
    correspondence.solve(path.curve, bones, {}, state.along.front());
    lay_on_chords(scene.problem, std::vector<std::vector<int>>{signs}, state);
  } else {
    path.fixed = true;
    for (std::size_t k = 0; k < path.nodes.size(); ++k) {
      state.along.front()[k] = draw.truth_along[k] * path.curve.length();
    }
    lay_on_chords(scene.problem, {}, state);
  }
  LineDescent descent;
  descent.prepare(scene.problem);
  (void)descent.minimise(scene.problem, state, {80, 1e-6});
  Pose pose;
  scene.write_pose(state, pose);
  return pose;
}

}  // namespace

LineSolverOptions solver_options(const Draw& draw, LimitPreset limits) {
  LineSolverOptions options;
  options.move_body = true;
  const Character& character = draw.clip->character;
  options.limits = make_joint_limits(character.skeleton, character.humanoid, limits, draw.clip->neutral);
  return options;
}

LineSolverResult solve_draw(const Draw& draw, bool direction_known, const LineSolverOptions& options) {
  LineInput input{draw.line, draw.stroke};
  if (direction_known) input.direction = LineInput::Direction::forward;
  return solve_lines(draw.clip->character.skeleton, draw.clip->character.humanoid, draw.start, {input}, draw.camera,
                     options);
}

std::vector<Method> all_methods(bool direction_known) {
  std::vector<Method> methods;
  methods.push_back({"start", [](const Draw& draw) { return draw.start; }});
  for (const auto method :
       {MatchMethod::near, MatchMethod::curvilinear, MatchMethod::rotation_index, MatchMethod::rotation}) {
    methods.push_back(matching(method, direction_known));
  }
  for (const auto& [name, limits] :
       {std::pair("line", LimitPreset::none), std::pair("line, anatomical", LimitPreset::anatomical)}) {
    methods.push_back(
        {name, [=](const Draw& draw) { return solve_draw(draw, direction_known, solver_options(draw, limits)).pose; }});
  }
  methods.push_back({"told where", [](const Draw& draw) { return solve_told(draw, Told::correspondence); }});
  methods.push_back({"told the depth", [](const Draw& draw) { return solve_told(draw, Told::depth); }});
  return methods;
}

}  // namespace croquis::loa
