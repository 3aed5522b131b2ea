// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "croquis/io/gltf_nodes.h"
#include "croquis/rig/skeleton.h"

namespace croquis {

/// Which nodes of a file are the joints of its character.
struct JointChoice {
  std::vector<int> node_of_joint;  ///< -1 for a root that was put above several
  std::vector<int> joint_of_node;  ///< -1 for a node that is no joint
  std::vector<bool> is_helper;     ///< per joint
  std::vector<int> skins;          ///< the skins whose joints were taken
};

/// The joints are the joints of the skins in use and the humanoid's nodes; without either the animated nodes; without
/// these every node. All their ancestors come along as helpers, and so do animated nodes that carry rigid meshes.
/// Joints stand in the file's depth-first order. Where that gives several roots, or a mesh hangs on none of them, one
/// more helper, "scene", stands above all.
[[nodiscard]] JointChoice choose_joints(const GltfDocument& document, const GltfNodes& nodes,
                                        std::span<const int> humanoid_nodes);

/// The joints of a skin, as nodes. Throws bad_file.
[[nodiscard]] std::vector<int> read_skin_joints(const GltfDocument& document, int skin);

/// The nodes whose translation, rotation or scale an animation moves; one flag per node.
[[nodiscard]] std::vector<bool> find_animated_nodes(const GltfDocument& document);

[[nodiscard]] Skeleton make_skeleton(const GltfDocument& document, const GltfNodes& nodes, const JointChoice& choice);

/// The nearest joint at or above a node, and joint_from_node with everything between them; joint 0 if there is none.
struct JointAbove {
  int joint = 0;
  Affine joint_from_node = Affine::Identity();
};
[[nodiscard]] JointAbove find_joint_above(const GltfNodes& nodes, const JointChoice& choice, int node);

}  // namespace croquis
