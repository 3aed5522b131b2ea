// SPDX-License-Identifier: MIT
#include "croquis/posing/pose_edit.h"

#include <cmath>

#include "croquis/base/error.h"
#include "croquis/base/index.h"
#include "croquis/math/rotation.h"

namespace croquis {
namespace {

/// The rotation that a mirror makes of q: its axis reflected, its angle turned round.
Quat reflected(const Quat& q, const Vec3& normal) {
  const Vec3 v = q.vec();
  const Vec3 axial = 2.0 * normal * normal.dot(v) - v;  // an axial vector keeps its part along the normal
  return {q.w(), axial.x(), axial.y(), axial.z()};
}

/// The turn about the vertical that takes the heading at rest to the heading after `turn`. A body that lies on its
/// back or belly has none of its own: then its up axis shows where it points.
Quat heading_of(const Quat& turn, const Vec3& front) {
  Vec3 now = turn * front;
  Vec3 before = front;
  if (std::hypot(now.x(), now.z()) < 0.2) {
    now = turn * Vec3::UnitY() * (now.y() < 0.0 ? 1.0 : -1.0);
  }
  before.y() = now.y() = 0.0;
  if (before.norm() < 1e-9 || now.norm() < 1e-9) return Quat::Identity();
  const double angle = std::atan2(before.cross(now).y(), before.dot(now));
  return Quat(Eigen::AngleAxisd(angle, Vec3::UnitY()));
}

}  // namespace

int carrying_joint(const Skeleton& skeleton, const HumanoidMap& humanoid) {
  if (humanoid.has(HumanoidBone::hips)) return humanoid.joint(HumanoidBone::hips);
  for (int i = 0; i < skeleton.joint_count(); ++i) {
    if (!skeleton.joint(i).helper) return i;
  }
  return 0;
}

std::vector<Quat> compute_model_rotations(const Skeleton& skeleton, const Pose& pose) {
  std::vector<Quat> model;
  model.reserve(pose.local.size());
  for (int i = 0; i < skeleton.joint_count(); ++i) {
    const Quat& local = pose.local[at(i)].rotation;
    model.push_back(i == 0 ? local : Quat(model[at(skeleton.parent(i))] * local));
  }
  return model;
}

Pose mirror_pose(const Skeleton& skeleton, const HumanoidMap& humanoid, const std::vector<int>& mirror_map,
                 const Vec3& front, const Pose& pose, MirrorSide side) {
  const int count = skeleton.joint_count();
  if (std::ssize(pose.local) != count || std::ssize(mirror_map) != count) {
    throw_invalid_argument("mirror_pose: pose and mirror map must have one entry per joint");
  }
  const Pose rest = rest_pose(skeleton);
  const std::vector<Quat> rest_model = compute_model_rotations(skeleton, rest);
  const std::vector<Quat> pose_model = compute_model_rotations(skeleton, pose);
  const int centre = carrying_joint(skeleton, humanoid);
  const Quat heading = heading_of(pose_model[at(centre)] * rest_model[at(centre)].conjugate(), front);
  const Vec3 left = Vec3::UnitY().cross(front).normalized();

  Pose mirrored = pose;
  std::vector<Quat> mirrored_model(at(count));
  for (int i = 0; i < count; ++i) {
    const int partner = mirror_map[at(i)], parent = skeleton.parent(i);
    const Quat turn = heading.conjugate() * pose_model[at(partner)] * rest_model[at(partner)].conjugate();
    mirrored_model[at(i)] = skeleton.joint(i).helper
                                ? pose_model[at(i)]
                                : Quat(heading * reflected(turn, left) * rest_model[at(i)]).normalized();
    Transform& local = mirrored.local[at(i)];
    local.rotation = parent < 0 ? mirrored_model[at(i)]
                                : Quat(mirrored_model[at(parent)].conjugate() * mirrored_model[at(i)]).normalized();
    if (partner == i || parent < 0) continue;
    // A stretched bone stretches its partner likewise.
    const Transform& other = pose.local[at(partner)];
    const Vec3 stretch =
        rest_model[at(skeleton.parent(partner))] * (other.translation - rest.local[at(partner)].translation);
    const Vec3 reflected_stretch = stretch - 2.0 * left * left.dot(stretch);
    local.translation = rest.local[at(i)].translation + rest_model[at(parent)].conjugate() * reflected_stretch;
  }
  if (side == MirrorSide::both) return mirrored;
  Pose one_sided = pose;
  for (int i = 0; i < count; ++i) {
    const int partner = mirror_map[at(i)];
    if (partner == i) continue;
    const double across = left.dot(skeleton.rest_position(i) - skeleton.rest_position(partner));
    if ((across > 0.0) == (side == MirrorSide::right)) one_sided.local[at(i)] = mirrored.local[at(i)];
  }
  return one_sided;
}

Pose blend_pose(const Pose& pose, const Pose& goal, double amount, std::span<const int> joints) {
  if (pose.local.size() != goal.local.size()) throw_invalid_argument("blend_pose: the poses have different sizes");
  Pose blended = pose;
  const auto blend = [&](std::size_t i) { blended.local[i] = interpolate(pose.local[i], goal.local[i], amount); };
  if (joints.empty()) {
    for (std::size_t i = 0; i < pose.local.size(); ++i) blend(i);
  }
  for (const int joint : joints) {
    if (joint < 0 || joint >= std::ssize(pose.local)) {
      throw_invalid_argument("blend_pose: there is no joint " + std::to_string(joint));
    }
    blend(at(joint));
  }
  return blended;
}

Pose turn_joint(const Skeleton& skeleton, const Pose& pose, int joint, const Quat& turn_model) {
  if (joint < 0 || joint >= skeleton.joint_count()) {
    throw_invalid_argument("turn_joint: there is no joint " + std::to_string(joint));
  }
  const int parent = skeleton.parent(joint);
  const Quat parent_model = parent < 0 ? Quat::Identity() : compute_model_rotations(skeleton, pose)[at(parent)];
  Pose turned = pose;
  Quat& local = turned.local[at(joint)].rotation;
  local = (parent_model.conjugate() * turn_model.normalized() * parent_model * local).normalized();
  return turned;
}

Pose place_joint(const Skeleton& skeleton, const Pose& pose, int joint, const Vec3& position) {
  const int parent = skeleton.parent(joint);
  const Affine above = parent < 0 ? Affine::Identity() : compute_model_transforms(skeleton, pose)[at(parent)];
  Pose moved = pose;
  moved.local[at(joint)].translation = above.inverse() * position;
  return moved;
}

}  // namespace croquis
