// SPDX-License-Identifier: MIT
#include "cli/commands/pose_lines.h"

#include "cli/files.h"
#include <algorithm>
#include <utility>

#include <CLI/CLI.hpp>

#include "croquis/base/error.h"
#include "croquis/edit/line_choice.h"
#include "croquis/edit/line_setup.h"

namespace croquis::cli {
namespace {

bool is_body_line(const Character& character, const std::string& name) {
  const std::vector<BodyLine> lines = standard_body_lines(character.skeleton, character.humanoid);
  return std::any_of(lines.begin(), lines.end(), [&](const BodyLine& line) { return line.name == name; });
}

/// The stroke as the chosen reading has it, and the readings beside that one.
std::vector<StrokeReading> read_otherwise(const Project& project, PlacedStroke& stroke, int chosen, int others) {
  std::vector<StrokeReading> readings = readings_of(project, stroke, std::max(chosen, others) + 1);
  if (chosen >= std::ssize(readings)) {
    throw_invalid_argument("--alternative " + std::to_string(chosen) + ": this line has " +
                           std::to_string(readings.size() - 1) + " beside the likeliest");
  }
  const auto reading = readings.begin() + chosen;
  stroke.settings = reading->settings;
  readings.erase(reading);
  if (std::ssize(readings) > others) readings.resize(static_cast<std::size_t>(others));
  return readings;
}

void add_way_options(CLI::App& command, StrokeSettings& settings, std::vector<CLI::Option*>& need_line) {
  const auto add = [&](const char* name, std::string& value, const char* text, const char* type) {
    CLI::Option* option = command.add_option(name, value, text)->type_name(type);
    need_line.push_back(option);
    return option;
  };
  add("--method", settings.method,
      "line solves for the pose, several strokes at once; rotation turns bone after bone along the stroke, "
      "rotation-index too but depends on the pen's speed; near and curvilinear stretch bones",
      "METHOD");
  add("--direction", settings.direction,
      "Which way the stroke runs: auto, forward (it starts at the first joint named), backward or, not for the method "
      "line, length (the side that fits in length)",
      "WAY");
  add("--root", settings.root,
      "The body's root: lock leaves it, free lets it turn and move as the line asks; of the other methods tangent "
      "turns "
      "it to the stroke's direction there (for line the same as free); auto is free for line, else lock",
      "MODE");
  add("--plane", settings.plane,
      "The plane the stroke lies in: free faces the camera, ground stands upright; not for the method line", "PLANE");
  add("--move", settings.move,
      "What moves: line, the joints that it holds, or body, what is above them too where the reach needs it", "WHAT");
  add("--length", settings.length,
      "Where stroke and body differ in length: fit (bones foreshorten along a shorter stroke, a longer one shrinks), "
      "scale (the stroke's shape at the body's size), trim (as much of a longer one as the body needs) or extend (a "
      "shorter one goes on straight)",
      "POLICY");
  need_line.push_back(command
                          .add_option("--exaggerate", settings.exaggerate,
                                      "The bends of the line times this: 0 straight, 1 as drawn, 2 twice as bent")
                          ->type_name("FACTOR"));
}

}  // namespace

void LineOptions::add_to(CLI::App& command) {
  CLI::Option* line =
      command
          .add_option("--line", file,
                      "The drawn line: an SVG in the picture's pixels; of several strokes each poses the body line "
                      "that its id names, or that it is likeliest meant for [default: none, the start pose is written]")
          ->type_name("FILE.svg");
  CLI::Option* named = command
                           .add_option("--joints", joints,
                                       "The joints to pose, in the order in which the stroke passes them; #index for a "
                                       "name that is not unique or has a comma [default: the character's default line]")
                           ->type_name("A,B,C,...");
  CLI::Option* body_line =
      command
          .add_option("--body-line", settings.body_line,
                      "The line to pose by its name (croquis info lists them), or auto: the one it is likeliest meant "
                      "for [default: the first]")
          ->type_name("NAME")
          ->excludes(named);
  std::vector<CLI::Option*> need_line{named, body_line};
  add_way_options(command, settings, need_line);
  need_line.push_back(command
                          .add_option("--alternatives", alternatives,
                                      "So many other readings of each stroke in the report: other body lines, "
                                      "directions, depths, the likeliest first")
                          ->type_name("N"));
  need_line.push_back(
      command.add_option("--alternative", alternative, "Take another reading of the stroke: 1 is the next likeliest")
          ->type_name("K"));
  command
      .add_option("--limits", limits,
                  "How far joints bend: anatomical, dancer, cartoon or none; holds for humanoids, others have none "
                  "[default: anatomical, or as the project says]")
      ->type_name("PRESET");
  command
      .add_option("--pin", pins,
                  "Holds a joint where it is, or at a point; may be given again for other joints [default: none]")
      ->type_name("JOINT[=x,y,z]")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command.add_flag("--floor,!--no-floor", floor,
                   "Nothing goes below the floor, feet that stand stay there [default: on for a humanoid]");
  command.add_flag("--balance", balance, "Keep the body's weight over what stands on the floor [default: off]");
  for (CLI::Option* option : need_line) option->needs(line);
}

void LineOptions::check() const {
  check_words(settings);
  if (!limits.empty()) check_limits(limits);
  const auto want = [](const char* option, int value, int most) {
    if (value >= 0 && value <= most) return;
    throw_invalid_argument(std::string(option) + " " + std::to_string(value) + ": wanted 0 to " + std::to_string(most));
  };
  want("--alternatives", alternatives, 20);
  want("--alternative", alternative, 20);
}

Project LineOptions::with_rules(Project project, bool is_new) const {
  Actor& actor = project.actors.front();
  const bool humanoid = actor.character->humanoid.is_humanoid();
  if (!limits.empty()) project.settings.limits = limits;
  if (is_new) project.settings.floor = humanoid;
  if (floor) project.settings.floor = *floor;
  if (balance) project.settings.balance = true;
  for (const std::string& pin : pins) {
    const Pin parsed = parse_pin(actor, pin);
    std::erase_if(actor.pins, [&](const Pin& other) { return other.joint == parsed.joint; });
    actor.pins.push_back(parsed);
  }
  return project;
}

PlacedLines read_lines(const LineOptions& options, const Project& project, const Camera& camera,
                       std::vector<std::string>& notices) {
  const Character& character = *project.actors.front().character;
  PlacedStroke placed;
  placed.camera = camera;
  placed.settings = options.settings;
  if (!options.joints.empty()) placed.settings.joints = parse_joint_list(character.skeleton, options.joints);
  const std::string& asked = options.settings.body_line;
  const bool said = !placed.settings.joints.empty() || (!asked.empty() && asked != "auto");
  std::vector<Stroke> strokes = load_strokes(options.file, camera);
  if (said && strokes.size() > 1) {
    notices.push_back(options.file + " holds " + std::to_string(strokes.size()) +
                      " strokes, of which 1 is used: --joints and --body-line are for one");
    strokes.resize(1);
  }
  PlacedLines lines;
  for (const Stroke& stroke : strokes) {
    placed.stroke = stroke;
    const bool named = is_body_line(character, stroke.name) && (asked.empty() || strokes.size() > 1);
    if (!said) placed.settings.body_line = named ? stroke.name : strokes.size() > 1 ? "auto" : asked;
    lines.strokes.push_back(placed);
  }
  if (options.alternatives == 0 && options.alternative == 0) return lines;
  if (lines.strokes.size() > 1) lines.strokes = assign_body_lines(project, std::move(lines.strokes));
  for (PlacedStroke& stroke : lines.strokes) {
    const int chosen = lines.alternatives.empty() ? options.alternative : 0;
    lines.alternatives.push_back(read_otherwise(project, stroke, chosen, options.alternatives));
  }
  return lines;
}

}  // namespace croquis::cli
