// SPDX-License-Identifier: MIT
#include "croquis/edit/history.h"

#include <utility>

namespace croquis {

History::History(Project first) { steps_.push_back({std::move(first), {}}); }

const Project& History::current() const { return steps_[now_].project; }

void History::commit(Project next, std::string label) {
  steps_.resize(now_ + 1);
  steps_.push_back({std::move(next), std::move(label)});
  ++now_;
}

bool History::can_undo() const { return now_ > 0; }
bool History::can_redo() const { return now_ + 1 < steps_.size(); }

void History::undo() {
  if (can_undo()) --now_;
}

void History::redo() {
  if (can_redo()) ++now_;
}

std::string History::undo_label() const { return can_undo() ? steps_[now_].label : std::string(); }
std::string History::redo_label() const { return can_redo() ? steps_[now_ + 1].label : std::string(); }

}  // namespace croquis
