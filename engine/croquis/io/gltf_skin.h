// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "croquis/io/gltf_skeleton.h"
#include "croquis/mesh/skin.h"

namespace croquis {

/// Reads skins: their joints and inverse bind matrices (once per skin), and the weights of each primitive.
class SkinReader {
 public:
  SkinReader(const GltfDocument& document, const JointChoice& choice) : document_(document), choice_(choice) {}

  /// The skin of a primitive's part; nothing if the primitive has no JOINTS_0. `elements` are the accessor elements
  /// that are the part's vertices, `count` what POSITION has. Weights come out normalised. Throws bad_file that names
  /// the accessor for a weight that is negative or not finite and for a joint outside the skin.
  [[nodiscard]] std::optional<Skin> read(int skin, const JsonPlace& attributes,
                                         const std::vector<std::uint32_t>& elements, int count);
  /// What was odd in all that was read.
  void report(std::vector<std::string>& oddities) const;

 private:
  struct Palette {
    std::vector<int> joints;
    std::vector<Affine> inverse_bind;
  };
  const Palette& palette(int skin);

  const GltfDocument& document_;
  const JointChoice& choice_;
  std::map<int, Palette> palettes_;
  int not_normalised_ = 0;
  int without_weight_ = 0;
};

}  // namespace croquis
