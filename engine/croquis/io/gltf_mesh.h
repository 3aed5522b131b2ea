// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "croquis/io/gltf_skeleton.h"
#include "croquis/project/character.h"

namespace croquis {

/// Where a part of a character stands in its file.
struct PartPlace {
  int node = 0;
  int mesh = 0;
  int primitive = 0;
};

/// Every primitive with triangles of every mesh that the scene shows, in the order of the character's parts.
[[nodiscard]] std::vector<PartPlace> list_parts(const GltfDocument& document, const GltfNodes& nodes);

/// The triangles of a primitive, and which elements of its accessors are the part's vertices: all of them, or, where
/// the primitive uses less than half (several primitives then share one big accessor), those that it uses.
struct PrimitiveTopology {
  std::vector<std::uint32_t> elements;   ///< part vertex -> accessor element, ascending
  std::vector<std::uint32_t> triangles;  ///< three part vertices each
};
[[nodiscard]] PrimitiveTopology read_topology(const GltfDocument& document, const JsonPlace& primitive);

/// All parts; throws bad_file or unsupported with the place. What is only odd goes to `oddities`.
[[nodiscard]] std::vector<Part> read_parts(const GltfDocument& document, const GltfNodes& nodes,
                                           const JointChoice& choice, std::vector<std::string>& oddities);

}  // namespace croquis
