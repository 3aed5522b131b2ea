// SPDX-License-Identifier: MIT
#include "croquis/edit/history.h"

#include <gtest/gtest.h>

#include "croquis/base/random.h"

namespace croquis {
namespace {

/// A project that a number tells from others.
Project numbered(int number) {
  Project project;
  project.views.push_back({std::to_string(number), Camera()});
  return project;
}

int number_of(const Project& project) { return std::stoi(project.views.front().name); }

TEST(History, StartsWithNothingToUndo) {
  History history(numbered(0));
  EXPECT_FALSE(history.can_undo());
  EXPECT_FALSE(history.can_redo());
  EXPECT_EQ(history.undo_label(), "");
  history.undo();
  history.redo();
  EXPECT_EQ(number_of(history.current()), 0);
}

TEST(History, UndoGivesBackTheProjectBefore) {
  History history(numbered(0));
  history.commit(numbered(1), "one");
  history.commit(numbered(2), "two");
  EXPECT_EQ(history.undo_label(), "two");
  history.undo();
  EXPECT_EQ(number_of(history.current()), 1);
  EXPECT_EQ(history.redo_label(), "two");
  history.redo();
  EXPECT_EQ(number_of(history.current()), 2);
}

TEST(History, ACommitAfterUndoForgetsWhatWasUndone) {
  History history(numbered(0));
  history.commit(numbered(1), "one");
  history.undo();
  history.commit(numbered(2), "two");
  EXPECT_FALSE(history.can_redo());
  history.undo();
  EXPECT_EQ(number_of(history.current()), 0);
}

TEST(History, AgreesWithAPlainListOverRandomSteps) {
  Random random(7);
  History history(numbered(0));
  std::vector<int> list{0};
  std::size_t now = 0;
  for (int step = 1; step <= 200; ++step) {
    const int what = random.index(3);
    if (what == 0) {
      list.resize(now + 1);
      list.push_back(step);
      ++now;
      history.commit(numbered(step), "step");
    } else if (what == 1) {
      if (now > 0) --now;
      history.undo();
    } else {
      if (now + 1 < list.size()) ++now;
      history.redo();
    }
    ASSERT_EQ(number_of(history.current()), list[now]);
    ASSERT_EQ(history.can_undo(), now > 0);
    ASSERT_EQ(history.can_redo(), now + 1 < list.size());
  }
}

}  // namespace
}  // namespace croquis
