// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

#include "croquis/io/character_file.h"

namespace croquis {

/// True for a GLB that carries the extension CROQUIS_project. Throws bad_file for a broken GLB.
[[nodiscard]] bool is_project(std::span<const std::byte> bytes);

/// The first character of a project, starting in the pose it was left in. Throws bad_file if there is none.
[[nodiscard]] Character read_first_actor(std::span<const std::byte> bytes, std::string_view file_name);

}  // namespace croquis
