// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <vector>

#include "croquis/io/json_place.h"
#include "croquis/project/project.h"

namespace croquis {

/// The joints of a character by the nodes of the file that it is kept as: of a glTF its nodes, else the joints
/// themselves.
class JointNodes {
 public:
  explicit JointNodes(const Character& character);

  [[nodiscard]] int node(int joint) const { return nodes_[static_cast<std::size_t>(joint)]; }
  [[nodiscard]] const std::vector<int>& nodes() const { return nodes_; }
  /// Throws bad_file if no joint of this character is that node.
  [[nodiscard]] int joint(const JsonPlace& node) const;

 private:
  std::vector<int> nodes_;
  std::map<int, int> joint_of_node_;
};

/// The pieces of a project as JSON and back; every read_ throws bad_file with the JSON pointer. A pose names each node
/// with its translation, rotation xyzw and scale; joints that it does not name stay as in `start`.
[[nodiscard]] Json write_pose(const Pose& pose, const JointNodes& nodes);
[[nodiscard]] Pose read_pose(const JsonPlace& place, const JointNodes& nodes, const Pose& start);

[[nodiscard]] Json write_pin(const Pin& pin, const JointNodes& nodes);
[[nodiscard]] Pin read_pin(const JsonPlace& place, const JointNodes& nodes);

[[nodiscard]] Json write_stroke(const PlacedStroke& stroke, const JointNodes& nodes);
/// Leaves `actor` to the caller.
[[nodiscard]] PlacedStroke read_stroke(const JsonPlace& place, const JointNodes& nodes, const Pose& start);

[[nodiscard]] Json write_table_settings(const TableSettings& settings);
[[nodiscard]] TableSettings read_table_settings(const JsonPlace& place);

/// A camera in the form of a camera file (see camera_json.h).
[[nodiscard]] Json write_camera_place(const Camera& camera);
[[nodiscard]] Camera read_camera_place(const JsonPlace& place);

}  // namespace croquis
