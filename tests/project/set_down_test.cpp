// SPDX-License-Identifier: MIT
#include "croquis/project/set_down.h"

#include <limits>

#include <gtest/gtest.h>

#include "croquis/base/error.h"

namespace croquis {
namespace {

TEST(SetDown, MovesEverythingAtRestAndAtTheStartAndTurnsNothing) {
  const Skeleton skeleton({{"scene", -1, {Vec3(0, 1, 0)}, true}, {"a", 0, {Vec3(0, 1, 0)}}});
  Character character{.name = "stick", .skeleton = skeleton, .start = rest_pose(skeleton)};
  character.start.local[1].translation = Vec3(0, 0, 3);
  const Vec3 shift(2, 0, -1);
  const Character moved = set_down(character, shift);
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(moved.skeleton.rest_position(i), character.skeleton.rest_position(i) + shift);
    const auto before = compute_positions(character.skeleton, character.start)[static_cast<std::size_t>(i)];
    EXPECT_EQ(compute_positions(moved.skeleton, moved.start)[static_cast<std::size_t>(i)], before + shift);
  }
}

TEST(SetDown, ShiftsThatAreNoPlaceAreRefused) {
  const Skeleton skeleton({{"a", -1, {}}});
  const Character character{.name = "dot", .skeleton = skeleton, .start = rest_pose(skeleton)};
  EXPECT_THROW((void)set_down(character, Vec3(0, std::numeric_limits<double>::quiet_NaN(), 0)), Error);
}

}  // namespace
}  // namespace croquis
