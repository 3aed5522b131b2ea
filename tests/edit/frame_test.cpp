// SPDX-License-Identifier: MIT
#include "croquis/edit/frame.h"

#include "edit/figures.h"
#include <cmath>

#include <gtest/gtest.h>

#include "croquis/base/error.h"
#include "croquis/math/rotation.h"

namespace croquis {
namespace {

TEST(Frame, IsCountedFromZeroAndTakesEveryCurve) {
  Character character = stalk(2);
  character.clips.push_back(waving_clip(90));
  EXPECT_NEAR(rotation_angle(character_at_frame(character, 0).start.local[1].rotation), 0.0, 1e-12);
  const Character middle = character_at_frame(character, 1);
  EXPECT_NEAR(rotation_angle(middle.start.local[1].rotation), 45 * kDegree, 1e-9);
  EXPECT_NEAR(middle.start.local[0].translation.y(), 2.0, 1e-12);
  EXPECT_NEAR(rotation_angle(character_at_frame(character, 2).start.local[1].rotation), 90 * kDegree, 1e-9);
}

TEST(Frame, SetsTheShapeWeightsOfItsTime) {
  Character character = stalk(1);
  Part part;
  part.name = "face";
  part.mesh.positions = {Vec3f::Zero(), Vec3f::UnitX(), Vec3f::UnitY()};
  part.mesh.triangles = {0, 1, 2};
  part.shapes.push_back({"smile", {Vec3f::UnitZ(), Vec3f::UnitZ(), Vec3f::UnitZ()}, {}, {}});
  part.shape_weights = {0.0F};
  character.parts.push_back(part);
  Curve smile;
  smile.target = CurveTarget::weights;
  smile.joint = 0;
  smile.width = 1;
  smile.times = {0.0, 1.0};
  smile.values = {0.0, 0.75};
  character.clips.push_back({"smile", {smile}});
  EXPECT_FLOAT_EQ(character_at_frame(character, 1).parts[0].shape_weights[0], 0.75F);
}

TEST(Frame, RefusesAFrameThatIsNotThere) {
  Character character = stalk(2);
  EXPECT_THROW((void)character_at_frame(character, 0), Error);
  character.clips.push_back(waving_clip(90));
  EXPECT_THROW((void)character_at_frame(character, 3), Error);
  EXPECT_THROW((void)character_at_frame(character, -1), Error);
}

TEST(StartPose, ComesFromTheSameSkeleton) {
  Character source = stalk(3);
  source.start.local[2].rotation = rotation_from_vector(Vec3(0, 0, 1));
  const Pose pose = start_pose_of(source, stalk(3));
  EXPECT_TRUE(pose.local[2].rotation.isApprox(source.start.local[2].rotation));
}

TEST(StartPose, OverlooksEndsThatOneSideDoesNotHave) {
  Character with_end = stalk(2);
  std::vector<Joint> joints = with_end.skeleton.joints();
  joints.push_back({"j2_end", 2, {}});
  const Skeleton longer(joints);
  with_end.skeleton = longer;
  with_end.start = rest_pose(longer);
  with_end.start.local[1].rotation = rotation_from_vector(Vec3(1, 0, 0));
  EXPECT_TRUE(start_pose_of(with_end, stalk(2)).local[1].rotation.isApprox(with_end.start.local[1].rotation));
  EXPECT_EQ(start_pose_of(stalk(2), with_end).local.size(), 4U);
}

TEST(StartPose, NamesTheFirstJointThatDiffers) {
  try {
    (void)start_pose_of(cross(), stalk(4));
    FAIL() << "a cross is no stalk";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("'root'"), std::string::npos) << error.what();
  }
  EXPECT_THROW((void)start_pose_of(stalk(3), stalk(4)), Error);
}

}  // namespace
}  // namespace croquis
