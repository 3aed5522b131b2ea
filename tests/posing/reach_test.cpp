// SPDX-License-Identifier: MIT
#include "croquis/posing/reach.h"

#include "posing/small_humanoid.h"
#include <limits>

#include <gtest/gtest.h>

#include "croquis/base/error.h"

namespace croquis {
namespace {

TEST(Reach, AHandGetsWhereItIsWantedAndBonesKeepTheirLengths) {
  Random random(1);
  const SmallHumanoid body = make_small_humanoid(&random);
  const Pose start = rest_pose(body.skeleton);
  const std::vector<int> limb = limb_above(body.skeleton, body.map, 5);
  EXPECT_EQ(limb, (std::vector<int>{3, 4}));
  for (int i = 0; i < 50; ++i) {
    const Vec3 direction = random_vector(random).normalized();
    const Vec3 wanted = body.skeleton.rest_position(3) + random.uniform(0.15, 0.54) * direction;
    const std::vector<ReachGoal> goals{{5, wanted, {}}};
    const ReachResult result = solve_reach(body.skeleton, start, goals, limb, {});
    EXPECT_EQ(result.status, "ok");
    EXPECT_LT((compute_positions(body.skeleton, result.pose)[5] - wanted).norm(), 1e-3) << direction.transpose();
    EXPECT_LT(bone_length_drift(body.skeleton, start, result.pose), 1e-9);
  }
}

TEST(Reach, AGoalOutOfReachIsApproachedAndToldOf) {
  const SmallHumanoid body = make_small_humanoid();
  const std::vector<ReachGoal> goals{{5, Vec3(0.18, 5.0, 0), {}}};
  const ReachResult result =
      solve_reach(body.skeleton, rest_pose(body.skeleton), goals, limb_above(body.skeleton, body.map, 5), {});
  EXPECT_NE(result.status, "ok");
  const Vec3 hand = compute_positions(body.skeleton, result.pose)[5];
  EXPECT_LT((hand - Vec3(0.18, 1.95, 0)).norm(), 0.02);  // stretched straight up
}

TEST(Reach, DegenerateCasesStayFinite) {
  const SmallHumanoid body = make_small_humanoid();
  const Pose start = rest_pose(body.skeleton);
  const std::vector<ReachGoal> at_the_shoulder{{5, body.skeleton.rest_position(3), {}}};
  const std::vector<int> limb = limb_above(body.skeleton, body.map, 5);
  for (const Transform& local : solve_reach(body.skeleton, start, at_the_shoulder, limb, {}).pose.local) {
    EXPECT_TRUE(local.is_finite());
  }
  EXPECT_EQ(solve_reach(body.skeleton, start, {}, {}, {}).status, "ok");
  const std::vector<ReachGoal> broken{{5, Vec3::Constant(std::numeric_limits<double>::quiet_NaN()), {}}};
  EXPECT_THROW(static_cast<void>(solve_reach(body.skeleton, start, broken, limb, {})), Error);
}

TEST(Reach, OffALimbOnlyAFewJointsFollow) {
  std::vector<Joint> joints{{"root", -1, {}}};
  for (int i = 1; i < 10; ++i) joints.push_back({"j" + std::to_string(i), i - 1, {Vec3(0, 1, 0)}});
  const Skeleton chain(std::move(joints));
  EXPECT_EQ(limb_above(chain, {}, 9, 3), (std::vector<int>{6, 7, 8}));
  EXPECT_TRUE(limb_above(chain, {}, 0).empty());
}

}  // namespace
}  // namespace croquis
