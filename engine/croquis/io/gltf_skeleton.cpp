// SPDX-License-Identifier: MIT
#include "croquis/io/gltf_skeleton.h"

#include <algorithm>
#include <set>

namespace croquis {
namespace {

constexpr int kMostJoints = 65535;

enum class Role : char { none, helper, joint };

class Chooser {
 public:
  Chooser(const GltfDocument& document, const GltfNodes& nodes)
      : document_(document), nodes_(nodes), roles_(static_cast<std::size_t>(nodes.size()), Role::none) {}

  [[nodiscard]] Role& role(int node) { return roles_[static_cast<std::size_t>(node)]; }

  std::vector<int> take_skins() {
    std::set<int> skins;
    for (const GltfNode& node : nodes_.nodes) {
      if (node.in_scene && node.mesh >= 0 && node.skin >= 0) skins.insert(node.skin);
    }
    // A rig without a mesh: its skins say what is a joint all the same.
    if (skins.empty()) {
      for (int i = 0; i < document_.count("skins"); ++i) skins.insert(i);
    }
    for (const int skin : skins) {
      for (const int node : read_skin_joints(document_, skin)) role(node) = Role::joint;
    }
    return {skins.begin(), skins.end()};
  }

  /// Animated nodes, or else all.
  void take_tree(const std::vector<bool>& animated) {
    bool any = false;
    for (int i = 0; i < nodes_.size(); ++i) {
      if (!animated[static_cast<std::size_t>(i)] || !nodes_[i].in_scene) continue;
      role(i) = Role::joint;
      any = true;
    }
    const bool anything_shown = !nodes_.scene_roots.empty();
    for (int i = 0; !any && i < nodes_.size(); ++i) {
      if (nodes_[i].in_scene || !anything_shown) role(i) = Role::joint;
    }
  }

  void take_animated_carriers(const std::vector<bool>& animated) {
    std::vector<bool> carries(roles_.size(), false);
    for (auto it = nodes_.order.rbegin(); it != nodes_.order.rend(); ++it) {
      const GltfNode& node = nodes_[*it];
      const auto index = static_cast<std::size_t>(*it);
      if (node.in_scene && node.mesh >= 0 && node.skin < 0) carries[index] = true;
      if (carries[index] && node.parent >= 0) carries[static_cast<std::size_t>(node.parent)] = true;
      if (carries[index] && animated[index] && roles_[index] == Role::none) roles_[index] = Role::helper;
    }
  }

  void take_ancestors() {
    for (auto it = nodes_.order.rbegin(); it != nodes_.order.rend(); ++it) {
      const int parent = nodes_[*it].parent;
      if (role(*it) != Role::none && parent >= 0 && role(parent) == Role::none) role(parent) = Role::helper;
    }
  }

  /// Whether one more joint above the others is needed.
  [[nodiscard]] bool needs_root() {
    int roots = 0;
    for (const int node : nodes_.order) {
      const GltfNode& n = nodes_[node];
      if (role(node) != Role::none && n.parent < 0) ++roots;
    }
    if (roots != 1) return true;
    std::vector<bool> under_joint(roles_.size(), false);
    for (const int node : nodes_.order) {
      const GltfNode& n = nodes_[node];
      const bool under = role(node) != Role::none || (n.parent >= 0 && under_joint[static_cast<std::size_t>(n.parent)]);
      under_joint[static_cast<std::size_t>(node)] = under;
      if (!under && n.in_scene && n.mesh >= 0 && n.skin < 0) return true;
    }
    return false;
  }

 private:
  const GltfDocument& document_;
  const GltfNodes& nodes_;
  std::vector<Role> roles_;
};

}  // namespace

JointChoice choose_joints(const GltfDocument& document, const GltfNodes& nodes, std::span<const int> humanoid_nodes) {
  Chooser chooser(document, nodes);
  const std::vector<bool> animated = find_animated_nodes(document);
  JointChoice choice;
  choice.skins = chooser.take_skins();
  for (const int node : humanoid_nodes) chooser.role(node) = Role::joint;
  if (choice.skins.empty() && humanoid_nodes.empty()) chooser.take_tree(animated);
  chooser.take_animated_carriers(animated);
  chooser.take_ancestors();

  choice.joint_of_node.assign(static_cast<std::size_t>(nodes.size()), -1);
  if (chooser.needs_root()) {
    choice.node_of_joint.push_back(-1);
    choice.is_helper.push_back(true);
  }
  for (const int node : nodes.order) {
    if (chooser.role(node) == Role::none) continue;
    choice.joint_of_node[static_cast<std::size_t>(node)] = static_cast<int>(choice.node_of_joint.size());
    choice.node_of_joint.push_back(node);
    choice.is_helper.push_back(chooser.role(node) == Role::helper);
  }
  if (std::ssize(choice.node_of_joint) > kMostJoints) {
    document.root()["nodes"].fail("more than " + std::to_string(kMostJoints) + " joints");
  }
  return choice;
}

std::vector<int> read_skin_joints(const GltfDocument& document, int skin) {
  const JsonPlace joints = document.element("skins", skin)["joints"];
  if (joints.size() == 0) joints.fail("wanted at least one joint");
  if (joints.size() > kMostJoints) joints.fail("more than " + std::to_string(kMostJoints) + " joints");
  std::vector<int> nodes;
  for (int i = 0; i < joints.size(); ++i) nodes.push_back(joints[i].index(document.count("nodes"), "node"));
  return nodes;
}

std::vector<bool> find_animated_nodes(const GltfDocument& document) {
  const int count = document.count("nodes");
  std::vector<bool> animated(static_cast<std::size_t>(count), false);
  for (int i = 0; i < document.count("animations"); ++i) {
    const JsonPlace channels = document.element("animations", i)["channels"];
    for (int c = 0; c < channels.size(); ++c) {
      const JsonPlace target = channels[c]["target"];
      const int node = target["node"].index_or_none(count, "node");
      const std::string path = target["path"].text();
      if (node >= 0 && (path == "translation" || path == "rotation" || path == "scale")) {
        animated[static_cast<std::size_t>(node)] = true;
      }
    }
  }
  return animated;
}

Skeleton make_skeleton(const GltfDocument& document, const GltfNodes& nodes, const JointChoice& choice) {
  std::vector<Joint> joints;
  for (std::size_t i = 0; i < choice.node_of_joint.size(); ++i) {
    const int node = choice.node_of_joint[i];
    if (node < 0) {
      joints.push_back({.name = "scene", .helper = true});
      continue;
    }
    const int parent_node = nodes[node].parent;
    const int parent = parent_node >= 0 ? choice.joint_of_node[static_cast<std::size_t>(parent_node)] : i > 0 ? 0 : -1;
    joints.push_back({.name = document.element("nodes", node)["name"].text_or(""),
                      .parent = parent,
                      .rest = nodes[node].local,
                      .helper = choice.is_helper[i]});
  }
  Skeleton skeleton(std::move(joints));
  for (int i = 0; i < skeleton.joint_count(); ++i) {
    if (!skeleton.rest_model(i).matrix().allFinite()) {
      document.element("nodes", choice.node_of_joint[static_cast<std::size_t>(i)]).fail("stands at infinity");
    }
  }
  return skeleton;
}

JointAbove find_joint_above(const GltfNodes& nodes, const JointChoice& choice, int node) {
  JointAbove above;
  for (int i = node; i >= 0; i = nodes[i].parent) {
    const int joint = choice.joint_of_node[static_cast<std::size_t>(i)];
    if (joint >= 0) {
      above.joint = joint;
      return above;
    }
    above.joint_from_node = nodes[i].matrix * above.joint_from_node;
  }
  return above;
}

}  // namespace croquis
