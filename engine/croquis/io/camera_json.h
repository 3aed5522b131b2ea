// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "croquis/math/camera.h"

namespace croquis {

/// A camera file as docs/conventions.md describes it. Throws Error{bad_file} with the JSON pointer and what was wanted;
/// a field that is not known is an error too, with the nearest known one.
[[nodiscard]] Camera read_camera(std::span<const std::byte> bytes);
[[nodiscard]] std::string write_camera(const Camera& camera);

}  // namespace croquis
