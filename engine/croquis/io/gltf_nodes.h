// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "croquis/io/gltf_document.h"
#include "croquis/math/transform.h"

namespace croquis {

/// One node of a glTF file.
struct GltfNode {
  int parent = -1;
  std::vector<int> children;
  Transform local;                     ///< parent_from_node; of a matrix the nearest TRS
  Affine matrix = Affine::Identity();  ///< parent_from_node exactly
  double shear = 0.0;                  ///< what `local` cannot hold of a matrix (see decompose)
  bool in_scene = false;               ///< reached from the scene that is shown
  int mesh = -1;
  int skin = -1;
};

/// The nodes of a glTF file, known to be a forest. The scene that is shown is the file's default one, else its first,
/// else (no scenes at all) everything.
struct GltfNodes {
  std::vector<GltfNode> nodes;
  std::vector<int> order;        ///< every node, parents before children: depth first, the shown scene's roots first
  std::vector<int> scene_roots;  ///< of the scene that is shown
  int scene = -1;                ///< its index; -1 where the file has no scenes

  [[nodiscard]] int size() const { return static_cast<int>(nodes.size()); }
  [[nodiscard]] const GltfNode& operator[](int index) const { return nodes[static_cast<std::size_t>(index)]; }
  [[nodiscard]] GltfNode& operator[](int index) { return nodes[static_cast<std::size_t>(index)]; }
};

/// Throws bad_file with the place for cycles, nodes with two parents, indices that are not there and numbers that are
/// not finite.
[[nodiscard]] GltfNodes read_nodes(const GltfDocument& document);

}  // namespace croquis
