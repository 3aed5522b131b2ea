// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "croquis/project/character.h"

namespace croquis {

/// A chunk that is neither JSON nor BIN, kept as it was.
struct GlbChunk {
  std::uint32_t type = 0;
  std::span<const std::byte> bytes;
};

/// A GLB taken apart; the views point into the file's bytes.
struct GlbContainer {
  std::string_view json;
  std::span<const std::byte> binary;  ///< of the BIN chunk, with its padding; empty if there is none
  bool has_binary = false;
  std::vector<GlbChunk> others;  ///< chunks of other types, in file order
};

/// True if the bytes start with "glTF".
[[nodiscard]] bool is_glb(std::span<const std::byte> bytes);

/// Throws bad_file (with the byte) for anything that is not a whole GLB of version 2; unsupported for version 1.
/// Source: gltf2, section 4 "GLB File Format Specification".
[[nodiscard]] GlbContainer parse_glb(std::span<const std::byte> bytes);

/// The GLB of a JSON text, a BIN chunk (left out if empty) and further chunks. Throws unsupported above 4 GiB.
[[nodiscard]] Bytes make_glb(std::string_view json, std::span<const std::byte> binary,
                             std::span<const GlbChunk> others = {});

}  // namespace croquis
