// SPDX-License-Identifier: MIT
// What every reader must do with any bytes: end in a value that holds its promises, or in an Error that blames the
// file. Both the fuzzers and the ordinary test that replays their corpus call these; they throw std::logic_error where
// a promise is broken.
#pragma once

#include <cstddef>
#include <span>

namespace croquis {

bool fuzz_bvh(std::span<const std::byte> bytes);     ///< read, and written again if it could be read
bool fuzz_camera(std::span<const std::byte> bytes);  ///< read, written and read again, it is the same camera
bool fuzz_gltf(std::span<const std::byte> bytes);    ///< any character file but BVH: glTF, GLB, VRM, OBJ
bool fuzz_svg(std::span<const std::byte> bytes);     ///< read, written, read again

}  // namespace croquis
