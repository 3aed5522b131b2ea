// SPDX-License-Identifier: MIT
#include "cli/command.h"
#include "cli/options.h"
#include "cli/outputs.h"
#include "cli/progress.h"
#include "cli/writing.h"
#include <memory>

#include <CLI/CLI.hpp>

#include "croquis/base/text.h"
#include "croquis/edit/commands.h"

namespace croquis::cli {
namespace {

struct CharacterArguments {
  std::string name;
  std::string output;
  ProportionOptions proportions;
};

void run_character(const CharacterArguments& options) {
  Outputs outputs;
  const std::string format = output_format(options.output, character_formats());
  outputs.announce(options.output);
  if (is_builtin_character(options.name)) options.proportions.check(options.name);
  Progress progress;
  progress.at("Building " + options.name);
  const Project project = add_builtin_character({}, options.name, options.proportions.proportions);
  progress.at("Writing " + options.output);
  outputs.add(options.output, to_file(project, format, options.output, {}));
  outputs.write();
}

}  // namespace

Command add_character_command(CLI::App& program) {
  const auto options = std::make_shared<CharacterArguments>();
  CLI::App* command = program.add_subcommand("character", "Writes a built-in character as a file");
  command->add_option("NAME", options->name, "One of " + join(builtin_character_names(), ", "))->required();
  command->add_option("-o,--output", options->output, "The file: .glb, .gltf, .bvh or .croquis")
      ->required()
      ->type_name("OUT");
  options->proportions.add_to(*command);
  command->footer("Example:\n  croquis character mannequin --heads 6 --hands 1.3 -o mannequin.glb");
  return {command, [options] { run_character(*options); }};
}

}  // namespace croquis::cli
