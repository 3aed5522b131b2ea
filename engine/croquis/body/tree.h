// SPDX-License-Identifier: MIT
#pragma once

#include "croquis/body/body.h"

namespace croquis {

/// A broad-leaved tree: trunk_1 ... trunk_6 up the trunk, branch_1_1 ... for its boughs, and a crown of leaves as a
/// part of its own. Limbs is the length of the boughs, head the size of the crown, muscle the thickness of the wood.
[[nodiscard]] Character make_tree(const Proportions& proportions);

}  // namespace croquis
