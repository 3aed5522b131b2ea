// SPDX-License-Identifier: MIT
// Buss 2004, "Introduction to inverse kinematics with Jacobian transpose, pseudoinverse and damped least squares
// methods": the damping follows the error, so that a goal out of reach makes the limb stretch out, not shake.
#include "croquis/posing/reach.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "croquis/base/error.h"
#include "croquis/base/index.h"
#include "croquis/base/text.h"
#include "croquis/math/rotation.h"
#include "croquis/posing/pose_edit.h"

namespace croquis {
namespace {

double largest_distance(const std::vector<Affine>& model, std::span<const ReachGoal> goals, int* worst = nullptr) {
  double largest = 0.0;
  for (const ReachGoal& goal : goals) {
    const double distance = (goal.position - model[at(goal.joint)].translation()).norm();
    if (distance >= largest) {
      largest = distance;
      if (worst != nullptr) *worst = goal.joint;
    }
  }
  return largest;
}

/// Turns the moving joints by the step (rotation vectors in model space), the topmost first, limits kept.
Pose stepped(const Skeleton& skeleton, const Pose& pose, std::span<const int> moving, const Eigen::VectorXd& step,
             const std::vector<JointLimit>& limits) {
  const std::vector<Quat> model = compute_model_rotations(skeleton, pose);
  Pose next = pose;
  for (int k = 0; k < std::ssize(moving); ++k) {
    const int joint = moving[at(k)], parent = skeleton.parent(joint);
    const Quat above = parent < 0 ? Quat::Identity() : model[at(parent)];
    Quat& local = next.local[at(joint)].rotation;
    local = (above.conjugate() * rotation_from_vector(step.segment<3>(3 * k)) * above * local).normalized();
    const auto limit =
        std::find_if(limits.begin(), limits.end(), [&](const JointLimit& l) { return l.joint == joint; });
    if (limit != limits.end()) local = clamp_to_limit(*limit, local);
  }
  return next;
}

/// Residuals (goal minus place) and how they change with the turns of the moving joints.
void linearise(const Skeleton& skeleton, const std::vector<Affine>& model, std::span<const ReachGoal> goals,
               std::span<const int> moving, Eigen::MatrixXd& jacobian, Eigen::VectorXd& residual) {
  jacobian.setZero(3 * std::ssize(goals), 3 * std::ssize(moving));
  residual.resize(3 * std::ssize(goals));
  for (int g = 0; g < std::ssize(goals); ++g) {
    const Vec3 place = model[at(goals[at(g)].joint)].translation();
    residual.segment<3>(3 * g) = goals[at(g)].position - place;
    for (int k = 0; k < std::ssize(moving); ++k) {
      const int joint = moving[at(k)];
      if (joint == goals[at(g)].joint || !skeleton.is_ancestor(joint, goals[at(g)].joint)) continue;
      const Vec3 arm = place - model[at(joint)].translation();
      for (int axis = 0; axis < 3; ++axis) jacobian.block<3, 1>(3 * g, 3 * k + axis) = Vec3::Unit(axis).cross(arm);
    }
  }
}

}  // namespace

ReachResult solve_reach(const Skeleton& skeleton, const Pose& start, std::span<const ReachGoal> goals,
                        std::span<const int> moving, const std::vector<JointLimit>& limits,
                        const ReachOptions& options) {
  const auto is_joint = [&](int joint) { return joint >= 0 && joint < skeleton.joint_count(); };
  for (const ReachGoal& goal : goals) {
    if (!is_joint(goal.joint) || !goal.position.allFinite()) {
      throw_invalid_argument("solve_reach: a goal names no joint or is not finite");
    }
  }
  if (!std::all_of(moving.begin(), moving.end(), is_joint))
    throw_invalid_argument("solve_reach: no such joint to move");

  ReachResult result{start};
  std::vector<Affine> model = compute_model_transforms(skeleton, result.pose);
  double distance = largest_distance(model, goals);
  double damping = 0.05;
  Eigen::MatrixXd jacobian;
  Eigen::VectorXd residual;
  for (int i = 0; i < options.iterations && distance > options.tolerance * skeleton.extent() && !moving.empty(); ++i) {
    linearise(skeleton, model, goals, moving, jacobian, residual);
    const double size = skeleton.extent() * skeleton.extent();
    const Eigen::MatrixXd normal =
        jacobian.transpose() * jacobian +
        damping * damping * size * Eigen::MatrixXd::Identity(jacobian.cols(), jacobian.cols());
    const Eigen::VectorXd step = normal.ldlt().solve(jacobian.transpose() * residual);
    const Pose next = stepped(skeleton, result.pose, moving, step, limits);
    std::vector<Affine> next_model = compute_model_transforms(skeleton, next);
    const double next_distance = largest_distance(next_model, goals);
    if (next_distance < distance) {
      result.pose = next;
      model = std::move(next_model);
      distance = next_distance;
      damping = std::max(1e-4, 0.5 * damping);
    } else {
      damping *= 4.0;
      if (damping > 1e3) break;
    }
  }
  for (const ReachGoal& goal : goals) {
    if (!goal.rotation) continue;
    const Quat now = compute_model_rotations(skeleton, result.pose)[at(goal.joint)];
    result.pose = turn_joint(skeleton, result.pose, goal.joint, *goal.rotation * now.conjugate());
  }
  int worst = 0;
  result.distance = largest_distance(model, goals, &worst);
  if (result.distance > 1e-3 * skeleton.extent())
    result.status = printable(skeleton.name(worst)) + " cannot reach that far";
  return result;
}

std::vector<int> limb_above(const Skeleton& skeleton, const HumanoidMap& humanoid, int joint, int most) {
  const auto is_limb_root = [&](int j) {
    const std::optional<HumanoidBone> bone = humanoid.bone_of(j);
    using B = HumanoidBone;
    return bone == B::leftUpperArm || bone == B::rightUpperArm || bone == B::leftUpperLeg || bone == B::rightUpperLeg ||
           bone == B::spine;
  };
  const bool humanoid_body = humanoid.is_humanoid();
  std::vector<int> limb;
  for (int j = skeleton.parent(joint); j >= 0 && !skeleton.joint(j).helper; j = skeleton.parent(j)) {
    if (humanoid_body && humanoid.bone_of(j) == HumanoidBone::hips) break;
    limb.push_back(j);
    if (humanoid_body ? is_limb_root(j) : std::ssize(limb) >= most) break;
  }
  std::reverse(limb.begin(), limb.end());
  return limb;
}

}  // namespace croquis
