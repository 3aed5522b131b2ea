// SPDX-License-Identifier: MIT
#include "croquis/rig/joint_name.h"

#include <gtest/gtest.h>

namespace croquis {
namespace {

NameRole role_of(std::string_view name) {
  const JointName read = read_joint_name(name);
  EXPECT_FALSE(read.roles.empty()) << name;
  return read.roles.empty() ? NameRole::carrier : read.roles.front().first;
}

TEST(JointName, ReadsTheWordsOfManyPrograms) {
  EXPECT_EQ(role_of("mixamorig12:LeftForeArm"), NameRole::lower_arm);
  EXPECT_EQ(role_of("Bip01 L UpperArm"), NameRole::upper_arm);
  EXPECT_EQ(role_of("ValveBiped.Bip01_R_Calf"), NameRole::lower_leg);
  EXPECT_EQ(role_of("DEF-upper_arm.L.001"), NameRole::upper_arm);
  EXPECT_EQ(role_of("lForearmBend"), NameRole::lower_arm);
  EXPECT_EQ(role_of("LHipJoint"), NameRole::carrier);
  EXPECT_EQ(role_of("LeftHip"), NameRole::upper_leg);
  EXPECT_EQ(role_of("hip"), NameRole::hips);
  EXPECT_EQ(role_of("LowerBack"), NameRole::spine);
  EXPECT_EQ(role_of("CC_Base_NeckTwist01"), NameRole::neck);
  EXPECT_EQ(role_of("thumb_intermediate.L"), NameRole::thumb);
  EXPECT_EQ(role_of("左足首"), NameRole::foot);
}

TEST(JointName, ReadsSidesWhereverTheyStand) {
  for (const char* left :
       {"LeftArm", "left_arm", "arm.L", "Arm_l", "lArm", "larm", "L_Arm", "leftarm", "FootL", "左腕"}) {
    EXPECT_EQ(read_joint_name(left).side, NameSide::left) << left;
  }
  for (const char* right : {"RightArm", "arm-right", "R Arm", "rhand", "handr", "Palm2R", "右腕"}) {
    EXPECT_EQ(read_joint_name(right).side, NameSide::right) << right;
  }
  for (const char* none : {"lowerback", "ring", "radius", "ball", "Spine", "root", "calf", ""}) {
    EXPECT_EQ(read_joint_name(none).side, NameSide::none) << none;
  }
}

TEST(JointName, WhatIsNoPartOfABodyIsIgnored) {
  for (const char* name : {"IK-foot.l", "HeadTop_End", "LeftHand_end", "upperarm_twist_01_l", "Front_Leg_Upper_L",
                           "Bip01 HeadNub", "hair_head", "__Clavicle_L", "index_04_leaf_l"}) {
    EXPECT_TRUE(read_joint_name(name).ignored) << name;
    EXPECT_LT(read_joint_name(name).affinity(NameRole::upper_arm), 0.0) << name;
  }
  EXPECT_TRUE(read_joint_name("joint_7").says_nothing());
  EXPECT_TRUE(read_joint_name("").says_nothing());
  EXPECT_TRUE(read_joint_name("\xff\xfe(:|").says_nothing());
}

TEST(JointName, NumbersAreThoseBehindTheLastWord) {
  EXPECT_EQ(read_joint_name("Bip01 L Finger02").numbers, (std::vector<std::string>{"02"}));
  EXPECT_EQ(read_joint_name("finger4-2.R").numbers, (std::vector<std::string>{"4", "2"}));
  EXPECT_EQ(read_joint_name("Thumb2L").number(), 2);
  EXPECT_EQ(read_joint_name("head").number(), -1);
}

TEST(SplitSide, PartnersHaveTheSameRemainder) {
  const std::pair<const char*, const char*> partners[] = {
      {"LeftArm", "RightArm"},      {"arm_l", "arm_r"},
      {"Bone.L.001", "Bone.R.001"}, {"lShldr", "rShldr"},
      {"leg_a_1_l", "leg_a_1_r"},   {"FFB.L", "FFB.R"},
      {"lhand", "rhand"},           {"mixamorig:LeftHandIndex1", "mixamorig:RightHandIndex1"}};
  for (const auto& [left, right] : partners) {
    EXPECT_EQ(split_side(left).first, NameSide::left) << left;
    EXPECT_EQ(split_side(right).first, NameSide::right) << right;
    EXPECT_EQ(split_side(left).second, split_side(right).second);
  }
  EXPECT_EQ(split_side("Spine1").first, NameSide::none);
  EXPECT_NE(split_side("arm_l_1").second, split_side("arm_r_2").second);
}

}  // namespace
}  // namespace croquis
