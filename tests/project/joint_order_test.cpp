// SPDX-License-Identifier: MIT
#include "croquis/project/joint_order.h"

#include <gtest/gtest.h>

#include "croquis/base/error.h"

namespace croquis {
namespace {

//  hips -- a -- b
//     \--- c        in the order hips, a, c, b
Character branched() {
  const Skeleton skeleton(
      {{"hips", -1, {}}, {"a", 0, {Vec3(0, 1, 0)}}, {"c", 0, {Vec3(0, -1, 0)}}, {"b", 1, {Vec3(0, 2, 0)}}});
  Character character{.name = "branched", .skeleton = skeleton, .start = rest_pose(skeleton)};
  character.start.local[3].translation = Vec3(0, 3, 0);
  character.humanoid.set(HumanoidBone::hips, 0, 1.0);
  character.humanoid.set(HumanoidBone::head, 3, 1.0);
  Skin skin;
  skin.joints = {2, 3};
  character.parts.push_back({.name = "skinned", .skin = skin, .joint = 3});
  character.clips.push_back({"move", {Curve{.joint = 2}, Curve{.target = CurveTarget::weights, .joint = 0}}});
  return character;
}

TEST(JointOrder, EachJointIsFollowedByAllThatHangsOnIt) {
  const Character before = branched();
  const Character after = in_file_order(before);
  std::vector<std::string> names;
  for (const Joint& joint : after.skeleton.joints()) names.push_back(joint.name);
  EXPECT_EQ(names, (std::vector<std::string>{"hips", "a", "b", "c"}));
  EXPECT_EQ(after.skeleton.parent(2), 1);
  EXPECT_EQ(after.skeleton.parent(3), 0);
}

TEST(JointOrder, EverythingThatNamesAJointFollowsIt) {
  const Character after = in_file_order(branched());
  EXPECT_EQ(after.start.local[2].translation, Vec3(0, 3, 0));
  EXPECT_EQ(after.humanoid.joint(HumanoidBone::head), 2);
  EXPECT_FALSE(after.humanoid.has(HumanoidBone::neck));
  EXPECT_EQ(after.parts[0].joint, 2);
  EXPECT_EQ(after.parts[0].skin->joints, (std::vector<int>{3, 2}));
  EXPECT_EQ(after.clips[0].curves[0].joint, 3);
  EXPECT_EQ(after.clips[0].curves[1].joint, 0) << "of weights it is a part";
}

TEST(JointOrder, DoneTwiceItIsDoneOnce) {
  const Character once = in_file_order(branched());
  const Character twice = in_file_order(once);
  for (int i = 0; i < once.skeleton.joint_count(); ++i) EXPECT_EQ(twice.skeleton.name(i), once.skeleton.name(i));
  EXPECT_EQ(twice.start, once.start);
}

TEST(JointOrder, ACharacterOfAFileIsRefused) {
  Character character = branched();
  character.source = std::make_shared<const SourceFile>();
  EXPECT_THROW((void)in_file_order(character), Error);
}

}  // namespace
}  // namespace croquis
