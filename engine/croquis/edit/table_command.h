// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "croquis/edit/stroke_commands.h"
#include "croquis/project/project.h"

namespace croquis {

/// What a command made of a project.
struct TableChange {
  Project project;
  std::string label;                ///< for the undo button: "draw", "mirror"
  std::optional<DrawnStroke> line;  ///< of commands that solve a line; its project is moved out
  std::string notice;               ///< what could not be done in full; may be empty
};

/// Applies one command of the drawing table, written as JSON: {"name": "draw", "actor": 1, ...}. The names and their
/// arguments stand in docs/commands.md. This is the form that the studio sends and that a journal keeps, so the same
/// text on the same project gives the same project. `file` holds the bytes that an "open" brings. Throws bad_file with
/// the JSON pointer for what is missing or of the wrong kind, and whatever the command itself throws. `help` makes
/// lines faster and changes nothing.
[[nodiscard]] TableChange apply_table_command(const Project& project, std::string_view command_json,
                                              std::span<const std::byte> file = {}, const DrawHelp& help = {});

/// The stroke that a command draws; nothing for one that is no "draw".
[[nodiscard]] std::optional<PlacedStroke> read_draw_command(const Project& project, std::string_view command_json);

}  // namespace croquis
