// SPDX-License-Identifier: MIT
#include "croquis/rig/mirror.h"

#include "rig/rigs.h"
#include "support/random_math.h"
#include <algorithm>
#include <string>

#include <gtest/gtest.h>

namespace croquis {
namespace {

std::vector<int> map_of(const Skeleton& skeleton) { return compute_mirror_map(skeleton, recognise_humanoid(skeleton)); }

Skeleton renamed(const LabelledRig& rig) {
  std::vector<Joint> joints = rig.joints;
  for (std::size_t i = 0; i < joints.size(); ++i) joints[i].name = "node" + std::to_string(i);
  return Skeleton(joints);
}

/// How many joints have another partner in the second map.
int differences(const std::vector<int>& a, const std::vector<int>& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += a[i] != b[i] ? 1 : 0;
  return count;
}

int paired(const std::vector<int>& map) {
  int count = 0;
  for (std::size_t i = 0; i < map.size(); ++i) count += map[i] != static_cast<int>(i) ? 1 : 0;
  return count;
}

TEST(MirrorMap, IsAnInvolutionOnEveryRig) {
  for (const LabelledRig& rig : labelled_rigs()) {
    for (const Skeleton& skeleton : {rig.skeleton(), renamed(rig)}) {
      const std::vector<int> map = map_of(skeleton);
      ASSERT_EQ(std::ssize(map), skeleton.joint_count());
      for (std::size_t i = 0; i < map.size(); ++i) {
        ASSERT_EQ(map[static_cast<std::size_t>(map[i])], static_cast<int>(i)) << rig.name;
      }
    }
  }
}

TEST(MirrorMap, FollowsTheLabels) {
  for (const LabelledRig& rig : labelled_rigs()) {
    if (!rig.is_humanoid()) continue;
    const std::vector<int> map = map_of(rig.skeleton());
    for (int i = 0; i < kHumanoidBoneCount; ++i) {
      const auto bone = static_cast<HumanoidBone>(i);
      if (!rig.labels.has(bone) || !rig.labels.has(mirror(bone))) continue;
      EXPECT_EQ(map[static_cast<std::size_t>(rig.labels.joint(bone))], rig.labels.joint(mirror(bone))) << rig.name;
    }
  }
}

TEST(MirrorMap, FindsPartnersByHandOnAnAnimal) {
  const LabelledRig& rig = labelled_rig("none/gltf/quaternius_frog.glb");
  const Skeleton frog = rig.skeleton();
  const std::vector<int> map = map_of(frog);
  const auto partner = [&](const char* name) { return frog.name(map[static_cast<std::size_t>(frog.resolve(name))]); };
  EXPECT_EQ(partner("BackUpLeg.L"), "BackUpLeg.R");
  EXPECT_EQ(partner("FrontLeg.L"), "FrontLeg.L.001");  // the file's slip; the place tells
  EXPECT_EQ(partner("Head"), "Head");
  EXPECT_EQ(partner("Torso"), "Torso");
}

TEST(MirrorMap, WithoutNamesIsTheSameAsWithThem) {
  for (const char* name : {"gltf/cesium_man.gltf", "gltf/kaykit_knight.glb", "gltf/quaternius_man_casual.glb",
                           "gltf/m2m_human_male_custom_clip.glb", "bvh/cmu_01_01.bvh",
                           "bvh/makehuman_tpose_blender.bvh", "gltf/m2m_zombie_variation.glb", "none/gltf/m2m_fox.glb",
                           "none/gltf/fox_khronos.glb", "none/gltf/quaternius_cow.glb", "none/gltf/quaternius_wolf.glb",
                           "none/gltf/quaternius_frog.glb", "none/gltf/m2m_spider.glb", "none/gltf/m2m_bird.glb"}) {
    const std::vector<int> named = map_of(labelled_rig(name).skeleton()), unnamed = map_of(renamed(labelled_rig(name)));
    EXPECT_EQ(differences(named, unnamed), 0) << name;
    EXPECT_GT(paired(named), 8) << name;
  }
}

TEST(MirrorMap, WithoutNamesIsTheSameForAlmostEveryJointOfEveryRig) {
  int all = 0, different = 0;
  for (const LabelledRig& rig : labelled_rigs()) {
    all += static_cast<int>(rig.joints.size());
    different += differences(map_of(rig.skeleton()), map_of(renamed(rig)));
  }
  // Zeroed mocap rests lie in ways that no plane makes symmetrical.
  EXPECT_LT(different, 0.04 * all) << different << " of " << all;
}

TEST(MirrorMap, SmallAndLargeTreesAreMapped) {
  EXPECT_EQ(map_of(Skeleton({Joint{}})), (std::vector<int>{0}));
  // Three joints in a row and two beside them, all without names.
  Joint left{"", 0, {Vec3(1, 0, 0)}}, right{"", 0, {Vec3(-1, 0, 0)}}, middle{"", 0, {Vec3(0, 1, 0)}};
  EXPECT_EQ(map_of(Skeleton({Joint{}, left, middle, right})), (std::vector<int>{0, 3, 2, 1}));
  std::vector<Joint> star(3000);
  for (std::size_t i = 1; i < star.size(); ++i) star[i].parent = 0;
  EXPECT_EQ(paired(map_of(Skeleton(star))), 0);
}

TEST(MirrorMap, TurnedAndMovedBodiesHaveTheSameMap) {
  for (const char* name : {"none/gltf/m2m_fox.glb", "none/gltf/m2m_spider.glb", "gltf/cesium_man.gltf"}) {
    LabelledRig rig = labelled_rig(name);
    const std::vector<int> before = map_of(renamed(rig));
    rig.joints[0].rest.rotation = Quat(Eigen::AngleAxisd(1.2, Vec3(1, 2, 3).normalized()));
    rig.joints[0].rest.translation += Vec3(3, -1, 2);
    EXPECT_EQ(map_of(renamed(rig)), before) << name;
  }
}

}  // namespace
}  // namespace croquis
