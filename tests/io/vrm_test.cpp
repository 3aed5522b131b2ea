// SPDX-License-Identifier: MIT
#include "croquis/io/vrm.h"

#include "io/written_files.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "croquis/base/error.h"
#include "croquis/io/glb_container.h"
#include "croquis/math/rotation.h"

namespace croquis {
namespace {

std::optional<Character> open(const std::string& name) {
  const auto path = data_file(name);
  return path ? std::optional(read_from(*path)) : std::nullopt;
}

/// A humanoid of the fifteen bones that VRM requires, one above the other; it faces `front`.
Character tower_humanoid(const Vec3& front) {
  const std::vector<HumanoidBone> bones = {
      HumanoidBone::hips,          HumanoidBone::spine,         HumanoidBone::head,
      HumanoidBone::leftUpperLeg,  HumanoidBone::leftLowerLeg,  HumanoidBone::leftFoot,
      HumanoidBone::rightUpperLeg, HumanoidBone::rightLowerLeg, HumanoidBone::rightFoot,
      HumanoidBone::leftUpperArm,  HumanoidBone::leftLowerArm,  HumanoidBone::leftHand,
      HumanoidBone::rightUpperArm, HumanoidBone::rightLowerArm, HumanoidBone::rightHand};
  std::vector<Joint> joints = {{.name = "scene", .helper = true}};
  HumanoidMap humanoid;
  for (std::size_t i = 0; i < bones.size(); ++i) {
    joints.push_back(
        {.name = "bone " + std::to_string(i), .parent = static_cast<int>(i), .rest = {.translation = Vec3(0, 0.1, 0)}});
    humanoid.set(bones[i], static_cast<int>(i) + 1, 1.0);
  }
  Character character{.name = "tower", .skeleton = Skeleton(std::move(joints))};
  character.start = rest_pose(character.skeleton);
  character.humanoid = humanoid;
  character.front = front;
  return character;
}

TEST(Vrm, TheHumanoidStandsInTheFileItself) {
  const auto character = open("vrm/addon_basic_armature.vrm");
  if (!character) GTEST_SKIP() << "no shared data";
  EXPECT_TRUE(character->humanoid.is_humanoid());
  const auto& hips = character->humanoid.entries[static_cast<std::size_t>(HumanoidBone::hips)];
  EXPECT_EQ(hips.confidence, 1.0);
  EXPECT_EQ(character->front, Vec3(-Vec3::UnitZ())) << "VRM 0.x faces -Z";
  for (int i = 0; i < character->skeleton.joint_count(); ++i) {
    EXPECT_EQ(character->skeleton.joint(i).helper, !character->humanoid.bone_of(i)) << character->skeleton.name(i);
  }
}

TEST(Vrm, TheLicenceIsToldInTheFilesWords) {
  const auto vrm1 = open("vrm/debug_robot_vrm1.vrm");
  if (!vrm1) GTEST_SKIP() << "no shared data";
  ASSERT_TRUE(vrm1->licence);
  EXPECT_EQ(vrm1->front, Vec3(Vec3::UnitZ()));
  EXPECT_FALSE(vrm1->licence->title.empty());
  EXPECT_EQ(vrm1->licence->name, "https://vrm.dev/licenses/1.0/");
  const auto vrm0 = open("vrm/cryptovoxels_vrm0.vrm");
  ASSERT_TRUE(vrm0->licence);
  EXPECT_FALSE(vrm0->licence->authors.empty());
  EXPECT_EQ(vrm0->licence->terms.count("allowedUserName"), 1U);
}

TEST(Vrm, ThumbsOfVrm0GetTheNamesOfVrm1) {
  const auto character = open("vrm/addon_basic_armature.vrm");
  if (!character) GTEST_SKIP() << "no shared data";
  const auto glb = parse_glb(character->source->bytes);
  const auto json = nlohmann::json::parse(glb.json);
  for (const auto& bone : json["extensions"]["VRM"]["humanoid"]["humanBones"]) {
    if (bone["bone"] != "leftThumbProximal") continue;
    const int joint = character->humanoid.joint(HumanoidBone::leftThumbMetacarpal);
    ASSERT_GE(joint, 0);
    EXPECT_EQ(character->source_nodes[static_cast<std::size_t>(joint)], bone["node"].get<int>());
  }
}

TEST(Vrm, AHumanoidOfAnotherFileBecomesAVrmOneThatReadsBack) {
  const auto path = data_file("bvh/cmu_01_01.bvh");
  Character character = path ? read_from(*path) : tower_humanoid(Vec3::UnitZ());
  if (!character.humanoid.is_humanoid()) character = tower_humanoid(Vec3::UnitZ());
  character.licence = Licence{.title = "Walker", .authors = "A person"};
  const WrittenFile file = write_character(character, character.start, "vrm", "a.vrm");
  keep_for_validator(file, "vrm/a.vrm", "");
  const Character back = read_back(file, "a.vrm");
  ASSERT_TRUE(back.licence);
  EXPECT_EQ(back.licence->title, "Walker");
  EXPECT_EQ(back.licence->authors, "A person");
  for (int i = 0; i < kHumanoidBoneCount; ++i) {
    const auto bone = static_cast<HumanoidBone>(i);
    ASSERT_EQ(back.humanoid.has(bone), character.humanoid.has(bone)) << to_string(bone);
    if (!back.humanoid.has(bone)) continue;
    EXPECT_EQ(back.skeleton.name(back.humanoid.joint(bone)), character.skeleton.name(character.humanoid.joint(bone)));
  }
}

TEST(Vrm, WhatIsNoHumanoidIsRefusedByTheBonesThatItLacks) {
  Character character = tower_humanoid(Vec3::UnitZ());
  character.humanoid.entries[static_cast<std::size_t>(HumanoidBone::leftFoot)].joint = -1;
  for (const char* format : {"vrm", "vrma"}) {
    try {
      (void)write_character(character, character.start, format, "a.vrm");
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::unsupported);
      EXPECT_NE(std::string(error.what()).find("leftFoot"), std::string::npos) << error.what();
    }
  }
}

TEST(Vrm, AnAnimationHoldsThePoseInTermsOfTheHumanoidAlone) {
  const Character character = tower_humanoid(-Vec3::UnitZ());
  Pose pose = character.start;
  pose.local[0].rotation = rotation_from_vector(Vec3(0, 0, 0.5));  // the helper above the hips: no bone
  pose.local[0].translation = Vec3(0, 2, 0);
  pose.local[5].rotation = rotation_from_vector(Vec3(0.3, 0, 0));
  const WrittenFile file = write_character(character, pose, "vrma", "a.vrma");
  keep_for_validator(file, "vrma/a.vrma", "");
  const Character back = read_back(file, "a.vrma");
  ASSERT_EQ(back.clips.size(), 1U);
  const Pose shown = sample_pose(back.clips[0], 0.0, back.start);
  const auto wanted = compute_model_transforms(character.skeleton, pose);
  const auto found = compute_model_transforms(back.skeleton, shown);
  const Affine turned(Eigen::AngleAxisd(kPi, Vec3::UnitY()));  // VRMA faces +Z
  for (int i = 0; i < kHumanoidBoneCount; ++i) {
    const auto bone = static_cast<HumanoidBone>(i);
    if (!character.humanoid.has(bone)) continue;
    const Affine a = turned * wanted[static_cast<std::size_t>(character.humanoid.joint(bone))];
    const Affine b = found[static_cast<std::size_t>(back.humanoid.joint(bone))];
    EXPECT_LT((a.matrix() - b.matrix()).cwiseAbs().maxCoeff(), 1e-6) << to_string(bone);
  }
  for (const Curve& curve : back.clips[0].curves) {
    EXPECT_TRUE(curve.target == CurveTarget::rotation || curve.joint == back.humanoid.joint(HumanoidBone::hips));
  }
}

TEST(Vrm, AnAnimationFileIsAHumanoidWithItsClip) {
  const auto character = open("vrm/hips_spine_twisting.vrma");
  if (!character) GTEST_SKIP() << "no shared data";
  EXPECT_TRUE(character->humanoid.has(HumanoidBone::hips));
  ASSERT_EQ(character->clips.size(), 1U);
  EXPECT_GT(character->clips[0].frame_count(), 1);
}

}  // namespace
}  // namespace croquis
