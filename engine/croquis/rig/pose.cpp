// SPDX-License-Identifier: MIT
#include "croquis/rig/pose.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "croquis/base/error.h"

namespace croquis {

Pose rest_pose(const Skeleton& skeleton) {
  Pose pose;
  pose.local.reserve(skeleton.joints().size());
  for (const Joint& joint : skeleton.joints()) pose.local.push_back(joint.rest);
  return pose;
}

void compute_model_transforms(const Skeleton& skeleton, const Pose& pose, std::span<Affine> model) {
  const int count = skeleton.joint_count();
  if (std::ssize(pose.local) != count || std::ssize(model) != count) {
    throw_invalid_argument("compute_model_transforms: the skeleton has " + std::to_string(count) +
                           " joints, the pose " + std::to_string(pose.local.size()) + ", the output " +
                           std::to_string(model.size()));
  }
  model[0] = pose.local[0].to_affine();
  for (std::size_t i = 1; i < model.size(); ++i) {
    model[i] = model[static_cast<std::size_t>(skeleton.parent(static_cast<int>(i)))] * pose.local[i].to_affine();
  }
}

std::vector<Affine> compute_model_transforms(const Skeleton& skeleton, const Pose& pose) {
  std::vector<Affine> model(skeleton.joints().size());
  compute_model_transforms(skeleton, pose, model);
  return model;
}

std::vector<Vec3> compute_positions(const Skeleton& skeleton, const Pose& pose) {
  std::vector<Vec3> positions;
  positions.reserve(skeleton.joints().size());
  for (const Affine& model : compute_model_transforms(skeleton, pose)) positions.emplace_back(model.translation());
  return positions;
}

double bone_length_drift(const Skeleton& skeleton, const Pose& before, const Pose& after) {
  const std::vector<Vec3> a = compute_positions(skeleton, before), b = compute_positions(skeleton, after);
  double drift = 0.0;
  for (int i = 1; i < skeleton.joint_count(); ++i) {
    const auto child = static_cast<std::size_t>(i), parent = static_cast<std::size_t>(skeleton.parent(i));
    const double length = (a[child] - a[parent]).norm();
    if (length <= 1e-6 * skeleton.extent()) continue;  // rounding would show
    drift = std::max(drift, std::abs((b[child] - b[parent]).norm() - length) / length);
  }
  return drift;
}

}  // namespace croquis
