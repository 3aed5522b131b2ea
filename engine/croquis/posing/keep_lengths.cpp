// SPDX-License-Identifier: MIT
#include "croquis/posing/keep_lengths.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace croquis {

bool scales_unevenly(const Mat3& linear) {
  const Mat3 square = linear.transpose() * linear;
  const double mean = square.trace() / 3.0;
  return !((square - mean * Mat3::Identity()).norm() <= 1e-9 * mean);
}

void keep_bone_lengths(const Skeleton& skeleton, const Pose& start, std::span<const Vec3> wanted, Pose& pose) {
  // A bone changes its length only below a joint whose own scale, or that of one above it, is uneven.
  const auto uneven = [](const Transform& local) {
    const Vec3 s = local.scale.cwiseAbs();
    return s.maxCoeff() - s.minCoeff() > 1e-12 * s.maxCoeff();
  };
  if (std::none_of(start.local.begin(), start.local.end(), uneven)) return;
  const std::vector<Affine> before = compute_model_transforms(skeleton, start);
  std::vector<Affine> after(before.size());
  after[0] = pose.local[0].to_affine();
  for (int joint = 1; joint < skeleton.joint_count(); ++joint) {
    const auto at = static_cast<std::size_t>(joint), parent = static_cast<std::size_t>(skeleton.parent(joint));
    Transform& local = pose.local[at];
    const Mat3 above = after[parent].linear();
    if (scales_unevenly(before[parent].linear()) && std::abs(above.determinant()) > 1e-30) {
      const Vec3 origin = after[parent].translation(), arm = above * local.translation;
      const double length = (before[at].translation() - before[parent].translation()).norm();
      Vec3 target = wanted.empty() ? Vec3(origin + arm) : wanted[at];
      if (wanted.empty() && arm.norm() > 0.0) target = origin + arm * (length / arm.norm());
      const Vec3 translation = above.inverse() * (target - origin);
      if (translation.allFinite()) local.translation = translation;
    }
    after[at] = after[parent] * local.to_affine();
  }
}

}  // namespace croquis
