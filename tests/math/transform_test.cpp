// SPDX-License-Identifier: MIT
#include "croquis/math/transform.h"

#include "support/random_math.h"

#include <gtest/gtest.h>

namespace croquis {
namespace {

TEST(Transform, DecomposingGivesTheSameMapBack) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    Transform t;
    t.translation = random_vector(random);
    t.rotation = random_rotation(random);
    for (int c = 0; c < 3; ++c) t.scale[c] = random.uniform(0.1, 3.0) * (random.index(2) == 0 ? 1.0 : -1.0);
    double shear = 1.0;
    const Transform back = decompose(t.to_affine(), &shear);
    EXPECT_LT((back.to_affine().matrix() - t.to_affine().matrix()).norm(), 1e-9);
    EXPECT_LT(shear, 1e-12);
  }
}

TEST(Transform, FlattenedAndZeroScalesStayFinite) {
  for (const Vec3& scale : {Vec3(0, 1, 1), Vec3(0, 0, 1), Vec3(0, 0, 0), Vec3(1, 0, -2)}) {
    const Transform t{Vec3::Zero(), Quat::Identity(), scale};
    const Transform back = decompose(t.to_affine());
    EXPECT_TRUE(back.is_finite());
    EXPECT_NEAR(back.rotation.norm(), 1.0, 1e-12);
    EXPECT_LT((back.to_affine().matrix() - t.to_affine().matrix()).norm(), 1e-12);
  }
}

TEST(Transform, ShearIsReported) {
  Affine sheared = Affine::Identity();
  sheared.linear()(0, 1) = 0.5;
  double shear = 0.0;
  static_cast<void>(decompose(sheared, &shear));
  EXPECT_GT(shear, 0.3);
}

TEST(Transform, InterpolationMeetsItsEnds) {
  Random random(2);
  const Transform a{random_vector(random), random_rotation(random), Vec3::Ones()};
  const Transform b{random_vector(random), random_rotation(random), Vec3::Constant(2.0)};
  EXPECT_LT((interpolate(a, b, 0.0).to_affine().matrix() - a.to_affine().matrix()).norm(), 1e-12);
  EXPECT_LT((interpolate(a, b, 1.0).to_affine().matrix() - b.to_affine().matrix()).norm(), 1e-12);
}

}  // namespace
}  // namespace croquis
