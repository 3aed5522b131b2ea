// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include "croquis/io/gltf_edit.h"
#include "croquis/project/character.h"

namespace croquis {

/// Makes a VRM 1.0 of a document that is no VRM yet: the extension VRMC_vrm with humanoid and meta. Throws unsupported,
/// naming the bones, if the humanoid lacks one that VRM requires.
void add_vrm_extension(GltfEditor& editor, const Character& character, const std::vector<int>& node_of_joint);

/// A VRM animation: the humanoid's nodes at rest (turned to face +Z), and as animation the pose, or the character's
/// clips if the pose is its start. Whatever moves other joints is carried over to the humanoid bones below them; only
/// the hips move, the others turn. Throws unsupported for what is no humanoid.
[[nodiscard]] WrittenFile write_vrma(const Character& character, const Pose& pose);

}  // namespace croquis
