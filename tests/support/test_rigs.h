// SPDX-License-Identifier: MIT
// Small bodies made for tests: chains, a humanoid with VRM names, a quadruped, each with any rolls of its bones.
#pragma once

#include "support/random_math.h"
#include <string>
#include <vector>

#include "croquis/math/rotation.h"
#include "croquis/rig/pose.h"

namespace croquis {

/// A joint by its position in space; test bodies are written in these.
struct PlacedJoint {
  std::string name;
  int parent;
  Vec3 position;
};

/// The skeleton with these rest positions. With a seed every joint gets its own random rest orientation (a bone's
/// roll and axes mean nothing to a correct algorithm); without, all orientations are the identity.
inline Skeleton make_skeleton(const std::vector<PlacedJoint>& placed, std::uint64_t seed = 0) {
  Random random(seed);
  std::vector<Quat> orientation;
  std::vector<Joint> joints;
  for (const PlacedJoint& p : placed) {
    orientation.push_back(seed == 0 ? Quat::Identity() : random_rotation(random));
    Joint joint;
    joint.name = p.name;
    joint.parent = p.parent;
    const auto up = static_cast<std::size_t>(p.parent);
    const Quat above = p.parent < 0 ? Quat::Identity() : orientation[up];
    const Vec3 origin = p.parent < 0 ? Vec3::Zero() : placed[up].position;
    joint.rest.translation = above.conjugate() * (p.position - origin);
    joint.rest.rotation = (above.conjugate() * orientation.back()).normalized();
    joints.push_back(joint);
  }
  return Skeleton(joints);
}

/// `count` joints one above the other, `step` apart.
inline Skeleton make_chain(int count, double step = 0.1, std::uint64_t seed = 0) {
  std::vector<PlacedJoint> placed;
  for (int i = 0; i < count; ++i) placed.push_back({"joint" + std::to_string(i), i - 1, Vec3(0, step * i, 0)});
  return make_skeleton(placed, seed);
}

/// 1.75 units high, facing +Z, arms a little down from a T, knees and elbows a little bent.
inline Skeleton make_test_humanoid(std::uint64_t seed = 0) {
  std::vector<PlacedJoint> p = {{"hips", -1, Vec3(0, 0.95, 0)},      {"spine", 0, Vec3(0, 1.07, 0.01)},
                                {"chest", 1, Vec3(0, 1.21, 0)},      {"upperChest", 2, Vec3(0, 1.34, -0.01)},
                                {"neck", 3, Vec3(0, 1.48, -0.01)},   {"head", 4, Vec3(0, 1.58, 0.01)},
                                {"head_end", 5, Vec3(0, 1.75, 0.02)}};
  for (const double side : {1.0, -1.0}) {
    const std::string name = side > 0 ? "left" : "right";
    const int leg = static_cast<int>(p.size());
    p.push_back({name + "UpperLeg", 0, Vec3(0.09 * side, 0.90, 0)});
    p.push_back({name + "LowerLeg", leg, Vec3(0.10 * side, 0.49, 0.01)});
    p.push_back({name + "Foot", leg + 1, Vec3(0.10 * side, 0.08, -0.02)});
    p.push_back({name + "Toes", leg + 2, Vec3(0.11 * side, 0.02, 0.12)});
    const int arm = static_cast<int>(p.size());
    p.push_back({name + "Shoulder", 3, Vec3(0.03 * side, 1.42, 0)});
    p.push_back({name + "UpperArm", arm, Vec3(0.17 * side, 1.42, -0.01)});
    p.push_back({name + "LowerArm", arm + 1, Vec3(0.40 * side, 1.28, -0.02)});
    p.push_back({name + "Hand", arm + 2, Vec3(0.60 * side, 1.16, 0.02)});
    p.push_back({name + "MiddleProximal", arm + 3, Vec3(0.68 * side, 1.11, 0.03)});
  }
  return make_skeleton(p, seed);
}

/// A long-tailed animal, facing +Z, root at the pelvis.
inline Skeleton make_test_quadruped(std::uint64_t seed = 0) {
  std::vector<PlacedJoint> p = {
      {"pelvis", -1, Vec3(0, 0.5, -0.4)},  {"spine1", 0, Vec3(0, 0.54, -0.15)}, {"spine2", 1, Vec3(0, 0.55, 0.1)},
      {"withers", 2, Vec3(0, 0.52, 0.32)}, {"neck", 3, Vec3(0, 0.62, 0.45)},    {"head", 4, Vec3(0, 0.70, 0.55)},
      {"snout", 5, Vec3(0, 0.66, 0.70)},   {"tail1", 0, Vec3(0, 0.5, -0.55)},   {"tail2", 7, Vec3(0, 0.47, -0.7)},
      {"tail3", 8, Vec3(0, 0.45, -0.85)},  {"tail_end", 9, Vec3(0, 0.44, -1.0)}};
  for (const double side : {1.0, -1.0}) {
    const std::string name = side > 0 ? "left_" : "right_";
    const int hind = static_cast<int>(p.size());
    p.push_back({name + "hip", 0, Vec3(0.08 * side, 0.45, -0.4)});
    p.push_back({name + "knee", hind, Vec3(0.09 * side, 0.28, -0.32)});
    p.push_back({name + "hock", hind + 1, Vec3(0.09 * side, 0.13, -0.45)});
    p.push_back({name + "hind_foot", hind + 2, Vec3(0.09 * side, 0.02, -0.40)});
    const int fore = static_cast<int>(p.size());
    p.push_back({name + "shoulder", 3, Vec3(0.08 * side, 0.42, 0.36)});
    p.push_back({name + "elbow", fore, Vec3(0.09 * side, 0.28, 0.27)});
    p.push_back({name + "wrist", fore + 1, Vec3(0.09 * side, 0.12, 0.30)});
    p.push_back({name + "fore_foot", fore + 2, Vec3(0.09 * side, 0.02, 0.34)});
  }
  return make_skeleton(p, seed);
}

/// Every joint turned at random by up to about `size` radians.
inline Pose random_pose(const Skeleton& skeleton, Random& random, double size) {
  Pose pose = rest_pose(skeleton);
  for (Transform& local : pose.local) {
    local.rotation = (local.rotation * rotation_from_vector(size * random_vector(random) / 1.7)).normalized();
  }
  return pose;
}

}  // namespace croquis
