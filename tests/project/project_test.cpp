// SPDX-License-Identifier: MIT
#include "croquis/project/project.h"

#include <gtest/gtest.h>

#include "croquis/base/error.h"

namespace croquis {
namespace {

Project one_actor() {
  const Skeleton skeleton({{"root", -1, {}}});
  const auto character =
      std::make_shared<const Character>(Character{.name = "dot", .skeleton = skeleton, .start = rest_pose(skeleton)});
  Project project;
  project.actors.push_back({character, character->start});
  return project;
}

TEST(Project, CopiesShareTheirCharacters) {
  const Project project = one_actor();
  const Project copy = project;
  EXPECT_EQ(copy.actors[0].character.get(), project.actors[0].character.get());
}

TEST(Project, CheckFindsWhatDoesNotFit) {
  EXPECT_NO_THROW(one_actor().check());
  Project project = one_actor();
  project.strokes.push_back({.actor = 1});
  EXPECT_THROW(project.check(), Error);
  project = one_actor();
  project.poses.push_back({"none", 0, Pose{}});
  EXPECT_THROW(project.check(), Error);
  project = one_actor();
  project.actors[0].pose.local.clear();
  EXPECT_THROW(project.check(), Error);
}

}  // namespace
}  // namespace croquis
