// SPDX-License-Identifier: MIT
#include "croquis/skinning/skin_vertices.h"

#include "skinning/random_skin.h"

#include <gtest/gtest.h>

#include "croquis/base/error.h"
#include "croquis/math/rotation.h"

namespace croquis {
namespace {

using skinning_kernels::available_kernels;

double worst(const std::vector<Vec3f>& a, const std::vector<Vec3f>& b) {
  double most = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double difference = static_cast<double>((a[i] - b[i]).norm());
    if (!(difference <= most)) most = difference;  // a NaN stays
  }
  return most;
}

RandomSkin one_vertex(const Vec3f& position, std::vector<std::uint16_t> indices, std::vector<float> weights) {
  RandomSkin skin;
  skin.influences = static_cast<int>(weights.size());
  skin.indices = std::move(indices);
  skin.weights = std::move(weights);
  skin.positions = {position};
  return skin;
}

TEST(SkinVertices, HalfwayBetweenTwoTranslationsIsTheirMean) {
  const std::vector<Affine> palette = {rigid(Quat::Identity(), Vec3(2, 0, 0)), rigid(Quat::Identity(), Vec3(0, 4, 0))};
  const RandomSkin skin = one_vertex(Vec3f(1, 1, 1), {0, 1}, {0.5F, 0.5F});
  for (const SkinningMethod method : {SkinningMethod::linear, SkinningMethod::dual_quaternion}) {
    const Skinned out = skinned(SkinningPalette(palette, {}, method), skin);
    EXPECT_LT((out.positions[0] - Vec3f(2, 3, 1)).norm(), 1e-6F);
  }
}

TEST(SkinVertices, ATwistOf180DegreesCollapsesLinearlyAndNotWithDualQuaternions) {
  const std::vector<Affine> palette = {Affine::Identity(),
                                       rigid(Quat(Eigen::AngleAxisd(kPi * 0.9999, Vec3::UnitX())), Vec3::Zero())};
  const RandomSkin skin = one_vertex(Vec3f(5, 1, 0), {0, 1}, {0.5F, 0.5F});
  const Vec3f linear = skinned(SkinningPalette(palette), skin).positions[0];
  EXPECT_LT(linear.tail<2>().norm(), 1e-3F);
  const Vec3f dual = skinned(SkinningPalette(palette, {}, SkinningMethod::dual_quaternion), skin).positions[0];
  EXPECT_NEAR(dual.x(), 5.0F, 1e-6F);
  EXPECT_NEAR(dual.z(), 1.0F, 1e-3F);  // a quarter turn
}

TEST(SkinVertices, DualQuaternionsKeepTheDistanceFromTheAxisOfATwist) {
  for (double degrees = -179.0; degrees < 180.0; degrees += 17.0) {
    const std::vector<Affine> palette = {
        Affine::Identity(), rigid(Quat(Eigen::AngleAxisd(degrees * kDegree, Vec3::UnitX())), Vec3::Zero())};
    for (const float weight : {0.1F, 0.5F, 0.8F}) {
      const RandomSkin skin = one_vertex(Vec3f(3, 0.6F, 0.8F), {0, 1}, {weight, 1.0F - weight});
      const Skinned out = skinned(SkinningPalette(palette, {}, SkinningMethod::dual_quaternion), skin);
      EXPECT_NEAR(out.positions[0].tail<2>().norm(), 1.0F, 1e-6F) << degrees;
    }
  }
}

TEST(SkinVertices, EveryKernelFollowsTheFormulasForAnyNumberOfInfluences) {
  Random random(11);
  for (const int influences : {1, 2, 3, 4, 5, 7, 8, 9, 13}) {
    for (const int vertices : {1, 2, 7, 8, 9, 64, 257, 600}) {
      // Wild rotations at one time, and at another such as share a hemisphere.
      const double most = vertices % 2 == 0 ? kPi : kPi / 2;
      std::vector<Affine> matrices;
      for (int i = 0; i < 20; ++i) {
        const double angle = i == 0 ? 0.0 : random.uniform(-most, most);
        matrices.push_back(
            rigid(rotation_from_vector(angle * random_vector(random).normalized()), random_vector(random)));
      }
      RandomSkin skin = random_skin(random, vertices, 20, influences);
      skin.tangents.clear();  // the fast kernels leave meshes with tangents to the portable one
      for (int k = 0; k < available_kernels().count; ++k) {
        Skinned linear, dual;
        skin_vertices(SkinningPalette(matrices), job_of(skin, linear), available_kernels().sets[k]);
        skin_vertices(SkinningPalette(matrices, {}, SkinningMethod::dual_quaternion), job_of(skin, dual),
                      available_kernels().sets[k]);
        double linear_error = 0.0, dual_error = 0.0, normal_error = 0.0;
        for (int v = 0; v < vertices; ++v) {
          const auto i = static_cast<std::size_t>(v);
          const Vec3 position = skin.positions[i].cast<double>(), normal = skin.normals[i].cast<double>();
          const Affine matrix = blended_matrix(matrices, skin, v), motion = blended_motion(matrices, skin, v);
          linear_error = std::max(linear_error, (linear.positions[i].cast<double>() - matrix * position).norm());
          dual_error = std::max(dual_error, (dual.positions[i].cast<double>() - motion * position).norm());
          normal_error = std::max(normal_error, (dual.normals[i].cast<double>() - motion.linear() * normal).norm());
          const Vec3 turned = matrix.linear() * normal;
          if (turned.norm() > 0.05) {
            normal_error = std::max(normal_error, (linear.normals[i].cast<double>() - turned.normalized()).norm());
          }
        }
        EXPECT_LT(linear_error, 3e-6) << influences << " influences, " << vertices << " vertices, kernel " << k;
        EXPECT_LT(dual_error, 2e-5) << influences << " influences, " << vertices << " vertices, kernel " << k;
        EXPECT_LT(normal_error, 2e-5) << influences << " influences, " << vertices << " vertices, kernel " << k;
      }
    }
  }
}

TEST(SkinVertices, NormalsKeepTheLengthOfTheBlendWhereThatIsAskedFor) {
  Random random(20);
  const std::vector<Affine> matrices = random_rigid_palette(random, 9);
  const RandomSkin skin = random_skin(random, 150, 9, 4);
  for (int k = 0; k < available_kernels().count; ++k) {
    Skinned linear, dual;
    SkinningJob job = job_of(skin, linear);
    job.tangents = {};
    job.posed_tangents = {};
    job.unit_normals = false;
    skin_vertices(SkinningPalette(matrices), job, available_kernels().sets[k]);
    job.posed_positions = (dual.positions = linear.positions);
    job.posed_normals = (dual.normals = linear.normals);
    skin_vertices(SkinningPalette(matrices, {}, SkinningMethod::dual_quaternion), job, available_kernels().sets[k]);
    for (int v = 0; v < 150; ++v) {
      const auto i = static_cast<std::size_t>(v);
      const Vec3 normal = skin.normals[i].cast<double>();
      const Vec3 blended = blended_matrix(matrices, skin, v).linear() * normal;
      EXPECT_LT((linear.normals[i].cast<double>() - blended).norm(), 2e-6);
      EXPECT_NEAR(dual.normals[i].norm(), 1.0F, 1e-5F);
    }
  }
}

TEST(SkinVertices, KernelsAgree) {
  Random random(12);
  for (const int influences : {1, 2, 4, 6, 8}) {
    for (const bool has_tangents : {false, true}) {
      // Rotations within 60 degrees of each other: no vertex near the point where dual quaternions turn over.
      std::vector<Affine> matrices;
      for (int i = 0; i < 12; ++i) {
        matrices.push_back(rigid(rotation_from_vector(random_vector(random).normalized() * random.uniform(0.0, 0.5)),
                                 0.2 * random_vector(random)));
      }
      RandomSkin skin = random_skin(random, 333, 12, influences);
      if (!has_tangents) skin.tangents.clear();
      for (const SkinningMethod method : {SkinningMethod::linear, SkinningMethod::dual_quaternion}) {
        const SkinningPalette palette(matrices, {}, method);
        Skinned reference;
        skin_vertices(palette, job_of(skin, reference), available_kernels().sets[available_kernels().count - 1]);
        for (int k = 0; k < available_kernels().count; ++k) {
          Skinned out;
          skin_vertices(palette, job_of(skin, out), available_kernels().sets[k]);
          EXPECT_LT(worst(out.positions, reference.positions), 2e-6);
          EXPECT_LT(worst(out.normals, reference.normals), 2e-6);
          for (std::size_t i = 0; i < out.tangents.size(); ++i) {
            EXPECT_LT((out.tangents[i] - reference.tangents[i]).norm(), 2e-6F);
          }
        }
      }
    }
  }
}

TEST(SkinVertices, OneRigidMotionOfAllJointsIsThatMotionOfTheMesh) {
  Random random(13);
  for (int round = 0; round < 10; ++round) {
    const Affine motion = rigid(random_rotation(random), random_vector(random));
    const std::vector<Affine> matrices(6, motion);
    const RandomSkin skin = random_skin(random, 100, 6, 4);
    for (const SkinningMethod method : {SkinningMethod::linear, SkinningMethod::dual_quaternion}) {
      const Skinned out = skinned(SkinningPalette(matrices, {}, method), skin);
      for (std::size_t i = 0; i < skin.positions.size(); ++i) {
        EXPECT_LT((out.positions[i].cast<double>() - motion * skin.positions[i].cast<double>()).norm(), 3e-6);
        EXPECT_LT((out.normals[i].cast<double>() - motion.linear() * skin.normals[i].cast<double>()).norm(), 2e-6);
        EXPECT_EQ(out.tangents[i].w(), skin.tangents[i].w());
      }
    }
  }
}

TEST(SkinVertices, AMotionAfterThePaletteIsThatMotionOfTheResult) {
  Random random(14);
  const Affine motion = rigid(random_rotation(random), random_vector(random));
  const std::vector<Affine> matrices = random_rigid_palette(random, 8);
  std::vector<Affine> moved;
  for (const Affine& matrix : matrices) moved.push_back(motion * matrix);
  const RandomSkin skin = random_skin(random, 200, 8, 4);
  for (const SkinningMethod method : {SkinningMethod::linear, SkinningMethod::dual_quaternion}) {
    const Skinned before = skinned(SkinningPalette(matrices, {}, method), skin);
    const Skinned after = skinned(SkinningPalette(moved, {}, method), skin);
    for (std::size_t i = 0; i < skin.positions.size(); ++i) {
      EXPECT_LT((after.positions[i].cast<double>() - motion * before.positions[i].cast<double>()).norm(), 2e-5);
    }
  }
}

TEST(SkinVertices, AVertexWithoutWeightsFollowsEntryZero) {
  Random random(15);
  const std::vector<Affine> matrices = random_rigid_palette(random, 5);
  RandomSkin skin = random_skin(random, 40, 5, 4);
  for (std::size_t i = 17 * 4; i < 18 * 4; ++i) skin.weights[i] = 0.0F;
  skin.tangents.clear();
  for (const SkinningMethod method : {SkinningMethod::linear, SkinningMethod::dual_quaternion}) {
    for (const bool share_hemisphere : {false, true}) {
      const std::vector<Affine> palette = share_hemisphere ? std::vector<Affine>(5, matrices[0]) : matrices;
      const Skinned out = skinned(SkinningPalette(palette, {}, method), skin);
      EXPECT_LT((out.positions[17].cast<double>() - matrices[0] * skin.positions[17].cast<double>()).norm(), 3e-6);
      EXPECT_TRUE(std::all_of(out.normals.begin(), out.normals.end(), [](const Vec3f& n) { return n.allFinite(); }));
    }
  }
}

TEST(SkinVertices, NormalsStayOrthogonalToASurfaceThatIsScaledUnevenly) {
  Random random(16);
  for (int round = 0; round < 20; ++round) {
    Affine squash = rigid(random_rotation(random), random_vector(random));
    squash.linear() *= Vec3(random.uniform(0.2, 3.0), random.uniform(0.2, 3.0), random.uniform(0.2, 3.0)).asDiagonal();
    if (round % 2 == 1) squash.linear().col(0) *= -1.0;
    const RandomSkin skin = random_skin(random, 50, 1, 1);
    for (const SkinningMethod method : {SkinningMethod::linear, SkinningMethod::dual_quaternion}) {
      const Skinned out = skinned(SkinningPalette(std::vector<Affine>{squash}, {}, method), skin);
      for (std::size_t i = 0; i < skin.positions.size(); ++i) {
        EXPECT_LT((out.positions[i].cast<double>() - squash * skin.positions[i].cast<double>()).norm(), 2e-5);
        EXPECT_NEAR(out.normals[i].norm(), 1.0F, 1e-6F);
        EXPECT_NEAR(out.tangents[i].head<3>().norm(), 1.0F, 1e-6F);
        EXPECT_NEAR(out.normals[i].dot(out.tangents[i].head<3>()), 0.0F, 1e-5F);
        const Vec3 expected = (squash.linear().inverse().transpose() * skin.normals[i].cast<double>()).normalized();
        EXPECT_LT((out.normals[i].cast<double>() - expected).norm(), 1e-5);
        EXPECT_EQ(out.tangents[i].w(), round % 2 == 1 ? -skin.tangents[i].w() : skin.tangents[i].w());
      }
    }
  }
}

TEST(SkinVertices, ScalesOfZeroGiveFiniteVectorsOfUnitLength) {
  Random random(17);
  for (const Vec3& scale : {Vec3(0, 1, 1), Vec3(0, 0, 1), Vec3(0, 0, 0), Vec3(1, -1, 0), Vec3(1e-12, 1e-12, 1e-12)}) {
    std::vector<Affine> matrices = random_rigid_palette(random, 3);
    for (int i = 0; i < 3; ++i) {
      if (i != 1) matrices[static_cast<std::size_t>(i)].linear() *= scale.asDiagonal();
    }
    const RandomSkin skin = random_skin(random, 100, 3, 4);
    for (const SkinningMethod method : {SkinningMethod::linear, SkinningMethod::dual_quaternion}) {
      const Skinned out = skinned(SkinningPalette(matrices, {}, method), skin);
      for (std::size_t i = 0; i < skin.positions.size(); ++i) {
        EXPECT_TRUE(out.positions[i].allFinite());
        EXPECT_NEAR(out.normals[i].norm(), 1.0F, 1e-5F);
        EXPECT_NEAR(out.tangents[i].head<3>().norm(), 1.0F, 1e-5F);
      }
    }
  }
}

TEST(SkinVertices, AScaleOfTheWholeRigBendsLikeTheRigItself) {
  Random random(18);
  const std::vector<Affine> matrices = random_rigid_palette(random, 8);
  const RandomSkin skin = random_skin(random, 100, 8, 4);
  for (const SkinningMethod method : {SkinningMethod::linear, SkinningMethod::dual_quaternion}) {
    const Skinned plain = skinned(SkinningPalette(matrices, {}, method), skin);
    for (const double scale : {0.01, 100.0, -1.0}) {
      // The mesh is stored `scale` times smaller, and every joint's matrix makes up for it.
      std::vector<Affine> scaled;
      for (const Affine& matrix : matrices) scaled.push_back(matrix * Eigen::Scaling(scale));
      RandomSkin stored = skin;
      for (Vec3f& position : stored.positions) position /= static_cast<float>(scale);
      const Skinned out = skinned(SkinningPalette(scaled, {}, method), stored);
      EXPECT_LT(worst(out.positions, plain.positions), 3e-5) << scale;
      for (Vec3f& normal : stored.normals) normal *= scale < 0.0 ? -1.0F : 1.0F;
      EXPECT_LT(worst(skinned(SkinningPalette(scaled, {}, method), stored).normals, plain.normals), 1e-3) << scale;
    }
  }
}

TEST(SkinVertices, WrongSizesAreNamed) {
  Random random(19);
  const SkinningPalette palette(random_rigid_palette(random, 3));
  RandomSkin skin = random_skin(random, 5, 3, 4);
  Skinned out;
  const SkinningJob good = job_of(skin, out);
  EXPECT_NO_THROW(skin_vertices(palette, good));
  SkinningJob bad = good;
  bad.influences = 0;
  EXPECT_THROW(skin_vertices(palette, bad), Error);
  bad = good;
  bad.weights = bad.weights.first(19);
  EXPECT_THROW(skin_vertices(palette, bad), Error);
  bad = good;
  bad.posed_normals = {};
  EXPECT_THROW(skin_vertices(palette, bad), Error);
  bad = good;
  bad.posed_positions = bad.posed_positions.first(4);
  EXPECT_THROW(skin_vertices(palette, bad), Error);
}

TEST(SkinVertices, NoVertexIsNoWork) {
  EXPECT_NO_THROW(skin_vertices(SkinningPalette(std::vector<Affine>{Affine::Identity()}), SkinningJob{}));
}

}  // namespace
}  // namespace croquis
