// SPDX-License-Identifier: MIT
#include "cli/command.h"
#include "cli/files.h"
#include "cli/options.h"
#include "cli/outputs.h"
#include "cli/progress.h"
#include <iostream>
#include <memory>
#include <optional>
#include <utility>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "croquis/base/text.h"
#include "croquis/body/body.h"
#include "croquis/edit/line_choice.h"
#include "croquis/edit/pose_line.h"
#include "croquis/io/svg.h"

namespace croquis::cli {
namespace {

struct LineArguments {
  std::string rig;
  std::string output;
  std::string joints;
  StrokeSettings settings;
  ViewOptions view;
  std::optional<int> frame;
  bool json = false;
};

std::string to_json(const PoseLine& read, const std::string& output) {
  nlohmann::ordered_json json;
  json["body_line"] = read.line.name;
  json["shape"] = std::string(to_string(read.character.shape));
  json["strength"] = read.character.strength;
  json["turn_degrees"] = read.character.turn_degrees;
  json["bends_degrees"] = read.character.bends_degrees;
  json["outputs"] = {output};
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string to_text(const PoseLine& read, const std::string& output) {
  return "The line of " + printable(read.line.name) + ": " + std::string(to_string(read.character.shape)) +
         ", strength " + format_double(read.character.strength, 3) + ", turning by " +
         format_double(read.character.turn_degrees, 3) + " degrees\nWrote " + output + "\n";
}

void run_line(const LineArguments& options) {
  Outputs outputs;
  (void)output_format(options.output, {"svg"});
  outputs.announce(options.output);
  Progress progress;
  progress.at("Reading " + options.rig);
  Project project = load_project(options.rig);
  if (options.frame) project = at_frame(std::move(project), *options.frame, options.rig);
  const Actor& actor = project.actors.front();
  const Camera camera = options.view.camera(project.actors);
  StrokeSettings settings = options.settings;
  if (!options.joints.empty()) settings.joints = parse_joint_list(actor.character->skeleton, options.joints);
  const PoseLine read = read_pose_line(actor, settings, camera);
  const std::string svg = write_svg_strokes({read.stroke}, camera.width_px, camera.height_px);
  const auto* first = reinterpret_cast<const std::byte*>(svg.data());
  outputs.add(options.output, Bytes(first, first + svg.size()));
  outputs.write();
  std::cout << (options.json ? to_json(read, options.output) : to_text(read, options.output));
}

}  // namespace

Command add_line_command(CLI::App& program) {
  const auto options = std::make_shared<LineArguments>();
  CLI::App* command = program.add_subcommand("line", "Reads the line of action off a pose, as a drawing");
  command
      ->add_option("RIG", options->rig,
                   "A character as it opens, a project, or one of " + join(builtin_character_names(), ", "))
      ->required();
  command->add_option("-o,--output", options->output, "The line, an .svg in the picture's pixels")
      ->required()
      ->type_name("OUT.svg");
  command->add_option("--frame", options->frame, "The frame of the first clip, from 0 [default: as the file opens]")
      ->type_name("N");
  auto* joints = command
                     ->add_option("--joints", options->joints,
                                  "The joints along which it is read, in order [default: the character's default line]")
                     ->type_name("A,B,C,...");
  command
      ->add_option("--body-line", options->settings.body_line,
                   "The line to read by its name; croquis info lists them [default: the first]")
      ->type_name("NAME")
      ->excludes(joints);
  options->view.add_to(*command);
  command->add_flag("--json", options->json, "Report shape and strength as one JSON object [default: as text]");
  command->footer("Example:\n  croquis line mannequin --body-line left_foot-head --view left -o line.svg");
  return {command, [options] { run_line(*options); }};
}

}  // namespace croquis::cli
