// SPDX-License-Identifier: MIT
#include "croquis/posing/turn_prior.h"

#include "support/test_rigs.h"

#include <gtest/gtest.h>

namespace croquis {
namespace {

const TurnPrior& prior_of(const std::vector<TurnPrior>& priors, int joint) {
  const auto found = std::find_if(priors.begin(), priors.end(), [&](const auto& p) { return p.joint == joint; });
  if (found == priors.end()) throw std::runtime_error("no prior for joint " + std::to_string(joint));
  return *found;
}

/// The axis about which a joint is readiest to turn, model space.
Vec3 easiest_axis(const Skeleton& skeleton, const TurnPrior& prior) {
  Eigen::Index axis = 0;
  prior.spread.maxCoeff(&axis);
  const Affine joint = compute_model_transforms(skeleton, rest_pose(skeleton))[static_cast<std::size_t>(prior.joint)];
  return joint.linear() * (prior.frame * Vec3(Vec3::Unit(axis)));
}

TEST(TurnPrior, KneesAndElbowsAreHingesWhateverTheRollOfTheirBones) {
  const Skeleton plain = make_test_humanoid();
  const std::vector<TurnPrior> priors = make_turn_prior(plain, recognise_humanoid(plain), rest_pose(plain));
  for (const char* name : {"leftLowerLeg", "rightLowerLeg"}) {
    const TurnPrior& knee = prior_of(priors, plain.resolve(name));
    EXPECT_GT(std::abs(easiest_axis(plain, knee).dot(Vec3::UnitX())), 0.95) << name;
    EXPECT_GT(knee.spread.maxCoeff(), 4.0 * knee.spread.y()) << name;
  }
  for (const std::uint64_t seed : {3U, 77U}) {
    const Skeleton rolled = make_test_humanoid(seed);
    const std::vector<TurnPrior> others = make_turn_prior(rolled, recognise_humanoid(rolled), rest_pose(rolled));
    ASSERT_EQ(others.size(), priors.size());
    for (std::size_t i = 0; i < priors.size(); ++i) {
      ASSERT_EQ(others[i].joint, priors[i].joint);
      EXPECT_LT((easiest_axis(plain, priors[i]) - easiest_axis(rolled, others[i])).norm(), 1e-9);
    }
  }
}

TEST(TurnPrior, LeftAndRightAreAlike) {
  const Skeleton skeleton = make_test_humanoid(5);
  const std::vector<TurnPrior> priors = make_turn_prior(skeleton, recognise_humanoid(skeleton), rest_pose(skeleton));
  for (const char* name : {"UpperArm", "LowerArm", "Hand", "UpperLeg", "LowerLeg", "Foot", "Shoulder"}) {
    const TurnPrior& left = prior_of(priors, skeleton.resolve(std::string("left") + name));
    const TurnPrior& right = prior_of(priors, skeleton.resolve(std::string("right") + name));
    EXPECT_EQ(left.spread, right.spread) << name;
  }
}

TEST(TurnPrior, NothingIsKnownOfWhatIsNoHumanoid) {
  const Skeleton skeleton = make_test_quadruped();
  EXPECT_TRUE(make_turn_prior(skeleton, {}, rest_pose(skeleton)).empty());
}

}  // namespace
}  // namespace croquis
