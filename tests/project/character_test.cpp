// SPDX-License-Identifier: MIT
#include "croquis/project/character.h"

#include <gtest/gtest.h>

#include "croquis/base/error.h"

namespace croquis {
namespace {

Character stick() {
  const Skeleton skeleton({{"scene", -1, {}, true}, {"a", 0, {Vec3(0, 1, 0)}}, {"b", 1, {Vec3(0, 1, 0)}}});
  return {.name = "stick", .skeleton = skeleton, .start = rest_pose(skeleton)};
}

TEST(Character, CheckFindsWhatDoesNotFit) {
  Character character = stick();
  EXPECT_NO_THROW(character.check());
  character.parts.push_back({.name = "rigid", .joint = 3});
  EXPECT_THROW(character.check(), Error);
  character = stick();
  character.start.local.pop_back();
  EXPECT_THROW(character.check(), Error);
  character = stick();
  character.clips.push_back({"walk", {Curve{.joint = 7, .times = {0.0}, .values = {0, 0, 0, 1}}}});
  EXPECT_THROW(character.check(), Error);
}

TEST(Character, TheBoxHoldsJointsAndVerticesButNoHelpers) {
  const Character character = stick();
  const Box joints = bounding_box(character, character.start);
  EXPECT_TRUE(joints.min().isApprox(Vec3(0, 1, 0)));
  const Box all = bounding_box(character, character.start, {{Vec3f(-1, 0, 5)}});
  EXPECT_TRUE(all.min().isApprox(Vec3(-1, 0, 0)));
  EXPECT_TRUE(all.max().isApprox(Vec3(0, 2, 5)));
}

}  // namespace
}  // namespace croquis
