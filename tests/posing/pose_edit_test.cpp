// SPDX-License-Identifier: MIT
#include "croquis/posing/pose_edit.h"

#include "posing/small_humanoid.h"

#include <gtest/gtest.h>

#include "croquis/base/error.h"
#include "croquis/math/rotation.h"

namespace croquis {
namespace {

double largest_difference(const Skeleton& skeleton, const Pose& a, const Pose& b) {
  const auto pa = compute_model_transforms(skeleton, a), pb = compute_model_transforms(skeleton, b);
  double most = 0.0;
  for (std::size_t i = 0; i < pa.size(); ++i) most = std::max(most, (pa[i].matrix() - pb[i].matrix()).norm());
  return most;
}

TEST(MirrorPose, ReflectsEveryJointInTheSagittalPlaneWhateverTheBoneRoll) {
  Random random(1);
  for (int round = 0; round < 10; ++round) {
    const SmallHumanoid body = make_small_humanoid(&random);
    Pose pose = random_pose(body.skeleton, random, 0.3);
    pose.local[0].rotation = body.skeleton.joint(0).rest.rotation;  // heading as at rest: the plane is x = 0
    const auto map = mirror_of(body);
    const Pose mirrored = mirror_pose(body.skeleton, body.map, map, Vec3::UnitZ(), pose);
    const auto before = compute_positions(body.skeleton, pose), after = compute_positions(body.skeleton, mirrored);
    for (std::size_t i = 0; i < before.size(); ++i) {
      const Vec3 partner = before[static_cast<std::size_t>(map[i])];
      EXPECT_LT((after[i] - Vec3(-partner.x(), partner.y(), partner.z())).norm(), 1e-9);
    }
  }
}

TEST(MirrorPose, TwiceGivesThePoseBackAtAnyHeading) {
  Random random(2);
  const SmallHumanoid body = make_small_humanoid(&random);
  for (int round = 0; round < 20; ++round) {
    const Pose pose = random_pose(body.skeleton, random, 0.45);
    const auto map = mirror_of(body);
    const Pose once = mirror_pose(body.skeleton, body.map, map, Vec3::UnitZ(), pose);
    const Pose twice = mirror_pose(body.skeleton, body.map, map, Vec3::UnitZ(), once);
    EXPECT_LT(largest_difference(body.skeleton, pose, twice), 1e-9);
    EXPECT_LT(bone_length_drift(body.skeleton, pose, once), 1e-9);
  }
}

TEST(MirrorPose, ATurnedBodyKeepsItsHeading) {
  const SmallHumanoid body = make_small_humanoid();
  Pose pose = rest_pose(body.skeleton);
  pose.local[0].rotation = rotation_from_vector(Vec3(0, 1.1, 0));
  const Pose mirrored = mirror_pose(body.skeleton, body.map, mirror_of(body), Vec3::UnitZ(), pose);
  EXPECT_LT(largest_difference(body.skeleton, pose, mirrored), 1e-9);
}

TEST(MirrorPose, OneSideCopiesToTheOtherAndStays) {
  Random random(3);
  const SmallHumanoid body = make_small_humanoid(&random);
  const Pose pose = random_pose(body.skeleton, random, 0.3);
  const Pose copied = mirror_pose(body.skeleton, body.map, mirror_of(body), Vec3::UnitZ(), pose, MirrorSide::left);
  for (int i = 0; i < body.skeleton.joint_count(); ++i) {
    const bool right = body.skeleton.name(i).starts_with("right");
    const double change = copied.local[static_cast<std::size_t>(i)].rotation.angularDistance(
        pose.local[static_cast<std::size_t>(i)].rotation);
    if (!right) {
      EXPECT_LT(change, 1e-12) << body.skeleton.name(i);
    }
  }
  const Pose again = mirror_pose(body.skeleton, body.map, mirror_of(body), Vec3::UnitZ(), copied, MirrorSide::left);
  EXPECT_LT(largest_difference(body.skeleton, copied, again), 1e-9);
}

TEST(BlendPose, MeetsItsEndsAndLeavesOtherJoints) {
  Random random(4);
  const SmallHumanoid body = make_small_humanoid();
  const Pose a = random_pose(body.skeleton, random, 0.5), b = random_pose(body.skeleton, random, 0.5);
  EXPECT_LT(largest_difference(body.skeleton, blend_pose(a, b, 0.0), a), 1e-12);
  EXPECT_LT(largest_difference(body.skeleton, blend_pose(a, b, 1.0), b), 1e-9);
  const std::vector<int> head{2};
  const Pose only = blend_pose(a, b, 1.0, head);
  EXPECT_LT(only.local[3].rotation.angularDistance(a.local[3].rotation), 1e-12);
  EXPECT_LT(only.local[2].rotation.angularDistance(b.local[2].rotation), 1e-9);
  EXPECT_THROW(static_cast<void>(blend_pose(a, b, 1.0, std::vector<int>{99})), Error);
}

TEST(TurnJoint, TurnsTheLimbAboutTheJointInModelSpace) {
  Random random(5);
  const SmallHumanoid body = make_small_humanoid(&random);
  const Pose pose = rest_pose(body.skeleton);
  const Quat quarter = rotation_from_vector(Vec3(0, 0, kPi / 2));
  const Pose turned = turn_joint(body.skeleton, pose, 3, quarter);
  const auto positions = compute_positions(body.skeleton, turned);
  EXPECT_LT((positions[3] - body.skeleton.rest_position(3)).norm(), 1e-12);
  EXPECT_LT((positions[5] - Vec3(0.18, 1.95, 0)).norm(), 1e-9);
}

}  // namespace
}  // namespace croquis
