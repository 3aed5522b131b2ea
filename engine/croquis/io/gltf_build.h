// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "croquis/io/gltf_edit.h"
#include "croquis/project/character.h"

namespace croquis {

/// The nodes that a character got in a document.
struct BuiltCharacter {
  std::vector<int> node_of_joint;
  std::vector<int> node_of_part;  ///< -1 for a part without triangles
  std::vector<int> scene_roots;
};

/// Puts a character into a document: its joints as nodes standing as `pose` says (in the skeleton's order, one after
/// the other), its parts as meshes with skins, shapes and materials, and no clips. With `baked` the parts stand bent,
/// without skins. Names, joint order and all that a Character holds come back when the document is read.
[[nodiscard]] BuiltCharacter build_character(GltfEditor& editor, const Character& character, const Pose& pose,
                                             const std::vector<BakedPart>* baked = nullptr);

}  // namespace croquis
