// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "croquis/math/transform.h"

namespace croquis {

/// One joint as it is given to a Skeleton.
struct Joint {
  std::string name;     ///< any UTF-8; may be empty or the same as another's
  int parent = -1;      ///< index of an earlier joint; -1 for the root alone
  Transform rest = {};  ///< parent_from_joint at rest
  /// A node that only carries the others (the scene above an armature, a group): it takes part in the kinematics, but
  /// is no bone to be drawn or selected by default.
  bool helper = false;
};

/// What a body is: a tree of joints with names and a rest pose; immutable. Joint 0 is the only root, and every parent
/// stands before its children, so that one pass in index order is a pass from the root to the leaves. A bone is the
/// straight piece from a joint's parent to the joint. How a body stands is a Pose; how a mesh was bound to it is a
/// Skin (rest pose and bind pose need not agree).
class Skeleton {
 public:
  /// Throws invalid_argument, naming the joint, unless there is at least one joint, joint 0 alone has no parent, each
  /// parent stands before its child and every rest transform is finite.
  explicit Skeleton(std::vector<Joint> joints);

  [[nodiscard]] int joint_count() const { return static_cast<int>(joints_.size()); }
  [[nodiscard]] const Joint& joint(int index) const { return joints_[static_cast<std::size_t>(index)]; }
  [[nodiscard]] const std::vector<Joint>& joints() const { return joints_; }
  [[nodiscard]] int parent(int index) const { return joint(index).parent; }
  [[nodiscard]] const std::string& name(int index) const { return joint(index).name; }
  [[nodiscard]] const std::vector<int>& children(int index) const { return children_[static_cast<std::size_t>(index)]; }
  /// Model space from joint at rest.
  [[nodiscard]] const Affine& rest_model(int index) const { return rest_model_[static_cast<std::size_t>(index)]; }
  [[nodiscard]] Vec3 rest_position(int index) const { return rest_model(index).translation(); }
  /// Size to measure by: the diagonal of the box around the rest positions of the joints that are not helpers; 1 if
  /// that is zero.
  [[nodiscard]] double extent() const { return extent_; }

  [[nodiscard]] bool is_ancestor(int ancestor, int joint) const;  ///< a joint is its own ancestor
  /// The joints from `from` to `to` along the tree, both included.
  [[nodiscard]] std::vector<int> path(int from, int to) const;
  /// All joints with that very name, in index order.
  [[nodiscard]] std::vector<int> find(std::string_view name) const;
  /// The one joint that `reference` means: a name, or "#index". Throws invalid_argument for a name that no joint or
  /// more than one joint has (the text then lists the #indices, or suggests a near name).
  [[nodiscard]] int resolve(std::string_view reference) const;
  /// The name as a person can use it to refer to the joint: the name itself if it is unique, else "#index".
  [[nodiscard]] std::string reference(int index) const;

 private:
  std::vector<Joint> joints_;
  std::vector<std::vector<int>> children_;
  std::vector<Affine> rest_model_;
  double extent_ = 1.0;
};

}  // namespace croquis
