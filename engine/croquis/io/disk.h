// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <span>

#include "croquis/io/character_file.h"

namespace croquis {

/// The whole file; throws Error{io} naming it, also if it is a folder or larger than 2 GiB.
[[nodiscard]] Bytes read_file(const std::filesystem::path& path);

/// Writes to a temporary file beside `path` and renames it, so that a failed write leaves an old file whole and no
/// half-written one. Throws Error{io}.
void write_file(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// A ResourceReader for the files beside `path`; refuses URIs that lead out of its folder.
[[nodiscard]] ResourceReader resources_beside(const std::filesystem::path& path);

}  // namespace croquis
