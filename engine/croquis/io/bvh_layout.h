// SPDX-License-Identifier: MIT
#pragma once

#include "croquis/io/bvh_text.h"
#include "croquis/project/character.h"

namespace croquis {

/// The nodes that a character is written as, and the joints that they show.
struct BvhLayout {
  std::vector<BvhNode> nodes;        ///< depth first, as in a file; `first_channel` is set by number_channels
  std::vector<int> joints;           ///< node -> joint; -1 for an End Site that only ends a leaf
  bool positions_are_added = false;  ///< see bvh_positions_are_added
  std::string hierarchy;             ///< the source's own text; empty: to be spelled out
  std::string new_line = "\n";
  std::string frame_time = "0.0333333";
};

/// The layout of the BVH that the character was read from, text included; of any other character one made from its rest
/// pose: world-aligned axes, ZXY, positions on the root alone.
[[nodiscard]] BvhLayout make_bvh_layout(const Character& character);

/// Gives the channels their places in a row; returns how many there are.
int number_channels(BvhLayout& layout);

/// The HIERARCHY of these nodes as text.
[[nodiscard]] std::string spell_bvh_hierarchy(const BvhLayout& layout);

/// "CHANNELS 3 Zrotation Xrotation Yrotation".
[[nodiscard]] std::string spell_bvh_channels(const BvhNode& node);
[[nodiscard]] std::string spell_bvh_vector(const Vec3& vector);

}  // namespace croquis
