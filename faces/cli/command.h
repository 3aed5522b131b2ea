// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace croquis::cli {

/// A subcommand and what it does once the arguments are read. It throws Error for whatever goes wrong.
struct Command {
  CLI::App* app = nullptr;
  std::function<void()> run;
};

// One file each under commands/.
[[nodiscard]] Command add_pose_command(CLI::App& program);
[[nodiscard]] Command add_line_command(CLI::App& program);
[[nodiscard]] Command add_sheet_command(CLI::App& program);
[[nodiscard]] Command add_info_command(CLI::App& program);
[[nodiscard]] Command add_render_command(CLI::App& program);
[[nodiscard]] Command add_convert_command(CLI::App& program);
[[nodiscard]] Command add_character_command(CLI::App& program);
[[nodiscard]] Command add_studio_command(CLI::App& program);

}  // namespace croquis::cli
