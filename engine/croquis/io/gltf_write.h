// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "croquis/io/character_file.h"

namespace croquis {

/// A character that was read from a glTF, written as "glb", "gltf" or "vrm": its own document with what was changed.
/// A node whose joint stands as the file has it is left alone; of any other the members that differ are replaced
/// (a matrix by translation, rotation and scale). See write_character for the rest.
[[nodiscard]] WrittenFile write_gltf_source(const Character& character, const Pose& pose, std::string_view format,
                                            std::string_view file_name, const WriteOptions& options);

/// Any character as a new glTF document of the same formats: joint i is node i, then come the nodes of the parts.
[[nodiscard]] WrittenFile write_new_gltf(const Character& character, const Pose& pose, std::string_view format,
                                         std::string_view file_name, const WriteOptions& options);

}  // namespace croquis
