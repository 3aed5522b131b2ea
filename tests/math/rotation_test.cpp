// SPDX-License-Identifier: MIT
#include "croquis/math/rotation.h"

#include "support/random_math.h"
#include <array>

#include <gtest/gtest.h>

namespace croquis {
namespace {

TEST(Rotation, BetweenTwoDirectionsTurnsOneIntoTheOther) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const Vec3 a = random_vector(random), b = random_vector(random);
    EXPECT_LT((rotation_between(a, b) * a.normalized() - b.normalized()).norm(), 1e-12);
  }
  EXPECT_LT((rotation_between(Vec3::UnitX(), -Vec3::UnitX()) * Vec3::UnitX() + Vec3::UnitX()).norm(), 1e-12);
  EXPECT_TRUE(rotation_between(Vec3::Zero(), Vec3::UnitX()).isApprox(Quat::Identity()));
}

TEST(Rotation, ExponentialAndLogarithmAreInverse) {
  Random random(2);
  for (const double size : {0.0, 1e-9, 1e-5, 0.1, 1.0, 3.0}) {
    const Vec3 v = size * random_vector(random).normalized();
    EXPECT_LT((rotation_to_vector(rotation_from_vector(v)) - v).norm(), 1e-10) << size;
  }
}

TEST(Rotation, SwingTimesTwistIsTheRotation) {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const Quat q = random_rotation(random);
    const Vec3 axis = random_vector(random).normalized();
    const auto [swing, twist] = split_swing_twist(q, axis);
    EXPECT_LT((swing * twist).angularDistance(q), 1e-9);
    EXPECT_LT(std::abs(swing.vec().dot(axis)), 1e-12);
    EXPECT_LT(twist.vec().cross(axis).norm(), 1e-12);
    EXPECT_LT(Quat(Eigen::AngleAxisd(twist_angle(q, axis), axis)).angularDistance(twist), 1e-9);
  }
}

TEST(Rotation, EulerAnglesComeBackInEveryOrder) {
  Random random(4);
  std::array<int, 3> order{0, 1, 2};
  do {
    for (int i = 0; i < 20; ++i) {
      const Vec3 angles(random.uniform(-3, 3), random.uniform(-1.5, 1.5), random.uniform(-3, 3));
      EXPECT_LT((to_euler(order, from_euler(order, angles)) - angles).norm(), 1e-9);
    }
    for (const double from_lock : {0.0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3}) {
      for (const double side : {-1.0, 1.0}) {
        const Quat locked = from_euler(order, Vec3(0.3, side * (kPi / 2 - from_lock), 0.4));
        const Quat back = from_euler(order, to_euler(order, locked));
        EXPECT_LT((back.toRotationMatrix() - locked.toRotationMatrix()).norm(), 1e-14) << from_lock;
      }
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

}  // namespace
}  // namespace croquis
