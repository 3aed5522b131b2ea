// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "croquis/project/project.h"

namespace croquis {

/// A list of projects, so that undo and redo cannot be wrong. Copies share their characters, so a step is small.
class History {
 public:
  explicit History(Project first);

  [[nodiscard]] const Project& current() const;
  /// Makes `next` the current project; what had been undone is gone.
  void commit(Project next, std::string label);
  [[nodiscard]] bool can_undo() const;
  [[nodiscard]] bool can_redo() const;
  void undo();  ///< nothing happens where there is nothing to undo
  void redo();
  /// The label of the step that undo would take back; empty if there is none.
  [[nodiscard]] std::string undo_label() const;
  [[nodiscard]] std::string redo_label() const;

 private:
  struct Step {
    Project project;
    std::string label;
  };
  std::vector<Step> steps_;
  std::size_t now_ = 0;
};

}  // namespace croquis
