// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <vector>

#include "croquis/posing/joint_roles.h"
#include "croquis/posing/line_problem.h"
#include "croquis/posing/line_solver.h"

namespace croquis {

/// A LineProblem with the way back to the skeleton that it came from.
class LineScene {
 public:
  /// Every stroke is taken to start at its line's first joint. Throws as solve_lines does.
  LineScene(const Skeleton& skeleton, const HumanoidMap& humanoid, const Pose& start,
            const std::vector<LineInput>& inputs, const Camera& camera, const LineSolverOptions& options);

  LineProblem problem;

  /// Gives a path another stroke (pixels); reversed: the stroke starts at the line's last joint.
  void set_stroke(std::size_t path, std::span<const Vec2> stroke, bool reversed);
  /// The start pose turned and moved as the state says.
  void write_pose(const LineState& state, Pose& pose) const;
  /// Scene units per problem unit.
  [[nodiscard]] double unit() const { return unit_; }
  [[nodiscard]] int node_of(int joint) const { return node_of_[static_cast<std::size_t>(joint)]; }
  [[nodiscard]] const std::vector<int>& limits_widened() const { return limits_widened_; }
  /// No joint is scaled unevenly: turns alone keep lengths. Otherwise write_pose moves joints along (keep_lengths.h).
  [[nodiscard]] bool scales_evenly() const { return scales_evenly_; }

 private:
  void add_nodes(const std::vector<LineInput>& inputs, const LineSolverOptions& options);
  void add_path(const LineInput& input);
  void set_stiffness(const LinePath& path);
  void heed_prior(const HumanoidMap& humanoid);
  void add_shares(const LinePath& path);
  void add_pins(const std::vector<PosePin>& pins);
  void add_body(const HumanoidMap& humanoid, const LineSolverOptions& options);
  void add_limits(const std::vector<JointLimit>& limits);

  const Skeleton& skeleton_;
  const Pose& start_;
  bool person_ = false;
  std::vector<JointRole> roles_;
  std::vector<Affine> model_;  ///< of the start pose
  std::vector<Mat3> above_;    ///< per node: orthogonal part of what is above the joint, in view axes
  std::vector<std::array<std::vector<double>, 2>>
      heeded_;                ///< importance per path, for the stroke as it is and turned round
  std::vector<int> carrier_;  ///< per joint: its node, or the one that it moves with
  std::vector<int> node_of_;  ///< per joint, -1: not in the problem
  int body_root_ = 0;
  Affine view_ = Affine::Identity();
  double unit_ = 1.0;
  Vec2 pixel_scale_ = Vec2::Ones(), pixel_offset_ = Vec2::Zero();
  LengthPolicy length_ = LengthPolicy::fit;
  bool scales_evenly_ = true;
  std::vector<int> limits_widened_;
};

}  // namespace croquis
