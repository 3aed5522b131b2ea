// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "croquis/picture/scene.h"

namespace croquis {
namespace {

constexpr int kAround = 20;  ///< vertices round a limb
constexpr int kCap = 5;      ///< rings in the half ball at each end

/// A tapered capsule from `a` to `b`: a half ball at each end, a cone between. Also a ball, where a = b.
void add_capsule(Mesh& mesh, const Vec3& a, double radius_a, const Vec3& b, double radius_b) {
  const double length = (b - a).norm();
  const Vec3 axis = length > 1e-12 ? Vec3((b - a) / length) : Vec3::UnitY();
  const Vec3 x = axis.unitOrthogonal();
  const Vec3 y = axis.cross(x);
  // The slope of the cone, so that the half balls meet it without a crease.
  const double slope = length > 1e-12 ? std::clamp((radius_a - radius_b) / length, -0.99, 0.99) : 0.0;
  const double tilt = std::asin(slope);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (int ring = 0; ring <= 2 * kCap + 1; ++ring) {
    const bool low = ring <= kCap;
    const double part = low ? static_cast<double>(ring) / kCap : static_cast<double>(ring - kCap - 1) / kCap;
    const double latitude = low ? -0.5 * kPi + part * (tilt + 0.5 * kPi) : tilt + part * (0.5 * kPi - tilt);
    for (int i = 0; i < kAround; ++i) {
      const double angle = 2.0 * kPi * i / kAround;
      const Vec3 normal = std::cos(latitude) * (std::cos(angle) * x + std::sin(angle) * y) + std::sin(latitude) * axis;
      mesh.positions.push_back((low ? Vec3(a + radius_a * normal) : Vec3(b + radius_b * normal)).cast<float>());
      mesh.normals.push_back(normal.cast<float>());
    }
  }
  for (std::uint32_t ring = 0; ring <= 2 * kCap; ++ring) {
    for (std::uint32_t i = 0; i < kAround; ++i) {
      const std::uint32_t next = (i + 1) % kAround;
      const std::uint32_t p = first + ring * kAround + i, q = first + ring * kAround + next;
      for (const std::uint32_t index : {p, q, p + kAround, q, q + kAround, p + kAround})
        mesh.triangles.push_back(index);
    }
  }
}

/// A thickness for each joint: that of a limb as long as its bones, within what looks like a body.
std::vector<double> joint_radii(const Skeleton& skeleton, const std::vector<Vec3>& positions) {
  std::vector<double> radii;
  for (int j = 0; j < skeleton.joint_count(); ++j) {
    double longest = 0.0;
    const auto bone = [&](int parent, int child) {
      if (skeleton.joint(parent).helper || skeleton.joint(child).helper) return;
      const Vec3& from = positions[static_cast<std::size_t>(parent)];
      longest = std::max(longest, (positions[static_cast<std::size_t>(child)] - from).norm());
    };
    if (skeleton.parent(j) >= 0) bone(skeleton.parent(j), j);
    for (const int child : skeleton.children(j)) bone(j, child);
    radii.push_back(std::clamp(0.13 * longest, 0.004 * skeleton.extent(), 0.018 * skeleton.extent()));
  }
  return radii;
}

void add_head(Mesh& mesh, const Character& character, const std::vector<Vec3>& positions) {
  const int head = character.humanoid.joint(HumanoidBone::head);
  if (head < 0) return;
  const Skeleton& skeleton = character.skeleton;
  const Vec3& at = positions[static_cast<std::size_t>(head)];
  const Vec3 from = skeleton.parent(head) >= 0 ? positions[static_cast<std::size_t>(skeleton.parent(head))] : at;
  Vec3 up = (at - from).stableNormalized();
  if (skeleton.children(head).size() == 1) {
    const Vec3 end = positions[static_cast<std::size_t>(skeleton.children(head)[0])] - at;
    if (end.norm() > 1e-6 * skeleton.extent()) up = end.normalized();
  }
  const double radius = 0.036 * skeleton.extent();
  add_capsule(mesh, at + 0.5 * radius * up, 0.8 * radius, at + 1.5 * radius * up, radius);
}

}  // namespace

Mesh build_bone_mesh(const Character& character, const Pose& pose) {
  const Skeleton& skeleton = character.skeleton;
  const std::vector<Vec3> positions = compute_positions(skeleton, pose);
  const std::vector<double> radii = joint_radii(skeleton, positions);
  Mesh mesh;
  for (int j = 0; j < skeleton.joint_count(); ++j) {
    const int parent = skeleton.parent(j);
    if (parent < 0 || skeleton.joint(j).helper || skeleton.joint(parent).helper) continue;
    const auto a = static_cast<std::size_t>(parent), b = static_cast<std::size_t>(j);
    if ((positions[b] - positions[a]).norm() < 1e-6 * skeleton.extent()) continue;
    const double end = skeleton.children(j).empty() ? 0.6 * radii[b] : radii[b];
    add_capsule(mesh, positions[a], std::min(radii[a], 1.6 * end), positions[b], end);
  }
  if (!mesh.positions.empty()) add_head(mesh, character, positions);
  return mesh;
}

std::vector<int> compute_sides(const Character& character) {
  const Skeleton& skeleton = character.skeleton;
  std::vector<int> sides(static_cast<std::size_t>(skeleton.joint_count()), 0);
  for (int j = 0; j < skeleton.joint_count(); ++j) {
    int& side = sides[static_cast<std::size_t>(j)];
    if (const auto bone = character.humanoid.bone_of(j)) {
      const std::string_view name = to_string(*bone);
      side = name.starts_with("left") ? 1 : name.starts_with("right") ? -1 : 0;
    } else if (skeleton.parent(j) >= 0) {
      side = sides[static_cast<std::size_t>(skeleton.parent(j))];
    }
  }
  return sides;
}

}  // namespace croquis
