// SPDX-License-Identifier: MIT
#pragma once

#include "croquis/project/character.h"

namespace croquis {

/// The same character with its joints in the order in which files give them: each joint is followed by all that hangs
/// on it, siblings as they stood. Indices of joints, and what is chosen by them, then mean the same before and after
/// the character has been through a file. For characters without a source file; throws invalid_argument for others.
[[nodiscard]] Character in_file_order(Character character);

}  // namespace croquis
