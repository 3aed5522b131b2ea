// SPDX-License-Identifier: MIT
// Proportions after the eight-head canon of figure drawing (loomis1943): crotch at half the height, knees at a quarter,
// elbows at the waist, wrists at the crotch.
#include "croquis/body/mannequin.h"

#include <array>
#include <cmath>

#include "croquis/body/sculpture.h"

namespace croquis {
namespace {

constexpr double kHeight = 1.76;       // of eight heads, metres
constexpr double kHipHeight = 4.25;    // units, at limbs = 1
constexpr double kAnkleHeight = 0.36;  // units

struct FingerPlan {
  const char* name;
  Vec3 knuckle;  // in hands from the wrist: x to the fingertips, y up, z to the thumb's side
  double lengths[3];
  double splay_degrees;  // towards the thumb
  double curl_degrees[3];
};

constexpr const char* kSegments[3] = {"Proximal", "Intermediate", "Distal"};

const std::array<FingerPlan, 4>& fingers() {
  static const std::array<FingerPlan, 4> plans{{
      {"leftIndex", {0.470, 0.012, 0.168}, {0.205, 0.125, 0.085}, 5.0, {7.0, 14.0, 9.0}},
      {"leftMiddle", {0.490, 0.020, 0.056}, {0.225, 0.145, 0.090}, 0.5, {9.0, 16.0, 10.0}},
      {"leftRing", {0.470, 0.012, -0.058}, {0.210, 0.135, 0.088}, -4.0, {11.0, 18.0, 11.0}},
      {"leftLittle", {0.430, -0.004, -0.165}, {0.165, 0.100, 0.078}, -9.5, {13.0, 19.0, 11.0}},
  }};
  return plans;
}

void add_fingers(Armature& armature, int hand, double size) {
  const Vec3 wrist = armature.position(hand);
  for (const FingerPlan& finger : fingers()) {
    Vec3 at = wrist + size * finger.knuckle;
    int parent = hand;
    double pitch = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      parent = armature.add_pair(std::string(finger.name) + kSegments[i], parent, at);
      pitch += finger.curl_degrees[i] * kDegree;
      const double yaw = finger.splay_degrees * kDegree;
      const Vec3 along(std::cos(pitch) * std::cos(yaw), -std::sin(pitch), std::cos(pitch) * std::sin(yaw));
      at += size * finger.lengths[i] * along;
    }
  }
  const int metacarpal = armature.add_pair("leftThumbMetacarpal", hand, wrist + size * Vec3(0.09, -0.035, 0.115));
  const int proximal = armature.add_pair("leftThumbProximal", metacarpal, wrist + size * Vec3(0.245, -0.085, 0.250));
  armature.add_pair("leftThumbDistal", proximal, wrist + size * Vec3(0.375, -0.115, 0.350));
}

}  // namespace

MannequinMeasures::MannequinMeasures(const Proportions& p) {
  // Fewer heads make a smaller figure, as children are, with somewhat thicker limbs and larger hands for its size.
  const double height = kHeight * std::sqrt(p.heads / 8.0);
  const double stout = std::pow(8.0 / p.heads, 0.2);
  const double head_at_one = height / p.heads;
  unit = (height - head_at_one) / 7.0;
  head = head_at_one * p.head;
  leg_long = p.limbs;
  arm_long = p.limbs;
  lift = (p.limbs - 1.0) * (kHipHeight - kAnkleHeight) * unit;
  chin = height - head_at_one + lift;
  thick = stout * std::pow(p.muscle, 0.6);
  trunk_thick = std::pow(stout, 0.6) * std::pow(p.muscle, 0.35);
  hip_wide = p.hips;
  shoulder_wide = p.shoulders;
  hand = 0.80 * unit * std::pow(8.0 / p.heads, 0.3) * p.hands;
  foot = unit * std::pow(8.0 / p.heads, 0.2) * (0.4 + 0.6 * p.hands);
}

Armature make_mannequin_armature(const MannequinMeasures& m) {
  const double u = m.unit;
  const auto at = [&](double x, double y, double z) { return Vec3(u * x, m.lift + u * y, u * z); };
  Armature a;
  const int hips = a.add("hips", -1, at(0.0, 4.38, -0.02));
  const int spine = a.add("spine", hips, at(0.0, 4.86, -0.04));
  const int chest = a.add("chest", spine, at(0.0, 5.36, -0.07));
  const int upper_chest = a.add("upperChest", chest, at(0.0, 5.92, -0.13));
  const int neck = a.add("neck", upper_chest, at(0.0, 6.66, -0.13));
  a.add("head", neck, Vec3(0.0, m.chin + 0.10 * m.head, -0.04 * u));

  const double w = m.shoulder_wide;
  const int shoulder = a.add_pair("leftShoulder", upper_chest, at(0.12 * w, 6.50, -0.04));
  const double upper_arm_x = 0.12 * w + 0.66 * w;
  const int upper_arm = a.add_pair("leftUpperArm", shoulder, at(upper_arm_x, 6.42, -0.08));
  const int lower_arm = a.add_pair("leftLowerArm", upper_arm, at(upper_arm_x + 1.28 * m.arm_long, 6.42, -0.09));
  const int hand = a.add_pair("leftHand", lower_arm, at(upper_arm_x + 2.46 * m.arm_long, 6.42, -0.06));
  add_fingers(a, hand, m.hand);

  const double hip_x = 0.41 * m.hip_wide, knee_x = 0.17 + 0.21 * m.hip_wide, ankle_x = 0.20 + 0.16 * m.hip_wide;
  const int upper_leg = a.add_pair("leftUpperLeg", hips, at(hip_x, 4.25, -0.01));
  const double ankle_y = 0.36 * m.foot, hip_y = a.position(upper_leg).y();
  const double knee_y = ankle_y + 0.462 * (hip_y - ankle_y);
  const int lower_leg = a.add_pair("leftLowerLeg", upper_leg, Vec3(u * knee_x, knee_y, u * 0.015));
  const int foot = a.add_pair("leftFoot", lower_leg, Vec3(u * ankle_x, ankle_y, -u * 0.10));
  a.add_pair("leftToes", foot, a.position(foot) + m.foot * Vec3(0.05, -0.27, 0.50));
  return a;
}

Character make_mannequin(const Proportions& proportions) {
  const MannequinMeasures measures(proportions);
  const Armature armature = make_mannequin_armature(measures);
  Sculpture sculpture;
  sculpture.name = "body";
  sculpture.mirrored = true;
  sculpture.color = Vec4f(0.72F, 0.52F, 0.36F, 1.0F);
  sculpture.root = make_trunk(measures, armature);
  sculpture.root.limbs.push_back(make_head(measures, armature));
  sculpture.root.limbs.push_back(make_arm(measures, armature));
  sculpture.root.limbs.push_back(make_leg(measures, armature));
  Character character = assemble("mannequin", armature, std::move(sculpture));
  for (int j = 0; j < character.skeleton.joint_count(); ++j) {
    if (const auto bone = parse_humanoid_bone(character.skeleton.name(j))) character.humanoid.set(*bone, j, 1.0);
  }
  return character;
}

}  // namespace croquis
