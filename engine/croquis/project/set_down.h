// SPDX-License-Identifier: MIT
#pragma once

#include "croquis/project/character.h"

namespace croquis {

/// The same character set down elsewhere: its root, at rest and as it starts, moved by `shift` in model space. What it
/// is reset to, and the poses that it takes, are there too.
[[nodiscard]] Character set_down(Character character, const Vec3& shift);

}  // namespace croquis
