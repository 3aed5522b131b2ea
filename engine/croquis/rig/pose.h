// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "croquis/rig/skeleton.h"

namespace croquis {

/// How a body stands: parent_from_joint of every joint, in the skeleton's order. A plain value.
struct Pose {
  std::vector<Transform> local;

  [[nodiscard]] friend bool operator==(const Pose&, const Pose&) = default;
};

[[nodiscard]] Pose rest_pose(const Skeleton& skeleton);

/// Forward kinematics, parent before child, in one pass:
///     model[0] = T(local[0]),   model[i] = model[parent(i)] * T(local[i]).
/// `model` holds joint_count() elements and receives model_from_joint of each joint; throws invalid_argument if a size
/// is off. The form that returns a vector calls the other.
void compute_model_transforms(const Skeleton& skeleton, const Pose& pose, std::span<Affine> model);
[[nodiscard]] std::vector<Affine> compute_model_transforms(const Skeleton& skeleton, const Pose& pose);

/// Joint positions in model space.
[[nodiscard]] std::vector<Vec3> compute_positions(const Skeleton& skeleton, const Pose& pose);

/// The largest relative change of a bone's length between two poses of one skeleton, over all bones longer than 1e-6
/// of the skeleton's extent.
[[nodiscard]] double bone_length_drift(const Skeleton& skeleton, const Pose& before, const Pose& after);

}  // namespace croquis
