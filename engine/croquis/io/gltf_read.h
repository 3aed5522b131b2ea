// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

#include "croquis/io/character_file.h"

namespace croquis {

/// The character of a .gltf, .glb, .vrm or .vrma. One part per primitive; rest pose and start pose are the nodes' own
/// transforms, the bind pose is in the skins. See read_character for what it throws.
[[nodiscard]] Character read_gltf(std::span<const std::byte> bytes, std::string_view file_name,
                                  const ResourceReader& resources);

}  // namespace croquis
