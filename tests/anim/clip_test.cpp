// SPDX-License-Identifier: MIT
#include "croquis/anim/clip.h"

#include <cmath>

#include <gtest/gtest.h>

#include "croquis/base/error.h"

namespace croquis {
namespace {

Curve translation_curve(Interpolation interpolation) {
  Curve curve;
  curve.target = CurveTarget::translation;
  curve.joint = 0;
  curve.width = 3;
  curve.interpolation = interpolation;
  curve.times = {1.0, 3.0};
  curve.values = {0, 0, 0, 2, 4, 6};
  return curve;
}

TEST(Curve, StepHoldsLinearMovesBothClamp) {
  const Curve step = translation_curve(Interpolation::step), linear = translation_curve(Interpolation::linear);
  EXPECT_EQ(step.sample(2.9), (std::vector<double>{0, 0, 0}));
  EXPECT_EQ(step.sample(3.0), (std::vector<double>{2, 4, 6}));
  EXPECT_EQ(linear.sample(2.0), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(linear.sample(-5.0), (std::vector<double>{0, 0, 0}));
  EXPECT_EQ(linear.sample(9.0), (std::vector<double>{2, 4, 6}));
}

TEST(Curve, CubicSplineFollowsItsTangents) {
  Curve curve = translation_curve(Interpolation::cubic_spline);
  // x(t) = t^2 from t = 1 to 3: value and slope at the ends determine the parabola.
  curve.values = {0, 0, 0, 1, 0, 0, 2, 0, 0, 6, 0, 0, 9, 0, 0, 0, 0, 0};
  EXPECT_NEAR(curve.sample(2.0)[0], 4.0, 1e-12);
  EXPECT_NEAR(curve.sample(1.5)[0], 2.25, 1e-12);
}

TEST(Curve, RotationsTakeTheShorterWay) {
  Curve curve;
  curve.joint = 0;
  curve.times = {0.0, 1.0};
  curve.values = {0, 0, 0, 1, 0, 0, -std::sqrt(0.5), -std::sqrt(0.5)};  // -q: a quarter turn about z
  EXPECT_NEAR(std::abs(curve.sample(0.5)[3]), std::cos(kPi / 8), 1e-12);
}

TEST(Curve, BadKeysAreRefused) {
  Curve curve = translation_curve(Interpolation::linear);
  EXPECT_NO_THROW(curve.check());
  curve.times = {1.0, 1.0};
  EXPECT_THROW(curve.check(), Error);
  curve = translation_curve(Interpolation::cubic_spline);
  EXPECT_THROW(curve.check(), Error);
}

TEST(Clip, FramesAreTheKeysAndPosesComeFromThem) {
  const Skeleton skeleton({{"root", -1, {}}});
  const Clip clip{"walk", {translation_curve(Interpolation::linear)}};
  EXPECT_EQ(clip.frame_count(), 2);
  EXPECT_EQ(clip.frame_time(1), 3.0);
  EXPECT_THROW(static_cast<void>(clip.frame_time(2)), Error);
  EXPECT_TRUE(sample_pose(clip, 3.0, rest_pose(skeleton)).local[0].translation.isApprox(Vec3(2, 4, 6)));
  EXPECT_EQ(Clip{}.frame_count(), 0);
}

}  // namespace
}  // namespace croquis
