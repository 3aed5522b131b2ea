// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "croquis/io/gltf_document.h"

namespace croquis {

/// Reads what a picture needs of the materials; each image is read once and shared.
class MaterialReader {
 public:
  explicit MaterialReader(const GltfDocument& document) : document_(document) {}

  /// `uv_set` receives the n of TEXCOORD_n that the base colour image is laid on by. Throws bad_file.
  [[nodiscard]] Material read(int material, int& uv_set);
  void report(std::vector<std::string>& oddities) const;

 private:
  [[nodiscard]] std::shared_ptr<const Bytes> image_of_texture(int texture);

  const GltfDocument& document_;
  std::map<int, std::shared_ptr<const Bytes>> images_;
  std::set<std::string> unreadable_;  ///< media types that a picture cannot show
};

}  // namespace croquis
