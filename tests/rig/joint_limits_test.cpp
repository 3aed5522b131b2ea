// SPDX-License-Identifier: MIT
#include "croquis/rig/joint_limits.h"

#include "rig/rigs.h"
#include "support/random_math.h"
#include <map>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include "croquis/base/error.h"
#include "croquis/math/rotation.h"
#include "croquis/rig/mirror.h"

namespace croquis {
namespace {

using enum HumanoidBone;

Quat turn(const Vec3& axis, double degrees) { return rotation_from_vector(axis.normalized() * degrees * kDegree); }

JointLimit wide() {
  JointLimit limit;
  limit.swing_min = Vec2(-60, -100) * kDegree;
  limit.swing_max = Vec2(170, 50) * kDegree;
  limit.twist_min = -80 * kDegree;
  limit.twist_max = 90 * kDegree;
  return limit;
}

JointLimit random_limit(Random& random) {
  JointLimit limit = wide();
  limit.neutral = random_rotation(random);
  limit.frame = random_rotation(random);
  for (int i = 0; i < 2; ++i) {
    limit.swing_min[i] = -random.uniform(0.02, 2.9);
    limit.swing_max[i] = random.uniform(0.02, 2.9);
  }
  limit.twist_min = -random.uniform(0.0, 2.0);
  limit.twist_max = random.uniform(0.0, 2.0);
  return limit;
}

TEST(LimitPreset, NamesReadBack) {
  for (const LimitPreset preset :
       {LimitPreset::anatomical, LimitPreset::dancer, LimitPreset::cartoon, LimitPreset::none}) {
    EXPECT_EQ(parse_limit_preset(to_string(preset)), preset);
  }
  EXPECT_FALSE(parse_limit_preset("Dancer").has_value());
}

TEST(JointLimit, CoordinatesAreSwingAndTwistByHand) {
  JointLimit limit = wide();
  const Vec3 at = limit_coordinates(limit, turn(Vec3::UnitX(), 30) * turn(Vec3::UnitZ(), -20));
  EXPECT_TRUE(at.isApprox(Vec3(30, 0, -20) * kDegree, 1e-12)) << at.transpose();
  // Neutral and frame only say where the coordinates count from and along which axes.
  limit.neutral = turn(Vec3(1, 2, 3), 77);
  limit.frame = turn(Vec3::UnitY(), 90);  // the limit's z is the joint's x
  const Vec3 twisted = limit_coordinates(limit, limit.neutral * turn(Vec3::UnitX(), 40));
  EXPECT_TRUE(twisted.isApprox(Vec3(0, 0, 40) * kDegree, 1e-12)) << twisted.transpose();
}

TEST(JointLimit, ViolationIsTheWayToTheEllipseByHand) {
  const JointLimit limit = wide();
  EXPECT_NEAR(limit_violation(limit, turn(Vec3::UnitX(), -70)), 10 * kDegree, 1e-9);
  EXPECT_NEAR(limit_violation(limit, turn(Vec3::UnitY(), 80)), 30 * kDegree, 1e-9);
  EXPECT_NEAR(limit_violation(limit, turn(Vec3::UnitZ(), 100)), 10 * kDegree, 1e-9);
  EXPECT_EQ(limit_violation(limit, turn(Vec3::UnitX(), 169)), 0.0);
  // At half each of two half axes one is inside, at the corner of both not.
  EXPECT_EQ(limit_violation(limit, rotation_from_vector(Vec3(-30, 25, 0) * kDegree)), 0.0);
  EXPECT_GT(limit_violation(limit, rotation_from_vector(Vec3(-59, 49, 0) * kDegree)), 0.1);
}

TEST(JointLimit, ClampingLandsInsideAndOnceIsEnough) {
  Random random(3);
  for (int i = 0; i < 2000; ++i) {
    const JointLimit limit = random_limit(random);
    const Quat q = random_rotation(random);
    const Quat clamped = clamp_to_limit(limit, q);
    ASSERT_LT(limit_violation(limit, clamped), 1e-9);
    ASSERT_LT(rotation_angle(clamp_to_limit(limit, clamped).conjugate() * clamped), 1e-9);
    const bool was_inside = limit_violation(limit, q) == 0.0;
    ASSERT_TRUE(!was_inside || clamped.coeffs() == q.coeffs());
    ASSERT_EQ(limit_violation(limit, limit.neutral), 0.0);
  }
}

TEST(JointLimit, ClampingGoesToTheNearestAllowedSwing) {
  Random random(5);
  for (int i = 0; i < 200; ++i) {
    const JointLimit limit = random_limit(random);
    const Vec3 at = limit_coordinates(limit, random_rotation(random));
    const Vec3 to = limit_coordinates(
        limit, clamp_to_limit(limit, limit.neutral * limit.frame * rotation_from_vector({at.x(), at.y(), 0}) *
                                         rotation_from_vector({0, 0, at.z()}) * limit.frame.conjugate()));
    for (int k = 0; k < 400; ++k) {  // no point of the quarter ellipses is nearer
      const double angle = 2.0 * kPi * k / 400;
      const double c = std::cos(angle), s = std::sin(angle);
      const Vec2 border(c * (c < 0 ? -limit.swing_min.x() : limit.swing_max.x()),
                        s * (s < 0 ? -limit.swing_min.y() : limit.swing_max.y()));
      const double way = (at.head<2>() - to.head<2>()).norm();
      const bool outside = way > 1e-8;
      ASSERT_TRUE(!outside || way < (at.head<2>() - border).norm() + 1e-8);
    }
  }
}

TEST(JointLimit, ViolationHasNoJumpAroundTheBorder) {
  // Also where an arm passes straight up: there the swing comes back from the other side.
  Random random(7);
  const JointLimit limit = wide();
  for (int i = 0; i < 3000; ++i) {
    const Quat q = random_rotation(random);
    const double before = limit_violation(limit, q);
    if (before > 0.6) continue;
    const Quat beside = q * rotation_from_vector(1e-5 * random_vector(random).normalized());
    EXPECT_NEAR(before, limit_violation(limit, beside), 1e-3) << limit_coordinates(limit, q).transpose();
  }
  const double past = limit_violation(limit, turn(Vec3::UnitX(), 185));
  EXPECT_NEAR(past, 15 * kDegree, 1e-9);
}

TEST(JointLimit, CoordinatesAreSmoothInside) {
  // Second differences along a turn stay small: an optimiser may take derivatives.
  Random random(9);
  for (int i = 0; i < 500; ++i) {
    const JointLimit limit = wide();
    const Vec2 swing(random.uniform(-1.0, 2.6), random.uniform(-1.6, 0.8));
    const Quat q =
        rotation_from_vector({swing.x(), swing.y(), 0}) * rotation_from_vector({0, 0, random.uniform(-1, 1)});
    if (limit_violation(limit, q) > 0.0 || swing.norm() > 2.6) continue;
    const Vec3 w = random_vector(random).normalized();
    const auto at = [&](double h) { return limit_coordinates(limit, q * rotation_from_vector(h * w)); };
    const double h = 1e-4;
    EXPECT_LT((at(h) - 2.0 * at(0) + at(-h)).norm() / (h * h), 60.0);
  }
}

std::map<int, JointLimit> by_joint(const std::vector<JointLimit>& limits) {
  std::map<int, JointLimit> map;
  for (const JointLimit& limit : limits) map[limit.joint] = limit;
  return map;
}

/// The rest pose with one joint (and all below it) turned by a rotation given in model space.
Pose turned(const Skeleton& skeleton, int joint, const Quat& by_model) {
  Pose pose = rest_pose(skeleton);
  const Quat parent = rotation_of(skeleton.rest_model(skeleton.parent(joint)));
  Quat& local = pose.local[static_cast<std::size_t>(joint)].rotation;
  local = (parent.conjugate() * by_model * parent * local).normalized();
  return pose;
}

struct Body {
  explicit Body(const LabelledRig& rig) : Body(rig.name, rig.skeleton(), rig.labels) {}
  Body(std::string rig_name, const Skeleton& s, const HumanoidMap& map)
      : name(std::move(rig_name)),
        skeleton(s),
        humanoid(map),
        limits(by_joint(make_joint_limits(s, map, LimitPreset::anatomical))) {
    const auto at = [&](HumanoidBone bone) { return skeleton.rest_position(humanoid.joint(bone)); };
    up = (at(humanoid.has(head) ? head : neck) - at(hips)).normalized();
    left = at(leftUpperLeg) - at(rightUpperLeg);
    left = (left - up * up.dot(left)).normalized();
    front = left.cross(up);
  }
  [[nodiscard]] double violation(HumanoidBone bone, const Vec3& axis, double degrees) const {
    const int joint = humanoid.joint(bone);
    return limit_violation(
        limits.at(joint), turned(skeleton, joint, turn(axis, degrees)).local[static_cast<std::size_t>(joint)].rotation);
  }
  /// Where a turn about an axis takes what lies below a joint: the change of the end's position.
  [[nodiscard]] Vec3 moved(HumanoidBone bone, HumanoidBone end, const Vec3& axis, double degrees) const {
    const auto after = compute_positions(skeleton, turned(skeleton, humanoid.joint(bone), turn(axis, degrees)));
    return after[static_cast<std::size_t>(humanoid.joint(end))] - skeleton.rest_position(humanoid.joint(end));
  }

  [[nodiscard]] Vec3 along(HumanoidBone from, HumanoidBone to) const {
    return (skeleton.rest_position(humanoid.joint(to)) - skeleton.rest_position(humanoid.joint(from))).normalized();
  }

  std::string name;
  Skeleton skeleton;
  HumanoidMap humanoid;
  std::map<int, JointLimit> limits;
  Vec3 up, left, front;
};

/// Labelled humanoids whose rest pose stands, each once as it is and once with other axes for every joint.
std::vector<Body> standing_bodies() {
  std::vector<Body> bodies;
  for (const LabelledRig& rig : labelled_rigs()) {
    if (!rig.is_humanoid()) continue;
    const Body body(rig);
    if (body.limits.empty()) continue;
    bodies.push_back(body);
    bodies.emplace_back(rig.name + " (other axes)", with_random_axes(rig.skeleton(), 11), rig.labels);
  }
  return bodies;
}

TEST(JointLimits, KneesBendBackwardOnly) {
  const std::vector<Body> bodies = standing_bodies();
  EXPECT_GE(bodies.size(), 80U);
  for (const Body& body : bodies) {
    for (const auto& [knee, foot] : {std::pair(leftLowerLeg, leftFoot), std::pair(rightLowerLeg, rightFoot)}) {
      if (!body.humanoid.has(foot)) continue;
      const Vec3 thigh = body.along(knee == leftLowerLeg ? leftUpperLeg : rightUpperLeg, knee);
      const Vec3 axis = body.left - thigh * thigh.dot(body.left);
      const double bent = std::acos(std::min(1.0, thigh.dot(body.along(knee, foot)))) / kDegree;
      EXPECT_LT(body.moved(knee, foot, axis, 60).dot(body.front), 0.0) << body.name;
      EXPECT_LT(body.violation(knee, axis, 60), 0.15) << body.name;
      EXPECT_GT(body.violation(knee, axis, -bent - 20), 0.2) << body.name;
      EXPECT_GT(body.violation(knee, body.front, 40), 0.4) << body.name;
    }
  }
}

TEST(JointLimits, ElbowsBendForwardOnly) {
  for (const Body& body : standing_bodies()) {
    for (const bool left : {true, false}) {
      const HumanoidBone upper = left ? leftUpperArm : rightUpperArm, elbow = left ? leftLowerArm : rightLowerArm;
      const HumanoidBone hand = left ? leftHand : rightHand;
      if (!body.humanoid.has(hand)) continue;
      const Vec3 arm = body.along(upper, elbow);
      if (std::abs(arm.dot(body.front)) > 0.5) continue;
      const Vec3 axis = arm.cross(body.front);  // turns the forearm to the front
      const double bent = std::acos(std::min(1.0, arm.dot(body.along(elbow, hand)))) / kDegree;
      EXPECT_GT(body.moved(elbow, hand, axis, 60).dot(body.front), 0.0) << body.name;
      EXPECT_LT(body.violation(elbow, axis, 60), 0.25) << body.name;
      EXPECT_GT(body.violation(elbow, axis, -bent - 25), 0.2) << body.name;
    }
  }
}

TEST(JointLimits, ThighsAndArmsReachFarForwardAndLittleBack) {
  for (const Body& body : standing_bodies()) {
    EXPECT_LT(body.violation(leftUpperLeg, -body.left, 110), 0.1) << body.name;
    EXPECT_GT(body.violation(leftUpperLeg, -body.left, -60), 0.2) << body.name;
    EXPECT_LT(body.violation(rightUpperLeg, body.front, -40), 0.3) << body.name;  // out to the right
    EXPECT_GT(body.violation(rightUpperLeg, body.front, 90), 0.5) << body.name;   // across to the left
  }
}

TEST(JointLimits, TheTrunkBendsMoreToTheFront) {
  for (const Body& body : standing_bodies()) {
    EXPECT_LT(body.violation(spine, body.left, 15), 1e-6) << body.name;
    EXPECT_GT(body.violation(spine, body.left, -45), 0.05) << body.name;
    const double forward = body.violation(spine, body.left, 60), back = body.violation(spine, body.left, -60);
    EXPECT_GT(back, forward) << body.name;
    EXPECT_NEAR(body.violation(spine, body.front, 60), body.violation(spine, body.front, -60), 0.1) << body.name;
  }
}

TEST(JointLimits, RestPosesOfRealRigsAreAllowed) {
  for (const Body& body : standing_bodies()) {
    if (body.name.starts_with("family/")) continue;              // its finger tips are made up
    if (body.name.starts_with("bvh/geno_bind_lafan")) continue;  // rests with its arms straight up, palms out
    for (const auto& [joint, limit] : body.limits) {
      const Quat& rest = body.skeleton.joint(joint).rest.rotation;
      EXPECT_LT(limit_violation(limit, rest), 1e-6)
          << body.name << ": " << body.skeleton.name(joint) << " at " << limit_coordinates(limit, rest).transpose();
    }
  }
}

TEST(JointLimits, AZeroedRestIsNoStanceButAPoseThatStandsDoes) {
  const LabelledRig& rig = labelled_rig("bvh/bandai1_walk_normal_001.bvh");
  const Skeleton skeleton = rig.skeleton();
  EXPECT_TRUE(make_joint_limits(skeleton, rig.labels, LimitPreset::anatomical).empty());
  // Legs under the trunk, arms hanging: each bone of the left side turned downward from where zero leaves it.
  Pose stance = rest_pose(skeleton);
  std::vector<Affine> model;
  for (const auto& [bone, next, wanted] :
       {std::tuple(spine, chest, Vec3(0, 1, 0)), std::tuple(leftUpperLeg, leftLowerLeg, Vec3(0, -1, 0)),
        std::tuple(rightUpperLeg, rightLowerLeg, Vec3(0, -1, 0)),
        std::tuple(leftUpperArm, leftLowerArm, Vec3(0, -1, 0)),
        std::tuple(rightUpperArm, rightLowerArm, Vec3(0, -1, 0))}) {
    model = compute_model_transforms(skeleton, stance);
    const auto joint = static_cast<std::size_t>(rig.labels.joint(bone));
    const Vec3 now = model[static_cast<std::size_t>(rig.labels.joint(next))].translation() - model[joint].translation();
    const Quat parent = rotation_of(model[static_cast<std::size_t>(skeleton.parent(static_cast<int>(joint)))]);
    Quat& local = stance.local[joint].rotation;
    local = parent.conjugate() * rotation_between(now, wanted) * parent * local;
  }
  const auto limits = by_joint(make_joint_limits(skeleton, rig.labels, LimitPreset::anatomical, stance));
  EXPECT_EQ(limits.count(rig.labels.joint(leftLowerLeg)), 1U);
  EXPECT_EQ(limit_violation(limits.at(rig.labels.joint(leftUpperLeg)),
                            stance.local[static_cast<std::size_t>(rig.labels.joint(leftUpperLeg))].rotation),
            0.0);
  EXPECT_THROW(static_cast<void>(make_joint_limits(skeleton, rig.labels, LimitPreset::anatomical, Pose{})), Error);
}

/// The body in a pose, every joint turned at random against its parent (in axes that are alike for all skeletons).
std::vector<Quat> random_turns(const Skeleton& skeleton, Random& random) {
  std::vector<Quat> turns;
  for (int i = 0; i < skeleton.joint_count(); ++i) {
    turns.push_back(rotation_from_vector(0.5 * random_vector(random)));
  }
  return turns;
}

Pose with_turns(const Skeleton& skeleton, const std::vector<Quat>& turns) {
  Pose pose = rest_pose(skeleton);
  for (int i = 1; i < skeleton.joint_count(); ++i) {
    const Quat parent = rotation_of(skeleton.rest_model(skeleton.parent(i)));
    Quat& local = pose.local[static_cast<std::size_t>(i)].rotation;
    local = (parent.conjugate() * turns[static_cast<std::size_t>(i)] * parent * local).normalized();
  }
  return pose;
}

TEST(JointLimits, AxesAndRollsOfBonesMeanNothing) {
  Random random(21);
  for (const char* name : {"gltf/m2m_human_male_custom_clip.glb", "vrm/cryptovoxels_vrm0.vrm", "bvh/cmu_01_01.bvh"}) {
    const Skeleton plain = labelled_rig(name).skeleton(), other = with_random_axes(plain, 5);
    const auto a = make_joint_limits(plain, labelled_rig(name).labels, LimitPreset::anatomical);
    const auto b = make_joint_limits(other, labelled_rig(name).labels, LimitPreset::anatomical);
    ASSERT_EQ(a.size(), b.size());
    ASSERT_GT(a.size(), 15U);
    const std::vector<Quat> turns = random_turns(plain, random);
    const Pose pose_a = with_turns(plain, turns), pose_b = with_turns(other, turns);
    for (std::size_t i = 0; i < a.size(); ++i) {
      const auto joint = static_cast<std::size_t>(a[i].joint);
      const Vec3 in_a = limit_coordinates(a[i], pose_a.local[joint].rotation);
      const Vec3 in_b = limit_coordinates(b[i], pose_b.local[joint].rotation);
      EXPECT_TRUE(in_a.isApprox(in_b, 1e-6)) << name << " " << plain.name(a[i].joint);
    }
  }
}

TEST(JointLimits, AMirroredPoseIsAsFarOutsideAsThePose) {
  Random random(23);
  for (const char* name : {"gltf/m2m_human_male_custom_clip.glb", "gltf/kaykit_knight.glb", "gltf/rigged_figure.glb",
                           "vrm/debug_robot_vrm1.vrm", "gltf/quaternius_man_casual.glb"}) {
    const LabelledRig& rig = labelled_rig(name);
    const Skeleton skeleton = rig.skeleton();
    const auto limits = by_joint(make_joint_limits(skeleton, rig.labels, LimitPreset::anatomical));
    const std::vector<int> partners = compute_mirror_map(skeleton, rig.labels);
    for (int round = 0; round < 5; ++round) {
      const std::vector<Quat> turns = random_turns(skeleton, random);
      std::vector<Quat> mirrored = turns;
      for (std::size_t i = 0; i < turns.size(); ++i) {  // in the plane across X
        const Quat& q = turns[i];
        mirrored[static_cast<std::size_t>(partners[i])] = Quat(q.w(), q.x(), -q.y(), -q.z());
      }
      const Pose pose = with_turns(skeleton, turns), image = with_turns(skeleton, mirrored);
      for (int i = 0; i < kHumanoidBoneCount; ++i) {
        const auto bone = static_cast<HumanoidBone>(i);
        const int joint = rig.labels.joint(bone), partner = rig.labels.joint(mirror(bone));
        if (joint < 0 || limits.count(joint) == 0) continue;
        const double here = limit_violation(limits.at(joint), pose.local[static_cast<std::size_t>(joint)].rotation);
        const double there =
            limit_violation(limits.at(partner), image.local[static_cast<std::size_t>(partner)].rotation);
        EXPECT_NEAR(here, there, 0.02) << name << " " << to_string(bone);  // the rigs themselves mirror to 1e-4
      }
    }
  }
}

TEST(JointLimits, DancersAndCartoonsBendFarther) {
  const LabelledRig& rig = labelled_rig("gltf/m2m_human_male_custom_clip.glb");
  const auto of = [&](LimitPreset preset) { return by_joint(make_joint_limits(rig.skeleton(), rig.labels, preset)); };
  const int knee = rig.labels.joint(leftLowerLeg), hip = rig.labels.joint(leftUpperLeg);
  EXPECT_NEAR(of(LimitPreset::anatomical).at(knee).swing_max.x(), 150 * kDegree, 1e-12);
  EXPECT_NEAR(of(LimitPreset::dancer).at(hip).swing_max.x(), 156 * kDegree, 1e-12);
  EXPECT_NEAR(of(LimitPreset::cartoon).at(hip).swing_min.x(), -45 * kDegree, 1e-12);
  EXPECT_TRUE(of(LimitPreset::anatomical).at(knee).hinge);
  EXPECT_TRUE(of(LimitPreset::none).empty());
  EXPECT_TRUE(make_joint_limits(rig.skeleton(), HumanoidMap{}, LimitPreset::anatomical).empty());
}

TEST(JointLimits, ViolationsAreFoundAndClampedAway) {
  const LabelledRig& rig = labelled_rig("gltf/m2m_human_male_custom_clip.glb");
  const Skeleton skeleton = rig.skeleton();
  const auto limits = make_joint_limits(skeleton, rig.labels, LimitPreset::anatomical);
  EXPECT_TRUE(find_limit_violations(limits, rest_pose(skeleton)).empty());
  const int knee = rig.labels.joint(leftLowerLeg);
  Pose pose = turned(skeleton, knee, turn(Vec3::UnitX(), -50));  // the foot to the front
  EXPECT_EQ(find_limit_violations(limits, pose), (std::vector<int>{knee}));
  for (const JointLimit& limit : limits) {
    Quat& local = pose.local[static_cast<std::size_t>(limit.joint)].rotation;
    local = clamp_to_limit(limit, local);
  }
  EXPECT_TRUE(find_limit_violations(limits, pose).empty());
}

}  // namespace
}  // namespace croquis
