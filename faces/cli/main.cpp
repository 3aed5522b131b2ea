// SPDX-License-Identifier: MIT
#include "cli/command.h"
#include "cli/help.h"
#include <algorithm>
#include <exception>
#include <iostream>
#include <memory>
#include <new>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "croquis/base/error.h"
#include "croquis/base/text.h"

namespace croquis::cli {
namespace {

constexpr int kBadInput = 2;
constexpr int kOurs = 1;

/// One line on stderr, whatever the text holds.
int fail(const std::string& text, int status) {
  std::cerr << "croquis: " << printable(text, 1000) << '\n';
  return status;
}

/// The options of a command, or the commands where `word` is no option.
std::vector<std::string> known_words(const CLI::App& command, const std::string& word) {
  std::vector<std::string> words;
  if (word.starts_with('-')) {
    for (const CLI::Option* option : command.get_options()) words.push_back(option->get_name());
  } else {
    for (const CLI::App* sub : command.get_subcommands({})) words.push_back(sub->get_name());
  }
  return words;
}

std::string unknown_word(const CLI::App& command, const std::string& word) {
  const std::string near = closest_word(word, known_words(command, word));
  const std::string hint = near.empty() ? "" : "; did you mean " + near + "?";
  if (word.starts_with('-')) return "there is no option " + word + hint;
  return command.get_parent() == nullptr ? "there is no command '" + word + "'" + hint
                                         : "'" + word + "' is one argument too many";
}

/// CLI11's own words for a usage error, as one sentence that says where help is.
int fail_usage(const CLI::App& program, const CLI::ParseError& error) {
  const CLI::App* command = &program;
  std::string name = "croquis";
  for (const CLI::App* used : program.get_subcommands()) {
    command = used;
    name += " " + used->get_name();
  }
  std::string text = error.what();
  if (const auto end = text.find('\n'); end != std::string::npos) text.resize(end);
  // "Could not convert: --heads = abc"
  if (error.get_name() == "ConversionError") {
    const auto option = text.find("--"), given = text.find(" = ");
    if (option != std::string::npos && given != std::string::npos) {
      text = text.substr(option, given - option) + " '" + text.substr(given + 3) + "': wanted a number";
    }
  }
  const std::vector<std::string> extras = program.remaining(true);
  if (!extras.empty()) {
    const auto option = std::find_if(extras.begin(), extras.end(), [](const auto& word) { return word[0] == '-'; });
    text = unknown_word(*command, option == extras.end() ? extras.front() : *option);
  } else if (command == &program) {
    text = "a command is wanted: " + join(known_words(program, ""), ", ");
  }
  return fail(text + " (see " + name + " --help)", kBadInput);
}

int run(int argc, char** argv) {
  CLI::App program{"Croquis: a drawn line poses a rigged character.", "croquis"};
  program.set_version_flag("--version", "croquis " CROQUIS_VERSION);
  program.require_subcommand(1);
  program.option_defaults()->always_capture_default();
  program.formatter(std::make_shared<HelpFormatter>());
  program.footer(
      "Example:\n"
      "  croquis pose mannequin --picture mannequin.png -o mannequin.glb\n"
      "Each command has a --help with its defaults and an example.");
  const std::vector<Command> commands{add_pose_command(program),      add_line_command(program),
                                      add_sheet_command(program),     add_info_command(program),
                                      add_render_command(program),    add_convert_command(program),
                                      add_character_command(program), add_studio_command(program)};
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != static_cast<int>(CLI::ExitCodes::Success)) return fail_usage(program, error);
    return program.exit(error);  // --help and --version
  }
  for (const Command& command : commands) {
    if (command.app->parsed()) command.run();
  }
  std::cout.flush();
  return std::cout ? 0 : fail("standard output cannot be written", kBadInput);
}

}  // namespace
}  // namespace croquis::cli

int main(int argc, char** argv) {
  using croquis::cli::fail;
  try {
    return croquis::cli::run(argc, argv);
  } catch (const croquis::Error& error) {
    const bool ours = error.code() == croquis::ErrorCode::internal;
    return fail(error.what(), ours ? croquis::cli::kOurs : croquis::cli::kBadInput);
  } catch (const std::bad_alloc&) {
    return fail("this needs more memory than there is", croquis::cli::kBadInput);
  } catch (const std::exception& error) {
    return fail(std::string("internal error: ") + error.what(), croquis::cli::kOurs);
  }
}
