// SPDX-License-Identifier: MIT
#include "body/body_checks.h"

#include <gtest/gtest.h>

#include "croquis/body/body.h"

namespace croquis {
namespace {

const Character& mannequin() {
  static const Character character = make_builtin_character("mannequin");
  return character;
}

const Part& body() { return mannequin().parts.front(); }

Vec3 joint(HumanoidBone bone) { return mannequin().skeleton.rest_position(mannequin().humanoid.joint(bone)); }

double volume_kept(const std::vector<std::tuple<std::string, Vec3, double>>& turns, HumanoidBone around,
                   double radius) {
  Pose pose = mannequin().start;
  for (const auto& [name, axis, degrees] : turns) turn(mannequin(), pose, name, axis, degrees);
  const std::vector<Vec3f> bent = skin_linearly(mannequin(), body(), pose);
  return volume_around(body().mesh, bent, joint(around), radius) /
         volume_around(body().mesh, body().mesh.positions, joint(around), radius);
}

const Vec3 kX = Vec3::UnitX(), kY = Vec3::UnitY(), kZ = Vec3::UnitZ();

TEST(Mannequin, IsASoundCharacter) {
  EXPECT_NO_THROW(mannequin().check());
  EXPECT_EQ(mannequin().start.local.size(), mannequin().skeleton.joints().size());
}

TEST(Mannequin, HasEveryHumanoidBoneButEyesAndJaw) {
  for (int b = 0; b < kHumanoidBoneCount; ++b) {
    const auto bone = static_cast<HumanoidBone>(b);
    const bool left_out = bone == HumanoidBone::leftEye || bone == HumanoidBone::rightEye || bone == HumanoidBone::jaw;
    EXPECT_EQ(mannequin().humanoid.has(bone), !left_out) << to_string(bone);
    if (left_out) continue;
    EXPECT_EQ(mannequin().skeleton.name(mannequin().humanoid.joint(bone)), to_string(bone));
    EXPECT_EQ(mannequin().humanoid.entries[static_cast<std::size_t>(b)].confidence, 1.0);
  }
}

TEST(Mannequin, StandsInATPoseFacingPlusZWithItsSolesOnTheGround) {
  Box box;
  for (const Vec3f& p : body().mesh.positions) box.extend(p.cast<double>());
  EXPECT_NEAR(box.min().y(), 0.0, 0.003);
  EXPECT_NEAR(box.max().y(), 1.76, 0.01);
  EXPECT_GT(joint(HumanoidBone::leftHand).x(), 0.5) << "left is +X for a body that faces +Z";
  EXPECT_NEAR(joint(HumanoidBone::leftHand).y(), joint(HumanoidBone::leftUpperArm).y(), 0.01);
  EXPECT_GT(joint(HumanoidBone::leftToes).z(), joint(HumanoidBone::leftFoot).z() + 0.05);
  EXPECT_GT(joint(HumanoidBone::leftThumbDistal).z(), joint(HumanoidBone::leftIndexDistal).z()) << "palms down";
}

TEST(Mannequin, HasTheProportionsOfTheEightHeadCanon) {
  const double height = 1.76;
  EXPECT_NEAR(joint(HumanoidBone::leftLowerLeg).y() / height, 0.27, 0.02) << "knee";
  EXPECT_NEAR(joint(HumanoidBone::leftUpperLeg).y() / height, 0.53, 0.02) << "hip joint, above the crotch";
  const double upper = (joint(HumanoidBone::leftLowerArm) - joint(HumanoidBone::leftUpperArm)).norm();
  const double lower = (joint(HumanoidBone::leftHand) - joint(HumanoidBone::leftLowerArm)).norm();
  const double hanging_elbow = joint(HumanoidBone::leftUpperArm).y() - upper;
  EXPECT_NEAR(hanging_elbow / height, 0.64, 0.02) << "elbow at the waist";
  EXPECT_NEAR((hanging_elbow - lower) / height, 0.495, 0.02) << "wrist at the crotch";
  double span = 0.0;
  for (const Vec3f& p : body().mesh.positions) span = std::max(span, 2.0 * static_cast<double>(p.x()));
  EXPECT_NEAR(span / height, 1.0, 0.03) << "arm span";
}

TEST(Mannequin, IsOneClosedSurfaceOfGoodTriangles) {
  const MeshFacts facts = examine(body().mesh);
  EXPECT_EQ(facts.loose_edges, 0);
  EXPECT_EQ(facts.euler, 2);
  EXPECT_GT(facts.smallest_angle_degrees, 20.0);
  EXPECT_LT(facts.odd_normals, body().mesh.triangle_count() / 100);
  EXPECT_GT(signed_volume(body().mesh.positions, body().mesh.triangles), 0.03) << "triangles face outwards";
  EXPECT_GE(body().mesh.vertex_count(), 6000);
  EXPECT_LE(body().mesh.vertex_count(), 15000);
}

TEST(Mannequin, IsItsOwnMirrorImage) {
  std::map<std::array<float, 3>, std::size_t> places;
  const Mesh& mesh = body().mesh;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Vec3f& p = mesh.positions[v];
    places[{p.x(), p.y(), p.z()}] = v;
  }
  for (const Vec3f& p : mesh.positions) EXPECT_TRUE(places.contains({p.x() == 0.0F ? 0.0F : -p.x(), p.y(), p.z()}));
}

TEST(Mannequin, HasWeightsThatSumToOneOfAtMostFourJoints) {
  const Skin& skin = *body().skin;
  EXPECT_EQ(skin.influences, 4);
  for (std::size_t v = 0; v < body().mesh.positions.size(); ++v) {
    float sum = 0.0F;
    for (std::size_t k = 4 * v; k < 4 * v + 4; ++k) sum += skin.weights[k];
    EXPECT_NEAR(sum, 1.0F, 1e-5F);
  }
}

TEST(Mannequin, KeepsItsVolumeAroundBentJoints) {
  using enum HumanoidBone;
  EXPECT_NEAR(volume_kept({{"leftLowerArm", -kY, 120.0}}, leftLowerArm, 0.12), 1.0, 0.15) << "elbow";
  EXPECT_NEAR(volume_kept({{"leftLowerLeg", kX, 130.0}}, leftLowerLeg, 0.18), 1.0, 0.15) << "knee";
  EXPECT_NEAR(volume_kept({{"leftShoulder", kZ, 20.0}, {"leftUpperArm", kZ, 65.0}}, leftUpperArm, 0.15), 1.0, 0.15)
      << "arm up";
  EXPECT_NEAR(volume_kept({{"leftUpperLeg", -kX, 100.0}}, leftUpperLeg, 0.22), 1.0, 0.15) << "hip";
  EXPECT_NEAR(volume_kept({{"leftHand", -kZ, 80.0}}, leftHand, 0.08), 1.0, 0.15) << "wrist";
  EXPECT_NEAR(volume_kept({{"spine", kY, 20.0}, {"chest", kY, 20.0}, {"upperChest", kY, 20.0}}, chest, 0.25), 1.0, 0.15)
      << "spine";
}

}  // namespace
}  // namespace croquis
