// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "croquis/io/gltf_edit.h"
#include "croquis/project/character.h"

namespace croquis {

/// Adds skins to a document, equal ones once. The first holds every joint of the character that is no helper, so that
/// a reader sees as joints what Croquis does.
class SkinBuilder {
 public:
  SkinBuilder(GltfEditor& editor, const Character& character) : editor_(editor), character_(character) {}

  int add(const Skin& skin, const std::vector<int>& node_of_joint);
  /// For a character without any skinned part: a skin that no mesh uses, if it has more than one bone.
  void add_bones(const std::vector<int>& node_of_joint);
  [[nodiscard]] bool any() const { return !skins_.empty(); }

 private:
  int add_palette(const std::vector<int>& joints, const std::vector<Affine>& inverse_bind,
                  const std::vector<int>& node_of_joint);

  GltfEditor& editor_;
  const Character& character_;
  std::vector<std::pair<const Skin*, int>> skins_;
};

/// JOINTS_n and WEIGHTS_n of a skin: no joint twice on a vertex, weights that sum to 1.
void add_skin_attributes(GltfEditor& editor, const Skin& skin, Json& attributes);

}  // namespace croquis
