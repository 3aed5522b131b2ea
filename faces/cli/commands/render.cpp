// SPDX-License-Identifier: MIT
#include "cli/command.h"
#include "cli/files.h"
#include "cli/options.h"
#include "cli/outputs.h"
#include "cli/pictures.h"
#include "cli/progress.h"
#include <iostream>
#include <memory>
#include <optional>
#include <utility>

#include <CLI/CLI.hpp>

namespace croquis::cli {
namespace {

struct RenderArguments {
  std::string input;
  std::string output;
  ViewOptions view;
  std::optional<int> frame;
  bool skeleton = false;
  bool transparent = false;
  std::string skinning = "linear";
  ProportionOptions proportions;
};

void run_render(const RenderArguments& options) {
  Outputs outputs;
  (void)output_format(options.output, {"png"});
  outputs.announce(options.output);
  options.proportions.check(options.input);
  PictureOptions look;
  look.skeleton = options.skeleton;
  look.transparent = options.transparent;
  look.skinning = parse_skinning(options.skinning);

  Progress progress;
  progress.at("Reading " + options.input);
  Project project = load_project(options.input, options.proportions.proportions);
  if (options.frame) project = at_frame(std::move(project), *options.frame, options.input);
  progress.at("Rendering " + options.output);
  outputs.add(options.output, picture_of(project.actors, options.view.camera(project.actors), {}, look));
  outputs.write();
}

}  // namespace

Command add_render_command(CLI::App& program) {
  const auto options = std::make_shared<RenderArguments>();
  CLI::App* command = program.add_subcommand("render", "Draws a picture of a file as it stands");
  command->add_option("FILE", options->input, "A character, a project, or a built-in character")->required();
  command->add_option("-o,--output", options->output, "The picture, a .png")->required()->type_name("OUT.png");
  options->view.add_to(*command);
  command->add_option("--frame", options->frame, "The frame of the first clip, from 0 [default: as the file opens]")
      ->type_name("N");
  command->add_flag("--skeleton", options->skeleton, "Draw the bones over the body [default: off]");
  command->add_flag("--transparent", options->transparent, "No ground, no background [default: off]");
  command->add_option("--skinning", options->skinning, "linear or dual-quaternion")->type_name("METHOD");
  options->proportions.add_to(*command);
  command->footer("Example:\n  croquis render mannequin --view three-quarter --size 800x1000 -o mannequin.png");
  return {command, [options] { run_render(*options); }};
}

}  // namespace croquis::cli
