// SPDX-License-Identifier: MIT
#include "cli/help.h"

#include <vector>

#include "croquis/base/text.h"

namespace croquis::cli {
namespace {

constexpr std::size_t kColumn = 26, kPage = 100;

/// Lines of at most the page's width beside the column; CLI11 indents what follows a line break.
std::string wrapped(const std::string& text) {
  std::string result;
  std::size_t used = 0;
  for (const std::string& word : split(text, ' ')) {
    if (used > 0 && used + 1 + word.size() > kPage - kColumn) {
      result += '\n';
      used = 0;
    } else if (used > 0) {
      result += ' ';
      ++used;
    }
    result += word;
    used += word.size();
  }
  return result;
}

}  // namespace

HelpFormatter::HelpFormatter() { column_width(kColumn); }

std::string HelpFormatter::make_option_opts(const CLI::Option* option) const {
  return option->get_type_size() == 0 || option->get_type_name() == "TEXT" ? "" : " " + option->get_type_name();
}

std::string HelpFormatter::make_option_desc(const CLI::Option* option) const {
  std::string text = option->get_description();
  if (option->get_required() && !option->get_positional()) text += " [required]";
  if (!option->get_default_str().empty()) text += " [default: " + option->get_default_str() + "]";
  return wrapped(text);
}

std::string HelpFormatter::make_subcommand(const CLI::App* command) const {
  return "  " + command->get_name() + std::string(12 - command->get_name().size(), ' ') + command->get_description() +
         "\n";
}

}  // namespace croquis::cli
