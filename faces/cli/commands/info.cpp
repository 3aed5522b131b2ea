// SPDX-License-Identifier: MIT
#include "cli/command.h"
#include "cli/commands/info_text.h"
#include "cli/files.h"
#include "cli/progress.h"
#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>

namespace croquis::cli {
namespace {

struct InfoArguments {
  std::string input;
  bool json = false;
};

void run_info(const InfoArguments& options) {
  nlohmann::ordered_json description;
  {
    Progress progress;
    progress.at("Reading " + options.input);
    description = describe(options.input, load_project(options.input));
  }
  if (options.json) {
    std::cout << description.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
  } else {
    std::cout << to_text(description);
  }
}

}  // namespace

Command add_info_command(CLI::App& program) {
  const auto options = std::make_shared<InfoArguments>();
  CLI::App* command = program.add_subcommand("info", "Tells what is in a file");
  command->add_option("FILE", options->input, "A character, a project, or a built-in character")->required();
  command->add_flag("--json", options->json, "As one JSON object [default: as text]");
  command->footer("Example:\n  croquis info mannequin");
  return {command, [options] { run_info(*options); }};
}

}  // namespace croquis::cli
