// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "croquis/io/gltf_edit.h"
#include "croquis/project/character.h"

namespace croquis {

/// Adds materials and their images to a document, each once.
class MaterialBuilder {
 public:
  explicit MaterialBuilder(GltfEditor& editor) : editor_(editor) {}

  /// The index of the material in the document.
  int add(const Material& material);

 private:
  int add_texture(const std::shared_ptr<const Bytes>& image);

  GltfEditor& editor_;
  std::vector<std::pair<Material, int>> materials_;
  std::map<std::shared_ptr<const Bytes>, int> textures_;
};

}  // namespace croquis
