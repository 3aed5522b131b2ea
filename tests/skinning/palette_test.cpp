// SPDX-License-Identifier: MIT
#include "croquis/skinning/palette.h"

#include "skinning/random_skin.h"
#include <limits>

#include <gtest/gtest.h>

#include "croquis/base/error.h"

namespace croquis {
namespace {

TEST(Palette, RigidJointsNeedOneMatrixOrOneDualQuaternion) {
  Random random(1);
  const std::vector<Affine> matrices = random_rigid_palette(random, 30);
  EXPECT_TRUE(SkinningPalette(matrices).normal_matrices().empty());
  EXPECT_TRUE(SkinningPalette(matrices, {}, SkinningMethod::dual_quaternion).matrices().empty());
}

TEST(Palette, RigidJointsStoredAsFloatsAreRigidStill) {
  Random random(2);
  std::vector<Affine> matrices = random_rigid_palette(random, 30);
  for (Affine& matrix : matrices) matrix = Affine(matrix.cast<float>().cast<double>());
  EXPECT_TRUE(SkinningPalette(matrices).normal_matrices().empty());
  EXPECT_TRUE(SkinningPalette(matrices, {}, SkinningMethod::dual_quaternion).matrices().empty());
}

TEST(Palette, StretchThenRigidMotionIsTheMatrixAndTheJointStaysWhereItBelongs) {
  Random random(3);
  for (int round = 0; round < 50; ++round) {
    std::vector<Affine> matrices = random_rigid_palette(random, 5);
    std::vector<Vec3> centres;
    for (Affine& matrix : matrices) {
      centres.push_back(random_vector(random));
      matrix.linear() += 0.4 * Mat3::NullaryExpr([&] { return random.normal(); });
    }
    const SkinningPalette palette(matrices, centres, SkinningMethod::dual_quaternion);
    for (std::size_t i = 0; i < matrices.size(); ++i) {
      RandomSkin skin;
      skin.influences = 1;
      skin.indices.assign(2, static_cast<std::uint16_t>(i));
      skin.weights.assign(2, 1.0F);
      skin.positions = {centres[i].cast<float>(), random_vector(random).cast<float>()};
      const Skinned out = skinned(palette, skin);
      for (std::size_t v = 0; v < 2; ++v) {
        EXPECT_LT((out.positions[v].cast<double>() - matrices[i] * skin.positions[v].cast<double>()).norm(), 3e-5);
      }
    }
  }
}

TEST(Palette, AJointScaledAboutItselfMovesNoVertexOfItsNeighbour) {
  // Two joints on one line, the second one swollen: half of each is halfway between the two.
  const Vec3 centre(10, 0, 0);
  Affine swollen = Affine::Identity();
  swollen.linear() *= 3.0;
  swollen.translation() = centre - swollen.linear() * centre;
  const std::vector<Affine> matrices = {Affine::Identity(), Affine::Identity(), swollen};
  const std::vector<Vec3> centres = {Vec3::Zero(), Vec3(5, 0, 0), centre};
  RandomSkin skin;
  skin.influences = 2;
  skin.indices = {1, 2};
  skin.weights = {0.5F, 0.5F};
  skin.positions = {Vec3f(10, 1, 0)};
  const Skinned out = skinned(SkinningPalette(matrices, centres, SkinningMethod::dual_quaternion), skin);
  EXPECT_LT((out.positions[0] - Vec3f(10, 2, 0)).norm(), 1e-5F);
}

TEST(Palette, TheBindPoseIsTheIdentity) {
  Random random(4);
  Skin skin;
  std::vector<Affine> model;
  for (int i = 0; i < 6; ++i) {
    model.push_back(rigid(random_rotation(random), random_vector(random)) * Eigen::Scaling(random.uniform(0.5, 2.0)));
    skin.joints.push_back(i);
    skin.inverse_bind.push_back(model.back().inverse());
  }
  const RandomSkin vertices = random_skin(random, 100, 6, 4);
  for (const SkinningMethod method : {SkinningMethod::linear, SkinningMethod::dual_quaternion}) {
    const SkinningPalette palette = make_palette(skin, model, method);
    EXPECT_EQ(palette.matrices().empty(), method == SkinningMethod::dual_quaternion);
    const Skinned out = skinned(palette, vertices);
    for (std::size_t v = 0; v < vertices.positions.size(); ++v) {
      EXPECT_LT((out.positions[v] - vertices.positions[v]).norm(), 2e-6F);
      EXPECT_LT((out.normals[v] - vertices.normals[v]).norm(), 2e-6F);
      EXPECT_LT((out.tangents[v] - vertices.tangents[v]).norm(), 2e-6F);
    }
  }
}

TEST(Palette, JointsThatTurnByUpTo90DegreesShareAHemisphereWhateverTheBodyDoes) {
  Random random(5);
  const Quat body = random_rotation(random);
  std::vector<Affine> matrices;
  for (int i = 0; i < 40; ++i) {
    const Vec3 axis = random_vector(random).normalized();
    matrices.push_back(
        rigid(body * Quat(Eigen::AngleAxisd(random.uniform(-89.0, 89.0) * kDegree, axis)), Vec3::Zero()));
  }
  matrices.front() = rigid(body, Vec3::Zero());
  EXPECT_TRUE(SkinningPalette(matrices, {}, SkinningMethod::dual_quaternion).share_hemisphere());
  for (const double degrees : {0.0, 120.0, 240.0}) {
    matrices.push_back(rigid(body * Quat(Eigen::AngleAxisd(degrees * kDegree, Vec3::UnitX())), Vec3::Zero()));
  }
  EXPECT_FALSE(SkinningPalette(matrices, {}, SkinningMethod::dual_quaternion).share_hemisphere());
}

TEST(Palette, MirroredEntriesAreKnown) {
  const std::vector<Affine> matrices = {Affine::Identity(), Affine(Eigen::Scaling(-1.0, 1.0, 1.0))};
  const SkinningPalette palette(matrices);
  EXPECT_FALSE(palette.is_mirrored(0));
  EXPECT_TRUE(palette.is_mirrored(1));
  EXPECT_TRUE(palette.any_mirrored());
}

TEST(Palette, BadInputIsNamed) {
  const std::vector<Affine> one = {Affine::Identity()};
  EXPECT_THROW(SkinningPalette(std::vector<Affine>{}), Error);
  EXPECT_THROW(SkinningPalette(one, std::vector<Vec3>(2, Vec3::Zero())), Error);
  std::vector<Affine> broken = one;
  broken[0](1, 2) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(SkinningPalette{broken}, Error);
  Skin skin;
  skin.joints = {0, 3};
  skin.inverse_bind = {Affine::Identity(), Affine::Identity()};
  EXPECT_THROW(static_cast<void>(make_palette(skin, one)), Error);
}

TEST(Palette, ASingularInverseBindMatrixIsTakenAsItIs) {
  Skin skin;
  skin.joints = {0};
  skin.inverse_bind = {Affine(Eigen::Scaling(0.0, 1.0, 1.0))};
  const std::vector<Affine> model = {Affine::Identity()};
  RandomSkin vertex;
  vertex.influences = 1;
  vertex.indices = {0};
  vertex.weights = {1.0F};
  vertex.positions = {Vec3f(1, 2, 3)};
  const Skinned out = skinned(make_palette(skin, model, SkinningMethod::dual_quaternion), vertex);
  EXPECT_LT((out.positions[0] - Vec3f(0, 2, 3)).norm(), 1e-5F);
}

}  // namespace
}  // namespace croquis
