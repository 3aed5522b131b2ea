// SPDX-License-Identifier: MIT
#include "cli/command.h"
#include "cli/files.h"
#include "cli/outputs.h"
#include "cli/progress.h"
#include "cli/writing.h"
#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>

#include "croquis/base/text.h"

namespace croquis::cli {
namespace {

struct ConvertArguments {
  std::string input;
  std::string output;
};

void run_convert(const ConvertArguments& options) {
  Outputs outputs;
  const std::string format = output_format(options.output, character_formats());
  outputs.announce(options.output);
  Progress progress;
  progress.at("Reading " + options.input);
  const Project project = load_project(options.input);
  progress.at("Writing " + options.output);
  const Character& character = *project.actors.front().character;
  const bool same_motion = format == "bvh" && character.source && character.source->format == "bvh";
  if (same_motion) {
    // A BVH is its motion; of one that stays a BVH nothing is to be changed.
    outputs.add(options.output, character.source->bytes);
  } else {
    outputs.add(options.output, to_file(project, format, options.output, {}));
  }
  outputs.write();
  if (format == "bvh" && !same_motion && !character.clips.empty()) {
    std::cout << "Note: a BVH written from another format holds one frame, the pose the file opens in\n";
  }
}

}  // namespace

Command add_convert_command(CLI::App& program) {
  const auto options = std::make_shared<ConvertArguments>();
  CLI::App* command = program.add_subcommand("convert", "Reads a file in one format and writes it in another");
  command->add_option("IN", options->input, "Read: .glb, .gltf, .vrm, .bvh, .obj, .croquis, or a built-in character")
      ->required();
  command->add_option("OUT", options->output, "Written: " + join(character_formats(), ", "))->required();
  command->footer("Example:\n  croquis convert cat cat.gltf");
  return {command, [options] { run_convert(*options); }};
}

}  // namespace croquis::cli
