// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

#include "croquis/project/character.h"

namespace croquis {

/// The character of a Wavefront OBJ: its whole mesh hung rigidly on one joint at the origin. Positions, texture
/// coordinates (v turned down, as everywhere in Croquis), normals and faces are read, polygons as fans, one part per
/// object or group that has faces; materials, lines and curves are not. Throws bad_file with the line.
[[nodiscard]] Character read_obj(std::span<const std::byte> bytes, std::string_view file_name);

}  // namespace croquis
