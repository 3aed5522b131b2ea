// SPDX-License-Identifier: MIT
#include "cli/command.h"
#include "cli/commands/pose_lines.h"
#include "cli/commands/pose_report.h"
#include "cli/files.h"
#include "cli/options.h"
#include "cli/outputs.h"
#include "cli/pictures.h"
#include "cli/progress.h"
#include "cli/writing.h"
#include <iostream>
#include <memory>
#include <optional>
#include <utility>

#include <CLI/CLI.hpp>

#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/edit/commands.h"
#include "croquis/edit/frame.h"
#include "croquis/edit/pose_text.h"

namespace croquis::cli {
namespace {

struct PoseArguments {
  std::string rig;
  LineOptions line;
  ViewOptions view;
  std::string start;
  std::string form = "pose";
  bool add_positions = false;
  std::string output;
  std::string picture;
  std::string skinning = "linear";
  bool skeleton = false;
  bool json = false;
  ProportionOptions proportions;
};

PoseForm parse_form(const std::string& word) {
  if (word == "pose") return PoseForm::pose;
  if (word == "clip") return PoseForm::clip;
  if (word == "baked") return PoseForm::baked;
  throw_invalid_argument("--as '" + printable(word) + "': wanted pose, clip, baked");
}

/// The project with its first actor in the pose that the line is drawn over.
Project at_start(const Project& project, const std::string& start) {
  const Character& character = *project.actors.front().character;
  if (start.empty()) return set_pose(project, 0, rest_pose(character.skeleton));
  if (std::optional<Pose> pose = find_shelf_pose(character, start)) return set_pose(project, 0, *std::move(pose));
  const Character source = load_start(start);
  try {
    return set_pose(project, 0, start_pose_of(source, character));
  } catch (const Error& error) {
    throw Error(error.code(), "--start " + start + ": " + error.what());
  }
}

void run_pose(const PoseArguments& options) {
  Outputs outputs;
  const std::string format = output_format(options.output, character_formats());
  outputs.announce(options.output);
  if (!options.picture.empty()) {
    (void)output_format(options.picture, {"png"});
    outputs.announce(options.picture);
  }
  const WriteOptions writing{parse_form(options.form), options.add_positions};
  PictureOptions look;
  look.skinning = parse_skinning(options.skinning);
  look.skeleton = options.skeleton;
  options.line.check();
  options.proportions.check(options.rig);

  Progress progress;
  progress.at("Reading " + options.rig);
  Project project = at_start(load_project(options.rig, options.proportions.proportions), options.start);
  const std::shared_ptr<const Character> character = project.actors.front().character;
  project = options.line.with_rules(std::move(project), file_format(options.rig) != "croquis");
  PoseReport report;
  report.notices = notices_for(*character, format, writing.form);
  const Camera camera = options.view.camera(project.actors);
  std::vector<Stroke> ink;
  if (!options.line.file.empty()) {
    progress.at("Posing");
    PlacedLines lines = read_lines(options.line, project, camera, report.notices);
    PosedLines posed = pose_along_lines(project, lines.strokes);
    project = std::move(posed.project);
    report.lines = std::move(posed.reports);
    report.alternatives = std::move(lines.alternatives);
    for (const PlacedStroke& stroke : lines.strokes) ink.push_back(stroke.stroke);
  }
  progress.at("Writing " + options.output);
  outputs.add(options.output, to_file(project, format, options.output, writing));
  if (!options.picture.empty()) {
    progress.at("Rendering " + options.picture);
    outputs.add(options.picture, picture_of(project.actors, camera, ink, look));
  }
  outputs.write();
  report.outputs = outputs.paths();
  std::cout << (options.json ? to_json(report, character->skeleton) + "\n" : to_text(report, character->skeleton));
}

}  // namespace

Command add_pose_command(CLI::App& program) {
  const auto options = std::make_shared<PoseArguments>();
  CLI::App* command = program.add_subcommand("pose", "Poses a character along a drawn line");
  command
      ->add_option("RIG", options->rig, "Any file with a skeleton, or one of " + join(builtin_character_names(), ", "))
      ->required();
  options->line.add_to(*command);
  options->view.add_to(*command);
  command
      ->add_option("--start", options->start,
                   "The pose the line is drawn over: FILE as it opens, or frame N of it, from 0; for a humanoid also a "
                   "pose by its name: relaxed, walk, run, crouch, sit, ... [default: rest]")
      ->type_name("FILE[:N]");
  command
      ->add_option("--as", options->form,
                   "pose: into the joints; clip: a clip of one frame, joints at rest; baked: into the mesh")
      ->type_name("FORM");
  command->add_flag("--add-positions", options->add_positions,
                    "BVH: give stretched joints position channels [default: refuse]");
  command->add_option("-o,--output", options->output, "The posed file: " + join(character_formats(), ", "))
      ->required()
      ->type_name("OUT");
  command->add_option("--picture", options->picture, "A picture of it with the line, a .png [default: none]")
      ->type_name("OUT.png");
  command->add_option("--skinning", options->skinning, "linear or dual-quaternion, for the picture")
      ->type_name("METHOD");
  command->add_flag("--skeleton", options->skeleton, "Draw the bones in the picture [default: off]");
  command->add_flag("--json", options->json, "Report as one JSON object on standard output [default: as text]");
  options->proportions.add_to(*command);
  command->footer(
      "Example:\n"
      "  croquis pose mannequin --line line.svg --body-line left_foot-head --view front -o posed.glb "
      "--picture posed.png");
  return {command, [options] { run_pose(*options); }};
}

}  // namespace croquis::cli
