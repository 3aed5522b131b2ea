// SPDX-License-Identifier: MIT
#pragma once

#include "croquis/body/body.h"

namespace croquis {

/// A cat that stands on four paws, joints named front_left_upper, hind_right_foot, tail_3, ... Of the proportions,
/// limbs are the legs, hands the paws, shoulders and hips how wide it stands.
[[nodiscard]] Character make_cat(const Proportions& proportions);

/// A snake stretched along Z. Its root is the middle of the body, so that either end can be raised while the other
/// stays: spine_01 ... head lead forward, tail_01 ... backward. Limbs is its length, muscle its thickness.
[[nodiscard]] Character make_snake(const Proportions& proportions);

}  // namespace croquis
