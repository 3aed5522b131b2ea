// SPDX-License-Identifier: MIT
// The poses are written as turns away from the T-pose, bone by bone, in degrees about the body's own axes (x to its
// left, y up, z to its front): "x-30 z-75" is R_x(-30) R_z(-75). `both` writes a bone of the left side and its mirror
// image on the right. Signs to think in: trunk and head x+ bend forward, y+ turn left, z+ lean right; legs x- swing
// forward, z+ out (left); knees x+; feet x+ point the toes; left arm z- down, y- forward; left elbow y-.
#include "croquis/body/pose_shelf.h"

#include <array>
#include <string_view>

#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/math/rotation.h"

namespace croquis {
namespace {

struct Entry {
  std::string_view name;
  std::string_view turns;
};

constexpr std::array<Entry, 28> kBodies{{
    {"Relaxed", "both UpperArm z-76; both LowerArm y-18; both UpperLeg z3; spine x2; head x4"},
    {"Contrapposto",
     "hips z7; spine z-6; chest z-7; neck z5; head z3 y14 x4; rightUpperLeg z-7; leftUpperLeg x-16 z1 y16; "
     "leftLowerLeg x26; leftFoot x-6; rightFoot z7; leftUpperArm z-68 x8; leftLowerArm y-20; rightUpperArm z50 x70; "
     "rightLowerArm y98; rightHand y-38"},
    {"Hero", "both UpperArm z-46 x72; both LowerArm y-98; both Hand y38; both UpperLeg z11 y8; chest x-8; head x-6"},
    {"Walk",
     "hips y-6; spine x4 y6; chest y7; leftUpperLeg x-26; leftLowerLeg x8; leftFoot x-14; rightUpperLeg x22; "
     "rightLowerLeg x20; rightFoot x28; leftUpperArm x24 z-74; leftLowerArm y-18; rightUpperArm x-26 z74; "
     "rightLowerArm y26"},
    {"Run",
     "hips x14 y-10; spine x6 y8; chest y12; head x-14; leftUpperLeg x-72; leftLowerLeg x84; leftFoot x6; "
     "rightUpperLeg x26; rightLowerLeg x34; rightFoot x34; leftUpperArm x42 z-70; leftLowerArm y-88; rightUpperArm "
     "x-48 z66; rightLowerArm y96"},
    {"Sprint start",
     "hips x62; spine x18; chest x10; neck x-24; head x-22; leftUpperLeg x-112; leftLowerLeg x92; leftFoot x-8; "
     "rightUpperLeg x-58; rightLowerLeg x96; rightFoot x-2; both UpperArm x-58 z-78; both LowerArm y-8; both Hand z24"},
    {"Jump",
     "hips x-6; spine x-6; chest x-10; head x-12; both UpperArm z62 y-18; both LowerArm y-14; leftUpperLeg x-8 z8; "
     "leftLowerLeg x52; both Foot x40; rightUpperLeg x10 z-8; rightLowerLeg x62"},
    {"Leap",
     "hips x6; spine x-4; chest x-8 y10; head x-6; leftUpperLeg x-76 z6; leftLowerLeg x14; leftFoot x34; rightUpperLeg "
     "x58; rightLowerLeg x22; rightFoot x40; leftUpperArm z-12 y30; rightUpperArm z-34 y38; both LowerArm y-12"},
    {"Lunge",
     "hips y-16; spine x8 y8; chest y8; leftUpperLeg x-78 z10; leftLowerLeg x78; rightUpperLeg x34 z-8; rightLowerLeg "
     "x14; rightFoot x20; leftUpperArm z-28 y-56; leftLowerArm y-20; rightUpperArm z44 y-24; rightLowerArm y26"},
    {"Reach up",
     "spine z-5; chest z-8 x-6; head x-22 z-6; leftUpperArm z78 y-6; leftLowerArm y-6; rightUpperArm x8 z74; "
     "rightLowerArm y22; both Foot x38; leftUpperLeg z4; rightUpperLeg x-10 z-4; rightLowerLeg x18; both Toes x-36"},
    {"Throw",
     "hips y34; spine y12 x-8; chest y18 x-10 z8; neck y-24; head y-26; leftUpperLeg x-42 z14; leftLowerLeg x16; "
     "leftFoot x-18; rightUpperLeg x14 z-18; rightLowerLeg x34; leftUpperArm z8 y-42; leftLowerArm y-14; rightUpperArm "
     "z-24 y-36; rightLowerArm y104; rightHand z-20"},
    {"Bow",
     "hips x52; spine x16; chest x14; neck x10; head x8; both UpperLeg x-52; both UpperArm x-12 z-80; both LowerArm "
     "y-10"},
    {"Courtly bow",
     "hips x34; spine x18; chest x12; neck x8; leftUpperLeg x-60; rightUpperLeg x-14; rightLowerLeg x40; rightFoot "
     "x14; "
     "leftUpperArm x-22 z-52 y-38; leftLowerArm y-96; rightUpperArm z18 y-34; rightLowerArm y8"},
    {"Sit", "both UpperLeg x-88 z5; both LowerLeg x86; spine x4; both UpperArm x-26 z-76; both LowerArm y-38; head x4"},
    {"Sit on floor",
     "hips x-14; spine x16; chest x12; head x-8; both UpperLeg x-98 z12; both LowerLeg x104; both Foot x8; both "
     "UpperArm "
     "x-50 z-70; both LowerArm y-36"},
    {"Kneel",
     "leftUpperLeg x-90 z4; leftLowerLeg x92; rightUpperLeg x4; rightLowerLeg x88; rightFoot x36; spine x6; "
     "leftUpperArm "
     "x-34 z-72; leftLowerArm y-52; rightUpperArm z74; rightLowerArm y16"},
    {"Crouch",
     "hips x28; spine x18; chest x12; neck x-18; head x-18; both UpperLeg x-122 z16; both LowerLeg x126; both Foot "
     "x-14; "
     "both UpperArm x-48 z-70; both LowerArm y-30"},
    {"Thinking",
     "hips z-4; spine x6 z4; head x12 z6 y-8; rightUpperLeg x-8 z-4; rightLowerLeg x16; leftUpperArm x-22 z-74 x62; "
     "leftLowerArm y-96; rightUpperArm x-50 z72 x40; rightLowerArm y135; rightHand z-14"},
    {"Arms crossed",
     "chest x-3; head x3; both UpperLeg z6; leftUpperArm x-40 z-72 x64; leftLowerArm y-106; rightUpperArm x-22 z72 "
     "x64; rightLowerArm y100"},
    {"Wave",
     "spine z-3; head z-6 y10; leftUpperArm z14 y-10; leftLowerArm x-90 y-96; leftHand z-10; rightUpperArm z76; "
     "rightLowerArm y16; both UpperLeg z3"},
    {"Point ahead",
     "hips y-20; spine y6; head y16; leftUpperArm z-74; leftLowerArm y-20; rightUpperArm z4 y84; rightLowerArm y4; "
     "leftUpperLeg x-18 z6; leftLowerLeg x14; rightUpperLeg x16 z-8"},
    {"On guard",
     "hips y-32; spine x8 y6; chest x6; head y24 x4; leftUpperLeg x-34 z12; leftLowerLeg x40; rightUpperLeg x14 z-18; "
     "rightLowerLeg x34; leftUpperArm x-36 z-58 y-30; leftLowerArm y-112; rightUpperArm x-22 z64 y22; rightLowerArm "
     "y122"},
    {"Punch",
     "hips y26; spine y10 x6; chest y14; head y-34; leftUpperLeg x-30 z12; leftLowerLeg x30; rightUpperLeg x26 z-10; "
     "rightLowerLeg x12; rightFoot x18; leftUpperArm x-30 z-62 y-20; leftLowerArm y-116; rightUpperArm z6 y92; "
     "rightLowerArm y4"},
    {"High kick",
     "hips x-16 z12; spine x8 z-6; chest x8; head x8; leftUpperLeg x-112 z12; leftLowerLeg x8; leftFoot x26; "
     "rightUpperLeg x18 z-10; rightLowerLeg x10; leftUpperArm x24 z-48; leftLowerArm y-62; rightUpperArm x-30 z50; "
     "rightLowerArm y84"},
    {"Arabesque",
     "hips x42; spine x-22; chest x-24; neck x-12; head x-12; leftUpperLeg x-42; rightUpperLeg x52; rightLowerLeg x4; "
     "both Foot x16; leftUpperArm z22 y-62; rightUpperArm z14 y-22; both LowerArm y-8"},
    {"Hero landing",
     "hips x34 y-10; spine x16; chest x8; neck x-20; head x-20; leftUpperLeg x-116 z16; leftLowerLeg x112; "
     "rightUpperLeg "
     "x-26 z-26; rightLowerLeg x112; rightFoot x24; rightUpperArm x-46 z72; rightLowerArm y10; leftUpperArm x48 z-26; "
     "leftLowerArm y-16"},
    {"Startled",
     "hips x-10; spine x-8; chest x-10; head x-10; leftUpperLeg x-26 z8; leftLowerLeg x34; rightUpperLeg x12 z-8; "
     "rightLowerLeg x26; both UpperArm z-18 y-34; both LowerArm x-60 y-96; both Hand z24"},
    {"Victory",
     "chest x-10; head x-16; both UpperArm z46 y-8; both LowerArm y-20; both UpperLeg z12; both LowerLeg x4"},
}};

constexpr std::array<Entry, 8> kHands{{
    {"Hand at rest",
     "both ThumbMetacarpal y8; both ThumbProximal y8; both ThumbDistal y10; both IndexProximal z-16; both "
     "IndexIntermediate z-20; both IndexDistal z-10; both MiddleProximal z-22; both MiddleIntermediate z-26; both "
     "MiddleDistal z-12; both RingProximal z-26; both RingIntermediate z-30; both RingDistal z-14; both LittleProximal "
     "z-30; both LittleIntermediate z-32; both LittleDistal z-16"},
    {"Open",
     "both ThumbMetacarpal y-14; both ThumbProximal y0; both ThumbDistal y-6; both IndexProximal y-6; both "
     "IndexIntermediate z0; both IndexDistal z0; both MiddleProximal z2; both MiddleIntermediate z0; both MiddleDistal "
     "z0; both RingProximal y6; both RingIntermediate z0; both RingDistal z0; both LittleProximal y14; both "
     "LittleIntermediate z0; both LittleDistal z0"},
    {"Fist",
     "both ThumbMetacarpal y24 x30; both ThumbProximal y34 z-12; both ThumbDistal y44; both IndexProximal z-84; both "
     "IndexIntermediate z-98; both IndexDistal z-56; both MiddleProximal z-86; both MiddleIntermediate z-100; both "
     "MiddleDistal z-58; both RingProximal z-86; both RingIntermediate z-100; both RingDistal z-58; both "
     "LittleProximal "
     "z-88; both LittleIntermediate z-98; both LittleDistal z-56"},
    {"Point",
     "both ThumbMetacarpal y22 x24; both ThumbProximal y30; both ThumbDistal y40; both IndexProximal z-2; both "
     "IndexIntermediate z-4; both IndexDistal z-2; both MiddleProximal z-82; both MiddleIntermediate z-96; both "
     "MiddleDistal z-54; both RingProximal z-84; both RingIntermediate z-98; both RingDistal z-56; both LittleProximal "
     "z-86; both LittleIntermediate z-96; both LittleDistal z-54"},
    {"Grip",
     "both ThumbMetacarpal y14 x24; both ThumbProximal y22; both ThumbDistal y28; both IndexProximal z-56; both "
     "IndexIntermediate z-62; both IndexDistal z-34; both MiddleProximal z-60; both MiddleIntermediate z-64; both "
     "MiddleDistal z-36; both RingProximal z-64; both RingIntermediate z-66; both RingDistal z-38; both LittleProximal "
     "z-68; both LittleIntermediate z-66; both LittleDistal z-38"},
    {"Pinch",
     "both ThumbMetacarpal y16 x26; both ThumbProximal y16; both ThumbDistal y24; both IndexProximal z-48; both "
     "IndexIntermediate z-54; both IndexDistal z-26; both MiddleProximal z-28; both MiddleIntermediate z-32; both "
     "MiddleDistal z-14; both RingProximal z-22; both RingIntermediate z-24; both RingDistal z-12; both LittleProximal "
     "z-14; both LittleIntermediate z-18; both LittleDistal z-10"},
    {"Two fingers",
     "both ThumbMetacarpal y26 x30; both ThumbProximal y34; both ThumbDistal y46; both IndexProximal y-8; both "
     "IndexIntermediate z-2; both IndexDistal z0; both MiddleProximal y8; both MiddleIntermediate z-2; both "
     "MiddleDistal z0; both RingProximal z-84; both RingIntermediate z-98; both RingDistal z-56; both LittleProximal "
     "z-86; both LittleIntermediate z-96; both LittleDistal z-54"},
    {"Thumb up",
     "both ThumbMetacarpal y-20; both ThumbProximal y-8; both ThumbDistal y-14; both IndexProximal z-84; both "
     "IndexIntermediate z-98; both IndexDistal z-56; both MiddleProximal z-86; both MiddleIntermediate z-100; both "
     "MiddleDistal z-58; both RingProximal z-86; both RingIntermediate z-100; both RingDistal z-58; both "
     "LittleProximal "
     "z-88; both LittleIntermediate z-98; both LittleDistal z-56"},
}};

/// The poses whose feet leave the floor.
bool is_in_the_air(std::string_view name) { return name == "Jump" || name == "Leap"; }

[[noreturn]] void fail(std::string_view turns) {
  throw Error(ErrorCode::internal, "pose shelf: cannot read '" + std::string(turns) + "'");
}

/// "x-30 z-75" -> R_x(-30) R_z(-75).
Quat parse_turns(std::string_view text) {
  Quat q = Quat::Identity();
  for (const std::string& word : split(trim(text), ' ')) {
    if (word.empty()) continue;
    const std::optional<int> degrees = parse_int(std::string_view(word).substr(1));
    if (word[0] < 'x' || word[0] > 'z' || !degrees) fail(text);
    q = q * Quat(Eigen::AngleAxisd(*degrees * kDegree, Vec3::Unit(word[0] - 'x')));
  }
  return q;
}

void set_turn(HumanoidPose& pose, std::string_view bone_name, const Quat& turn) {
  const std::optional<HumanoidBone> bone = parse_humanoid_bone(bone_name);
  if (!bone) fail(bone_name);
  pose.turns[static_cast<std::size_t>(*bone)] = turn;
}

/// The trunk's and limbs' bones that a body pose does not name stand as in the T-pose; fingers are left alone.
void fill_with_identity(HumanoidPose& pose) {
  for (int i = 0; i < static_cast<int>(HumanoidBone::leftThumbMetacarpal); ++i) {
    const auto bone = static_cast<HumanoidBone>(i);
    const bool face = bone == HumanoidBone::leftEye || bone == HumanoidBone::rightEye || bone == HumanoidBone::jaw;
    std::optional<Quat>& turn = pose.turns[static_cast<std::size_t>(i)];
    if (!face && !turn) turn = Quat::Identity();
  }
}

HumanoidPose parse_pose(std::string_view text) {
  HumanoidPose pose;
  for (const std::string& clause : split(text, ';')) {
    std::string_view rest = trim(clause);
    const bool both = rest.starts_with("both ");
    if (both) rest.remove_prefix(5);
    const std::size_t space = rest.find(' ');
    if (space == std::string_view::npos) fail(clause);
    const std::string bone(rest.substr(0, space));
    const Quat turn = parse_turns(rest.substr(space));
    if (!both) {
      set_turn(pose, bone, turn);
      continue;
    }
    set_turn(pose, "left" + bone, turn);
    set_turn(pose, "right" + bone, Quat(turn.w(), turn.x(), -turn.y(), -turn.z()));
  }
  return pose;
}

}  // namespace

std::vector<ShelfPose> make_pose_shelf() {
  std::vector<ShelfPose> shelf;
  for (const Entry& entry : kBodies) {
    ShelfPose pose{std::string(entry.name), ShelfPose::Kind::body, parse_pose(entry.turns), !is_in_the_air(entry.name)};
    fill_with_identity(pose.pose);
    if (is_in_the_air(entry.name)) pose.pose.hips_offset = Vec3(0.0, 0.28, 0.0);
    shelf.push_back(std::move(pose));
  }
  for (const Entry& entry : kHands) {
    shelf.push_back({std::string(entry.name), ShelfPose::Kind::hand, parse_pose(entry.turns), false});
  }
  return shelf;
}

}  // namespace croquis
