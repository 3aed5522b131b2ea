// SPDX-License-Identifier: MIT
#include "croquis/mesh/skin.h"

#include <limits>

#include <gtest/gtest.h>

#include "croquis/base/error.h"

namespace croquis {
namespace {

Skin two_joint_skin() {
  Skin skin;
  skin.joints = {3, 5};
  skin.inverse_bind = {Affine::Identity(), Affine::Identity()};
  skin.influences = 2;
  skin.joint_indices = {0, 1, 1, 0};
  skin.weights = {0.5F, 1.5F, 0.0F, 0.0F};
  return skin;
}

TEST(Skin, NormalisedWeightsSumToOneLargestFirst) {
  Skin skin = two_joint_skin();
  normalise_weights(skin);
  EXPECT_EQ(skin.weights, (std::vector<float>{0.75F, 0.25F, 0.0F, 0.0F}));
  EXPECT_EQ(skin.joint_indices, (std::vector<std::uint16_t>{1, 0, 0, 0}));
}

TEST(Skin, CheckRefusesWhatDoesNotFit) {
  EXPECT_NO_THROW(two_joint_skin().check(2, 6));
  EXPECT_THROW(two_joint_skin().check(3, 6), Error);
  EXPECT_THROW(two_joint_skin().check(2, 5), Error);
  Skin skin = two_joint_skin();
  skin.weights[0] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(skin.check(2, 6), Error);
  skin = two_joint_skin();
  skin.joint_indices[0] = 2;
  EXPECT_THROW(skin.check(2, 6), Error);
}

}  // namespace
}  // namespace croquis
