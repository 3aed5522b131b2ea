// SPDX-License-Identifier: MIT
// Source: gltf2, section 3.5 "Scenes".
#include "croquis/io/gltf_nodes.h"

#include <algorithm>
#include <cmath>

namespace croquis {
namespace {

void read_transform(const JsonPlace& place, GltfNode& node) {
  const JsonPlace matrix = place["matrix"];
  if (matrix.exists()) {
    const std::vector<double> m = matrix.numbers(16);
    node.matrix.matrix() = Eigen::Map<const Mat4>(m.data());  // column-major, as Eigen's
    node.matrix.makeAffine();
    node.local = decompose(node.matrix, &node.shear);
    if (!node.local.is_finite()) matrix.fail("its numbers are too large");
    return;
  }
  if (const JsonPlace translation = place["translation"]; translation.exists()) {
    node.local.translation = Vec3(translation.numbers(3).data());
  }
  if (const JsonPlace rotation = place["rotation"]; rotation.exists()) {
    const Vec4 xyzw(rotation.numbers(4).data());
    const double length = xyzw.stableNorm();
    if (!(length > 1e-6) || !std::isfinite(length)) rotation.fail("wanted a unit quaternion");
    node.local.rotation = Quat(Vec4(xyzw / length));
  }
  if (const JsonPlace scale = place["scale"]; scale.exists()) node.local.scale = Vec3(scale.numbers(3).data());
  node.matrix = node.local.to_affine();
}

void read_node(const GltfDocument& document, int index, GltfNodes& nodes) {
  const JsonPlace place = document.element("nodes", index);
  if (!place.is_object()) place.fail("wanted an object");
  GltfNode& node = nodes[index];
  read_transform(place, node);
  node.mesh = place["mesh"].index_or_none(document.count("meshes"), "mesh");
  node.skin = place["skin"].index_or_none(document.count("skins"), "skin");
  const JsonPlace children = place["children"];
  for (int i = 0; i < children.size(); ++i) {
    const int child = children[i].index(nodes.size(), "node");
    if (nodes[child].parent >= 0) {
      children[i].fail("node " + std::to_string(child) + " is a child of node " + std::to_string(nodes[child].parent) +
                       " already");
    }
    nodes[child].parent = index;
    node.children.push_back(child);
  }
}

/// Appends the tree under `root` to the order, depth first, children in the file's order.
void append_tree(int root, bool in_scene, GltfNodes& nodes) {
  std::vector<int> open = {root};
  while (!open.empty()) {
    const int index = open.back();
    open.pop_back();
    nodes.order.push_back(index);
    nodes[index].in_scene = in_scene;
    open.insert(open.end(), nodes[index].children.rbegin(), nodes[index].children.rend());
  }
}

void read_scene(const GltfDocument& document, GltfNodes& nodes) {
  const int scenes = document.count("scenes");
  const JsonPlace chosen = document.root()["scene"];
  nodes.scene = chosen.exists() ? chosen.index(scenes, "scene") : scenes > 0 ? 0 : -1;
  if (nodes.scene < 0) return;
  const JsonPlace roots = document.element("scenes", nodes.scene)["nodes"];
  std::vector<bool> seen(nodes.nodes.size(), false);
  for (int i = 0; i < roots.size(); ++i) {
    const int root = roots[i].index(nodes.size(), "node");
    if (nodes[root].parent >= 0) roots[i].fail("node " + std::to_string(root) + " is no root");
    if (seen[static_cast<std::size_t>(root)]) roots[i].fail("node " + std::to_string(root) + " stands here twice");
    seen[static_cast<std::size_t>(root)] = true;
    nodes.scene_roots.push_back(root);
  }
}

}  // namespace

GltfNodes read_nodes(const GltfDocument& document) {
  GltfNodes nodes;
  const int count = document.count("nodes");
  const JsonPlace place = document.root()["nodes"];
  document.budget.take(static_cast<std::uint64_t>(count), sizeof(GltfNode), place);
  nodes.nodes.resize(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) read_node(document, i, nodes);
  read_scene(document, nodes);

  std::vector<bool> is_scene_root(static_cast<std::size_t>(count), false);
  for (const int root : nodes.scene_roots) {
    is_scene_root[static_cast<std::size_t>(root)] = true;
    append_tree(root, true, nodes);
  }
  for (int i = 0; i < count; ++i) {
    if (nodes[i].parent >= 0 || is_scene_root[static_cast<std::size_t>(i)]) continue;
    if (nodes.scene < 0) nodes.scene_roots.push_back(i);
    append_tree(i, nodes.scene < 0, nodes);
  }
  if (std::ssize(nodes.order) != count) {
    // Every node has at most one parent: what no root reaches runs in a circle.
    std::vector<bool> reached(static_cast<std::size_t>(count), false);
    for (const int index : nodes.order) reached[static_cast<std::size_t>(index)] = true;
    const auto lost = std::find(reached.begin(), reached.end(), false) - reached.begin();
    place[static_cast<int>(lost)].fail("the nodes run in a circle");
  }
  return nodes;
}

}  // namespace croquis
