// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "croquis/io/gltf_edit.h"
#include "croquis/io/gltf_nodes.h"

namespace croquis {

/// Replaces the vertices of every part of a document by the baked ones, takes the skins off the nodes and sets all
/// shape weights to 0. A mesh that several nodes show is copied for each of them. Throws invalid_argument unless there
/// is one baked part per part of the character, of its size; unsupported for a node that is scaled to nothing.
void bake_parts(GltfEditor& editor, const GltfDocument& document, const GltfNodes& nodes, const Character& character,
                const std::vector<BakedPart>& baked);

/// Throws invalid_argument unless the baked parts fit the character's.
void check_baked(const Character& character, const std::vector<BakedPart>& baked);

}  // namespace croquis
