// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace croquis {

/// "knight" of "models/knight.glb".
[[nodiscard]] std::string file_stem(std::string_view file_name);

/// The extension, lower-cased, without the dot: "glb" of "a/b.GLB"; empty if there is none. (See character_file.h.)
[[nodiscard]] std::string file_format(std::string_view file_name);

}  // namespace croquis
