// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "croquis/edit/history.h"
#include "croquis/edit/table_command.h"

namespace croquis {

/// A drawing table in use: the project with its history, and what is shown while a pen is still down. Commands and
/// answers are JSON text, so that a page, a journal and a script speak the same way.
///
/// Every function that may change what is shown answers {"state": ..., "moved": [actor ids], "solved": ..., "notice":
/// ...}; "state" only where the project itself changed, "solved" only where a line was solved.
class Table {
 public:
  Table();

  /// Applies a command and makes it one step of the history.
  std::string execute(std::string_view command_json, std::span<const std::byte> file);
  /// Shows what a command would do; the project stays as it is. A "draw" with more and more samples is followed live:
  /// each costs a step of the line solver, and executing it leaves the pose that was shown.
  std::string preview(std::string_view command_json);
  /// Shows the project again.
  std::string cancel_preview();
  std::string undo();
  std::string redo();
  /// Replaces everything, history too, with a saved project.
  std::string restore(std::span<const std::byte> project_file);

  /// The project, and the project as it is shown now.
  [[nodiscard]] const Project& project() const { return history_.current(); }
  [[nodiscard]] const Project& shown() const { return shown_; }
  [[nodiscard]] const Actor& shown_actor(int id) const;

  /// Answers a question about the table as JSON: "pose" {actor}, "pose_joints" {actor, pose}, "shelf" {actor},
  /// "selection" {actor, joints}.
  [[nodiscard]] std::string query(std::string_view name, std::string_view arguments_json) const;
  /// The table as a file: "croquis", "svg", "openpose", or the actor alone as "glb", "gltf", "vrm", "bvh".
  [[nodiscard]] Bytes export_file(std::string_view format, int actor_id, std::string_view options_json) const;

 private:
  std::string show(const TableChange& change, bool project_changed);
  [[nodiscard]] std::optional<TableChange> follow_pen(std::string_view command_json);

  History history_;
  Project shown_;
  std::shared_ptr<LiveStroke> live_;  ///< the stroke drawn last, or being drawn
};

}  // namespace croquis
