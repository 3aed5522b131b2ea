// SPDX-License-Identifier: MIT
#include "croquis/posing/humanoid_pose.h"

#include "posing/small_humanoid.h"

#include <gtest/gtest.h>

#include "croquis/base/error.h"
#include "croquis/math/rotation.h"

namespace croquis {
namespace {

TEST(HumanoidPose, ApplyingWhatWasExtractedChangesNothing) {
  Random random(1);
  const SmallHumanoid body = make_small_humanoid(&random, 0.6);
  for (int round = 0; round < 10; ++round) {
    Pose pose = random_pose(body.skeleton, random, 0.4);
    pose.local[0].translation += Vec3(0.1, -0.2, 0.3);
    const HumanoidPose extracted = extract_humanoid_pose(body.skeleton, body.map, Vec3::UnitZ(), pose);
    const Pose back = apply_humanoid_pose(body.skeleton, body.map, Vec3::UnitZ(), extracted, rest_pose(body.skeleton));
    const auto a = compute_positions(body.skeleton, pose), b = compute_positions(body.skeleton, back);
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_LT((a[i] - b[i]).norm(), 1e-9);
  }
}

TEST(HumanoidPose, TravelsBetweenRigsOfOtherRollRestPoseAndSize) {
  Random random(2);
  const SmallHumanoid from = make_small_humanoid(), to = make_small_humanoid(&random, 0.8, 100.0);
  Pose pose = rest_pose(from.skeleton);
  pose.local[3].rotation = rotation_from_vector(Vec3(0, 0, 1.2));
  pose.local[4].rotation = rotation_from_vector(Vec3(0, -1.4, 0));
  pose.local[9].rotation = rotation_from_vector(Vec3(-0.9, 0, 0.2));
  pose.local[0].translation += Vec3(0, -0.1, 0.05);
  const HumanoidPose extracted = extract_humanoid_pose(from.skeleton, from.map, Vec3::UnitZ(), pose);
  const Pose other = apply_humanoid_pose(to.skeleton, to.map, Vec3::UnitZ(), extracted, rest_pose(to.skeleton));
  const auto a = compute_positions(from.skeleton, pose), b = compute_positions(to.skeleton, other);
  for (std::size_t i = 0; i < a.size(); ++i)
    EXPECT_LT((100.0 * a[i] - b[i]).norm(), 1e-6) << from.skeleton.name(static_cast<int>(i));
}

TEST(HumanoidPose, BonesThatAreNotNamedStayAsTheyAre) {
  Random random(3);
  const SmallHumanoid body = make_small_humanoid(&random);
  const Pose base = random_pose(body.skeleton, random, 0.4);
  HumanoidPose only_head;
  only_head.turns[static_cast<std::size_t>(HumanoidBone::head)] = rotation_from_vector(Vec3(0, 0.5, 0));
  const Pose posed = apply_humanoid_pose(body.skeleton, body.map, Vec3::UnitZ(), only_head, base);
  for (std::size_t i = 0; i < base.local.size(); ++i) {
    const double change = posed.local[i].rotation.angularDistance(base.local[i].rotation);
    if (i != 2) {
      EXPECT_LT(change, 1e-12);
    }
  }
  EXPECT_GT(posed.local[2].rotation.angularDistance(base.local[2].rotation), 0.01);
}

TEST(HumanoidPose, ATPoseLevelsArmsThatHangAtRest) {
  Random random(4);
  const SmallHumanoid body = make_small_humanoid(&random, 0.7);
  const auto positions = compute_positions(body.skeleton, make_t_pose(body.skeleton, body.map, Vec3::UnitZ()));
  EXPECT_LT((positions[5] - Vec3(0.73, 1.4, 0)).norm(), 1e-9);
  EXPECT_LT((positions[8] - Vec3(-0.73, 1.4, 0)).norm(), 1e-9);
}

TEST(HumanoidPose, WhatIsNoHumanoidIsRefused) {
  const Skeleton stick({{"a", -1, {}}});
  EXPECT_THROW(static_cast<void>(extract_humanoid_pose(stick, HumanoidMap{}, Vec3::UnitZ(), rest_pose(stick))), Error);
}

}  // namespace
}  // namespace croquis
