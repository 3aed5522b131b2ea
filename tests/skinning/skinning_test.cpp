// SPDX-License-Identifier: MIT
#include "croquis/skinning/skinning.h"

#include "skinning/random_skin.h"

#include <gtest/gtest.h>

#include "croquis/base/error.h"

namespace croquis {
namespace {

Part triangle() {
  Part part;
  part.mesh.positions = {Vec3f(0, 0, 0), Vec3f(1, 0, 0), Vec3f(0, 1, 0)};
  part.mesh.normals.assign(3, Vec3f::UnitZ());
  part.mesh.tangents.assign(3, Vec4f(1, 0, 0, 1));
  part.mesh.triangles = {0, 1, 2};
  return part;
}

TEST(PosePart, ARigidPartGoesWithItsJoint) {
  Part part = triangle();
  part.joint = 1;
  part.joint_from_mesh = Affine(Eigen::Translation3d(0, 0, 1));
  const std::vector<Affine> model = {Affine::Identity(), Affine(Eigen::AngleAxisd(kPi / 2, Vec3::UnitX()))};
  const PosedPart posed = pose_part(part, model, {});
  EXPECT_LT((posed.positions[2] - Vec3f(0, -1, 1)).norm(), 1e-6F);
  EXPECT_LT((posed.normals[2] - Vec3f(0, -1, 0)).norm(), 1e-6F);
  EXPECT_LT((posed.tangents[2] - Vec4f(1, 0, 0, 1)).norm(), 1e-6F);
}

TEST(PosePart, ShapesAreAddedBeforeTheSkin) {
  Part part = triangle();
  part.shapes = {
      {"up", {Vec3f(0, 0, 2), Vec3f::Zero(), Vec3f::Zero()}, {}, {}},
      {"side", {Vec3f(0, 4, 0), Vec3f::Zero(), Vec3f::Zero()}, {Vec3f(0, 1, -1), Vec3f::Zero(), Vec3f::Zero()}, {}}};
  part.skin.emplace();
  part.skin->joints = {0};
  part.skin->inverse_bind = {Affine(Eigen::Translation3d(1, 0, 0))};
  part.skin->influences = 1;
  part.skin->joint_indices.assign(3, 0);
  part.skin->weights.assign(3, 1.0F);
  const std::vector<Affine> model = {Affine(Eigen::AngleAxisd(kPi / 2, Vec3::UnitZ()))};
  const std::vector<float> weights = {0.5F, 1.0F};
  for (const SkinningMethod method : {SkinningMethod::linear, SkinningMethod::dual_quaternion}) {
    const PosedPart posed = pose_part(part, model, weights, method);
    // (0, 0, 0) + half of up + side = (0, 4, 1); bound one to the side: (1, 4, 1); a quarter turn: (-4, 1, 1).
    EXPECT_LT((posed.positions[0] - Vec3f(-4, 1, 1)).norm(), 1e-5F);
    EXPECT_LT((posed.normals[0] - Vec3f(-1, 0, 0)).norm(), 1e-6F);
    EXPECT_LT((posed.normals[1] - Vec3f::UnitZ()).norm(), 1e-6F);
  }
}

TEST(PosePart, WhatTheMeshHasNotThePosedPartHasNot) {
  Part part = triangle();
  part.mesh.normals.clear();
  part.mesh.tangents.clear();
  const PosedPart posed = pose_part(part, std::vector<Affine>{Affine::Identity()}, {});
  EXPECT_EQ(posed.positions.size(), 3U);
  EXPECT_TRUE(posed.normals.empty());
  EXPECT_TRUE(posed.tangents.empty());
}

TEST(PosePart, WrongSizesAreNamed) {
  Part part = triangle();
  const std::vector<Affine> model = {Affine::Identity()};
  const std::vector<float> weight = {1.0F};
  EXPECT_THROW(static_cast<void>(pose_part(part, model, weight)), Error);
  part.joint = 1;
  EXPECT_THROW(static_cast<void>(pose_part(part, model, {})), Error);
  part.joint = 0;
  part.shapes = {{"short", {Vec3f::Zero()}, {}, {}}};
  EXPECT_THROW(static_cast<void>(pose_part(part, model, weight)), Error);
}

TEST(PoseCharacter, PosesEveryPartWithItsOwnWeights) {
  Character character{.name = "two parts", .skeleton = Skeleton({{"root"}, {"arm", 0, {Vec3(0, 1, 0)}}})};
  Part hand = triangle();
  hand.joint = 1;
  hand.shapes = {{"open", {Vec3f(0, 0, 1), Vec3f(0, 0, 1), Vec3f(0, 0, 1)}, {}, {}}};
  hand.shape_weights = {0.25F};
  character.parts = {triangle(), hand};
  Pose pose = rest_pose(character.skeleton);
  pose.local[0].translation = Vec3(5, 0, 0);
  const std::vector<PosedPart> posed = pose_character(character, pose);
  ASSERT_EQ(posed.size(), 2U);
  EXPECT_LT((posed[0].positions[1] - Vec3f(6, 0, 0)).norm(), 1e-6F);
  EXPECT_LT((posed[1].positions[1] - Vec3f(6, 1, 0.25F)).norm(), 1e-6F);
}

}  // namespace
}  // namespace croquis
