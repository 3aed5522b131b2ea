// SPDX-License-Identifier: MIT
#include "croquis/edit/commands.h"

#include <algorithm>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/stopwatch.h"
#include "croquis/base/text.h"
#include "croquis/edit/line_choice.h"
#include "croquis/edit/line_setup.h"
#include "croquis/edit/readings.h"
#include "croquis/project/joint_order.h"
#include "croquis/project/set_down.h"
#include "croquis/rig/joint_limits.h"
#include "croquis/sketch/stroke.h"

namespace croquis {
namespace {

struct Solved {
  Pose pose;
  std::vector<LineReport> reports;
};

Solved match_in_turn(const Actor& actor, const std::vector<PlacedStroke>& strokes,
                     const std::vector<LineChoice>& choices) {
  Solved solved{actor.pose, {}};
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    const MatchOptions options = match_options(strokes[i].settings);
    const Stopwatch watch;
    MatchResult match = match_line(actor.character->skeleton, solved.pose, choices[i].segments,
                                   clean_stroke(strokes[i].stroke), strokes[i].camera, options);
    solved.pose = std::move(match.pose);
    LineReport report;
    report.status = match.status;
    report.body_line = choices[i].line.name;
    report.forward = match.forward;
    report.fit = match.fit;
    report.bone_length_drift = match.bone_length_drift;
    report.solve_ms = watch.milliseconds();
    solved.reports.push_back(std::move(report));
  }
  return solved;
}

Solved solve_together(const Project& project, const Actor& actor, const std::vector<PlacedStroke>& strokes,
                      const std::vector<LineChoice>& choices) {
  const Character& character = *actor.character;
  const LineSolverOptions options = make_solver_options(project, actor, strokes.front().settings);
  const Stopwatch watch;
  std::vector<LineInput> inputs;
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    if (!is_line_method(strokes[i].settings)) {
      throw_invalid_argument("strokes of the method line cannot be mixed with strokes of another");
    }
    if (strokes[i].camera != strokes.front().camera) {
      throw_invalid_argument("strokes that are solved together must be drawn in one view");
    }
    if (choices[i].line.joints.empty()) {
      throw_invalid_argument("joints " + printable(choices[i].line.name) + ": the method line wants a path");
    }
    inputs.push_back(make_line_input(strokes[i], choices[i].line));
    settle_direction(inputs.back(), character.skeleton, actor.pose, strokes[i].camera);
  }
  int depth = 0;
  for (const PlacedStroke& stroke : strokes) depth = std::max(depth, stroke.settings.depth);
  std::vector<LineSolverResult> results = solve_alternatives(character.skeleton, character.humanoid, actor.pose, inputs,
                                                             strokes.front().camera, options, depth + 1);
  LineSolverResult result = std::move(results.back());
  const double spent = watch.milliseconds();
  Solved solved{std::move(result.pose), {}};
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    LineReport report;
    report.status = result.report.status;
    report.body_line = inputs[i].line.name;
    report.forward = result.forward[i];
    report.fit = result.fits[i];
    report.bone_length_drift = result.bone_length_drift;
    report.limits_widened = result.limits_widened;
    report.overlap = result.overlap;
    report.solve_ms = spent;
    solved.reports.push_back(std::move(report));
  }
  return solved;
}

}  // namespace

const Actor& actor_at(const Project& project, int actor) {
  if (actor < 0 || actor >= std::ssize(project.actors)) {
    throw_invalid_argument("actor " + std::to_string(actor) + ": the project has " +
                           std::to_string(project.actors.size()));
  }
  return project.actors[static_cast<std::size_t>(actor)];
}

Project add_character(const Project& project, std::shared_ptr<const Character> character) {
  if (!character) throw_invalid_argument("add_character: got no character");
  Project next = project;
  Actor actor;
  actor.pose = character->start;
  actor.character = std::move(character);
  actor.id = next.next_id++;
  next.actors.push_back(std::move(actor));
  next.check();
  return next;
}

std::shared_ptr<const Character> make_builtin_actor(const std::string& name, const Proportions& proportions) {
  return std::make_shared<const Character>(in_file_order(make_builtin_character(name, proportions)));
}

Project add_builtin_character(const Project& project, const std::string& name, const Proportions& proportions) {
  Project next = add_character(project, make_builtin_actor(name, proportions));
  Actor& actor = next.actors.back();
  actor.builtin = name;
  const Proportions designed;
  for (const auto& [key, member] : kProportions) {
    if (proportions.*member != designed.*member) actor.proportions[key] = proportions.*member;
  }
  return next;
}

Project set_down_beside(const Project& project) {
  if (project.actors.size() < 2) return project;
  Project next = project;
  Actor& newcomer = next.actors.back();
  Box others;
  double largest = 0.0;
  for (std::size_t i = 0; i + 1 < next.actors.size(); ++i) {
    others.extend(bounding_box(*next.actors[i].character, next.actors[i].pose));
    largest = std::max(largest, next.actors[i].character->skeleton.extent());
  }
  const Box own = bounding_box(*newcomer.character, newcomer.pose);
  if (others.isEmpty() || own.isEmpty()) return project;
  const double gap = 0.08 * (largest + newcomer.character->skeleton.extent());  // joints are inside the flesh
  newcomer.place = (others.max().x() + gap - own.min().x()) * Vec3::UnitX();
  auto moved = std::make_shared<const Character>(set_down(*newcomer.character, newcomer.place));
  newcomer.pose = moved->start;
  newcomer.character = std::move(moved);
  next.check();
  return next;
}

Project set_pose(const Project& project, int actor, Pose pose) {
  (void)actor_at(project, actor);
  Project next = project;
  next.actors[static_cast<std::size_t>(actor)].pose = std::move(pose);
  next.check();
  return next;
}

PosedLines pose_along_lines(const Project& project, const std::vector<PlacedStroke>& given) {
  if (given.empty()) throw_invalid_argument("pose_along_lines: got no stroke");
  const int index = given.front().actor;
  const Actor& actor = actor_at(project, index);
  const Character& character = *actor.character;
  for (const PlacedStroke& stroke : given) {
    if (stroke.actor != index) throw_invalid_argument("pose_along_lines: the strokes are of several actors");
    stroke.camera.check();
    check_stroke(stroke.stroke, stroke.camera);
    check_words(stroke.settings);
  }
  const std::vector<PlacedStroke> strokes = assign_body_lines(project, given);
  std::vector<LineChoice> choices;
  for (const PlacedStroke& stroke : strokes) choices.push_back(choose_line(character, stroke.settings));
  Solved solved = is_line_method(strokes.front().settings) ? solve_together(project, actor, strokes, choices)
                                                           : match_in_turn(actor, strokes, choices);
  TableSettings judged = project.settings;
  if (judged.limits == "none") judged.limits = "anatomical";
  const std::vector<int> violations = find_limit_violations(limits_of(judged, character), solved.pose);
  for (LineReport& report : solved.reports) report.limit_violations = violations;

  PosedLines result{set_pose(project, index, std::move(solved.pose)), std::move(solved.reports)};
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    PlacedStroke kept = strokes[i];
    kept.id = result.project.next_id++;
    kept.before = actor.pose;
    kept.line = choices[i].line;
    result.project.strokes.push_back(std::move(kept));
  }
  return result;
}

Project set_view(const Project& project, const std::string& name, const Camera& camera) {
  camera.check();
  Project next = project;
  const auto old =
      std::find_if(next.views.begin(), next.views.end(), [&](const NamedView& v) { return v.name == name; });
  if (old != next.views.end()) {
    old->camera = camera;
  } else {
    next.views.push_back({name, camera});
  }
  return next;
}

}  // namespace croquis
