// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <vector>

#include "croquis/io/gltf_edit.h"
#include "croquis/project/character.h"

namespace croquis {

/// Adds clips to a document as animations. Key times shared between curves are written once.
class ClipWriter {
 public:
  /// `node_of_joint` and `node_of_part`: -1 for what has no node (its curves are left out).
  ClipWriter(GltfEditor& editor, std::vector<int> node_of_joint, std::vector<int> node_of_part)
      : editor_(editor), node_of_joint_(std::move(node_of_joint)), node_of_part_(std::move(node_of_part)) {}

  /// A clip without a curve that can be written is left out, as glTF has no empty animation.
  void add(const Clip& clip);

 private:
  int add_times(const std::vector<double>& times, double shift);

  GltfEditor& editor_;
  std::vector<int> node_of_joint_, node_of_part_;
  std::map<std::vector<float>, int> accessor_of_times_;
};

/// The one-frame clip of a pose: the rotation of every joint that is no helper, and whatever else differs from `rest`.
[[nodiscard]] Clip make_pose_clip(const Skeleton& skeleton, const Pose& rest, const Pose& pose, std::string name);

/// "pose", or "pose 2", ... if clips of that name are there.
[[nodiscard]] std::string free_clip_name(const std::vector<Clip>& clips);

/// True if two transforms differ by more than rounding; quaternions of opposite signs are the same rotation.
[[nodiscard]] bool is_moved(const Vec3& a, const Vec3& b);
[[nodiscard]] bool is_turned(const Quat& a, const Quat& b);
[[nodiscard]] bool is_changed(const Transform& a, const Transform& b);

}  // namespace croquis
