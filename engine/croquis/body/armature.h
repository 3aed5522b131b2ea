// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "croquis/rig/skeleton.h"

namespace croquis {

/// Joints placed in model space, one by one or as left/right pairs: the draft of a Skeleton whose rest rotations are
/// all the identity.
class Armature {
 public:
  /// Adds a joint on the plane x = 0 or on one side only; `parent` is an index given by an earlier call, -1 for the
  /// root.
  int add(std::string name, int parent, const Vec3& position);
  /// Adds a joint on the left (x > 0), whose name has "left" in it, and its mirror image, "right"; returns the left
  /// one.
  int add_pair(const std::string& left_name, int parent, const Vec3& position);

  [[nodiscard]] const Vec3& position(int joint) const { return positions_[static_cast<std::size_t>(joint)]; }
  /// joint -> its mirror image; a joint of the middle is its own.
  [[nodiscard]] const std::vector<int>& mirror() const { return mirror_; }
  [[nodiscard]] int find(std::string_view name) const;  ///< throws invalid_argument if there is none
  [[nodiscard]] Skeleton skeleton() const;

 private:
  std::vector<std::string> names_;
  std::vector<int> parents_, mirror_;
  std::vector<Vec3> positions_;
};

}  // namespace croquis
