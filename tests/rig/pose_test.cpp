// SPDX-License-Identifier: MIT
#include "croquis/rig/pose.h"

#include "support/random_math.h"

#include <gtest/gtest.h>

#include "croquis/base/error.h"
#include "croquis/math/rotation.h"

namespace croquis {
namespace {

Skeleton arm() {
  return Skeleton({{"shoulder", -1, {}}, {"elbow", 0, {Vec3(1, 0, 0)}}, {"wrist", 1, {Vec3(1, 0, 0)}}});
}

TEST(Pose, ABentElbowMovesTheWristByHand) {
  const Skeleton skeleton = arm();
  Pose pose = rest_pose(skeleton);
  pose.local[1].rotation = rotation_from_vector(Vec3(0, 0, kPi / 2));
  const auto positions = compute_positions(skeleton, pose);
  EXPECT_TRUE(positions[2].isApprox(Vec3(1, 1, 0)));
}

TEST(Pose, RotationsKeepBoneLengths) {
  Random random(5);
  const Skeleton skeleton = arm();
  Pose pose = rest_pose(skeleton);
  for (Transform& local : pose.local) local.rotation = random_rotation(random);
  EXPECT_LT(bone_length_drift(skeleton, rest_pose(skeleton), pose), 1e-12);
  pose.local[2].translation *= 1.5;
  EXPECT_NEAR(bone_length_drift(skeleton, rest_pose(skeleton), pose), 0.5, 1e-12);
}

TEST(Pose, SizesThatDoNotFitAreRefused) {
  Pose pose = rest_pose(arm());
  pose.local.pop_back();
  EXPECT_THROW(static_cast<void>(compute_model_transforms(arm(), pose)), Error);
}

}  // namespace
}  // namespace croquis
