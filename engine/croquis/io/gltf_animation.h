// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "croquis/anim/clip.h"
#include "croquis/io/gltf_mesh.h"

namespace croquis {

/// One clip per animation of the file, in its order. Curves of joints keep their joint's index; a curve of shape
/// weights stands once for each part of its mesh. What moves no joint and no shape is left out. Throws bad_file.
[[nodiscard]] std::vector<Clip> read_clips(const GltfDocument& document, const JointChoice& choice,
                                           const std::vector<PartPlace>& parts, std::vector<std::string>& oddities);

}  // namespace croquis
