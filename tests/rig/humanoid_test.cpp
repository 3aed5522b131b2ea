// SPDX-License-Identifier: MIT
#include "croquis/rig/humanoid.h"

#include "rig/rigs.h"
#include "support/random_math.h"
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "croquis/rig/pose.h"

namespace croquis {
namespace {

std::vector<HumanoidBone> all_bones() {
  std::vector<HumanoidBone> bones;
  for (int i = 0; i < kHumanoidBoneCount; ++i) bones.push_back(static_cast<HumanoidBone>(i));
  return bones;
}

struct Score {
  int right = 0, all = 0;
  std::string wrong;
};

/// Every bone that is labelled or that was found counts.
Score compare(const LabelledRig& rig, const HumanoidMap& found) {
  Score score;
  for (const HumanoidBone bone : all_bones()) {
    if (!rig.labels.has(bone) && !found.has(bone)) continue;
    ++score.all;
    if (rig.labels.joint(bone) == found.joint(bone)) {
      ++score.right;
      continue;
    }
    const auto show = [&](int i) {
      return i < 0 ? std::string("none") : "#" + std::to_string(i) + " " + rig.joints[static_cast<std::size_t>(i)].name;
    };
    score.wrong += "\n  " + std::string(to_string(bone)) + ": is " + show(rig.labels.joint(bone)) + ", found " +
                   show(found.joint(bone));
  }
  return score;
}

TEST(HumanoidBone, NamesAreVrmsAndMirrorSwapsSides) {
  EXPECT_EQ(to_string(HumanoidBone::upperChest), "upperChest");
  EXPECT_EQ(to_string(HumanoidBone::rightLittleDistal), "rightLittleDistal");
  EXPECT_FALSE(parse_humanoid_bone("UpperChest").has_value());
  EXPECT_EQ(mirror(HumanoidBone::leftIndexProximal), HumanoidBone::rightIndexProximal);
  EXPECT_EQ(mirror(HumanoidBone::jaw), HumanoidBone::jaw);
  for (const HumanoidBone bone : all_bones()) {
    EXPECT_EQ(parse_humanoid_bone(to_string(bone)), bone);
    EXPECT_EQ(mirror(mirror(bone)), bone);
  }
}

TEST(RecogniseHumanoid, BonesOfTheLabelledRigsAreFound) {
  int right = 0, all = 0;
  for (const LabelledRig& rig : labelled_rigs()) {
    if (!rig.is_humanoid()) continue;
    const Score score = compare(rig, recognise_humanoid(rig.skeleton()));
    right += score.right;
    all += score.all;
    EXPECT_GE(score.right, 0.9 * score.all) << rig.name << score.wrong;
  }
  EXPECT_GT(all, 1200);
  EXPECT_GE(right, 0.98 * all);
}

TEST(RecogniseHumanoid, OtherBodiesGiveAnEmptyMap) {
  for (const LabelledRig& rig : labelled_rigs()) {
    if (rig.is_humanoid()) continue;
    const HumanoidMap found = recognise_humanoid(rig.skeleton());
    for (const HumanoidBone bone : all_bones()) {
      EXPECT_FALSE(found.has(bone)) << rig.name << ": " << to_string(bone);
    }
  }
}

LabelledRig without_names(LabelledRig rig) {
  for (std::size_t i = 0; i < rig.joints.size(); ++i) {
    const bool end = rig.joints[i].name.ends_with("_end");  // so a BVH reader names End Sites, whatever the joints
    rig.joints[i].name = "joint_" + std::to_string(i) + (end ? "_end" : "");
  }
  return rig;
}

TEST(RecogniseHumanoid, WithoutNamesHierarchyAndGeometryFindTheLimbs) {
  using enum HumanoidBone;
  int right = 0, all = 0;
  for (const LabelledRig& rig : labelled_rigs()) {
    const HumanoidMap found = recognise_humanoid(without_names(rig).skeleton());
    if (!rig.is_humanoid()) {
      EXPECT_FALSE(found.has(hips)) << rig.name;
      continue;
    }
    for (const HumanoidBone bone :
         {hips, head, leftUpperLeg, leftLowerLeg, leftFoot, rightUpperLeg, rightLowerLeg, rightFoot, leftUpperArm,
          leftLowerArm, leftHand, rightUpperArm, rightLowerArm, rightHand}) {
      if (!rig.labels.has(bone)) continue;
      ++all;
      right += found.joint(bone) == rig.labels.joint(bone) ? 1 : 0;
    }
  }
  // What is left are rest poses that no body can take (zeroed mocap), feet that hang elsewhere, and sides of bodies
  // that show no front.
  EXPECT_GE(right, 0.85 * all) << right << " of " << all;
}

TEST(RecogniseHumanoid, WhatNamesSayIsSurerThanWhatGeometryGuesses) {
  const LabelledRig& rig = labelled_rig("gltf/quaternius_man_casual.glb");
  const HumanoidMap named = recognise_humanoid(rig.skeleton()),
                    guessed = recognise_humanoid(without_names(rig).skeleton());
  for (const HumanoidBone bone : {HumanoidBone::hips, HumanoidBone::leftLowerArm, HumanoidBone::rightFoot}) {
    const auto at = static_cast<std::size_t>(bone);
    EXPECT_GT(named.entries[at].confidence, 0.9);
    EXPECT_LT(guessed.entries[at].confidence, 0.6);
    EXPECT_GT(guessed.entries[at].confidence, 0.0);
    EXPECT_EQ(named.bone_of(named.joint(bone)), bone);
  }
  EXPECT_FALSE(named.bone_of(-1).has_value());
  EXPECT_TRUE(named.is_humanoid());
}

TEST(RecogniseHumanoid, SidesWithoutNamesComeFromWhereFeetPoint) {
  // CesiumMan has no names, and its toes point to +X; turned about, the sides turn with it.
  const LabelledRig& rig = labelled_rig("gltf/cesium_man.gltf");
  for (const double angle : {0.0, 1.0, kPi}) {
    LabelledRig turned = rig;
    turned.joints[0].rest.rotation = Quat(Eigen::AngleAxisd(angle, Vec3::UnitY()));
    EXPECT_EQ(compare(rig, recognise_humanoid(turned.skeleton())).wrong, "");
  }
}

TEST(RecogniseHumanoid, TreesOfEveryOtherKindAreRefusedInShortTime) {
  EXPECT_FALSE(recognise_humanoid(Skeleton({Joint{}})).has(HumanoidBone::hips));
  std::vector<Joint> chain(20000), star(3000), comb(4000);
  for (int i = 1; i < 20000; ++i) chain[static_cast<std::size_t>(i)].parent = i - 1;
  for (int i = 1; i < 3000; ++i) star[static_cast<std::size_t>(i)].parent = 0;
  for (int i = 1; i < 4000; ++i) comb[static_cast<std::size_t>(i)].parent = (i - 1) / 2;
  for (const auto& joints : {chain, star, comb}) {
    EXPECT_FALSE(recognise_humanoid(Skeleton(joints)).has(HumanoidBone::hips));
  }
}

std::vector<Vec3> rest_positions(const Skeleton& skeleton) { return compute_positions(skeleton, rest_pose(skeleton)); }

TEST(ComputeFacing, IsWhereTheBodyLooksHoweverItIsTurned) {
  const LabelledRig& rig = labelled_rig("gltf/m2m_human_male_custom_clip.glb");
  std::vector<Vec3> positions = rest_positions(rig.skeleton());
  EXPECT_TRUE(compute_facing(rig.labels, positions).isApprox(Vec3::UnitZ(), 1e-6));
  const Quat turn(Eigen::AngleAxisd(2.0, Vec3::UnitY()));
  for (Vec3& p : positions) p = turn * p;
  EXPECT_TRUE(compute_facing(rig.labels, positions).isApprox(turn * Vec3::UnitZ(), 1e-6));
  const LabelledRig& vrm0 = labelled_rig("vrm/cryptovoxels_vrm0.vrm");
  EXPECT_LT(compute_facing(vrm0.labels, rest_positions(vrm0.skeleton())).z(), -0.99);
  EXPECT_EQ(compute_facing(HumanoidMap{}, positions), Vec3::UnitZ());
}

}  // namespace
}  // namespace croquis
